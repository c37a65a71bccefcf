/// Divide and conquer on all threads: the topmost cuts, and what becomes of the parts between them.
#include "kernel/divide_and_conquer.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <vector>

#include "kernel/assert.hpp"
#include "kernel/parallel.hpp"
#include "kernel/part_builder.hpp"

namespace thalweg::detail {
namespace {

using Index = std::uint32_t;

/// The topmost cuts, so that threads can share what is between them: pieces of about equal work are built in
/// any order, and the thread that brings the second part of a cut merges the two and goes on with what they
/// become.
class SharedBuild {
 public:
  /// Cuts pieces of at most `most` sites, if more are not in one cell.
  SharedBuild(const PartArrays& arrays, std::span<const Index> keys, Index most)
      : arrays_(arrays), keys_(keys), most_(most) {
    divide(0, static_cast<Index>(keys.size()), {});
    arrivals_ = std::vector<std::atomic<unsigned>>(joints_.size());
  }

  /// Makes one part of all.
  void run(unsigned threads) {
    parallel_chunks(pieces_.size(), 1, threads, [this] {
      return [this](std::size_t begin, std::size_t end) {
        for (const Piece& piece : std::span(pieces_).subspan(begin, end - begin))
          bring(build_part(arrays_, piece.lo, piece.hi, &keys_[piece.lo]), piece.goal);
      };
    });
  }

 private:
  static constexpr std::size_t kNoJoint = static_cast<std::size_t>(-1);

  /// Where a part goes: to one side of a joint, or nowhere if it is the whole.
  struct Goal {
    std::size_t joint = kNoJoint;
    std::size_t side = 0;
  };
  struct Piece {
    Index lo, hi;
    Goal goal;
  };
  struct Joint {
    Axis axis;
    Index slot;
    Goal goal;
    std::array<Part, 2> parts;
  };

  /// Cuts sites [lo, hi), which make a part that goes to `goal`.
  void divide(Index lo, Index hi, Goal goal) {
    const auto keys = keys_.subspan(lo, hi - lo);
    if (keys.size() <= most_ || keys.front() == keys.back()) {
      pieces_.push_back({lo, hi, goal});
      return;
    }
    const Cut cut = cut_of(keys);
    const std::size_t joint = joints_.size();
    joints_.push_back({cut.axis, slot_at(lo + cut.low), goal, {}});
    divide(lo, lo + cut.low, {joint, 0});
    divide(lo + cut.low, hi, {joint, 1});
  }

  /// Brings a part where it goes, and with it whatever it completes.
  void bring(Part part, Goal goal) {
    for (; goal.joint != kNoJoint; goal = joints_[goal.joint].goal) {
      Joint& joint = joints_[goal.joint];
      joint.parts[goal.side] = part;
      if (arrivals_[goal.joint].fetch_add(1) == 0) return;  // the other part's thread goes on
      part = merge_parts(arrays_, joint.parts[0], joint.parts[1], joint.axis, joint.slot);
    }
  }

  PartArrays arrays_;
  std::span<const Index> keys_;
  Index most_;
  std::vector<Piece> pieces_;
  std::vector<Joint> joints_;
  std::vector<std::atomic<unsigned>> arrivals_;
};

/// Sites of a piece: some pieces a thread, so that none waits long for the last; all for a single thread.
Index sites_of_piece(Index count, unsigned threads) noexcept {
  constexpr Index kLeast = 1u << 13, kPiecesOfThread = 8;
  return threads == 1 ? count : std::max(kLeast, count / kPiecesOfThread / threads);
}

}  // namespace

GhostedTriangulation divide_and_conquer(std::span<const Point2> sites, std::span<const std::uint32_t> keys,
                                        unsigned threads) {
  THALWEG_ASSERT(sites.size() >= 2 && sites.size() <= kMaxSites && keys.size() == sites.size());
  const auto count = static_cast<Index>(sites.size());
  GhostedTriangulation mesh;
  mesh.origin = Array<Index>(std::size_t{8} * (count - 1));
  mesh.twin = Array<Index>(std::size_t{8} * (count - 1));
  const PartArrays arrays{sites.data(), mesh.origin.data(), mesh.twin.data()};
  SharedBuild(arrays, keys, sites_of_piece(count, threads)).run(threads);
  return mesh;
}

}  // namespace thalweg::detail
