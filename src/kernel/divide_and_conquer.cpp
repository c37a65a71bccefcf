/// Divide and conquer on all threads: the topmost cuts, and what becomes of the parts between them.
#include "kernel/divide_and_conquer.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <vector>

#include "kernel/assert.hpp"
#include "kernel/parallel.hpp"
#include "kernel/part_builder.hpp"
#include "kernel/seam_split.hpp"

namespace thalweg::detail {
namespace {

using Index = std::uint32_t;

/// The topmost cuts, so that threads can share what is between them: pieces of about equal work are built in
/// any order, and the thread that brings the second part of a cut merges the two and goes on with what they
/// become.
class SharedBuild {
 public:
  SharedBuild(const PartArrays& arrays, std::span<const Index> keys, const Sharing& sharing)
      : arrays_(arrays), keys_(keys), sharing_(sharing) {
    divide(0, static_cast<Index>(keys.size()), {}, sharing.threads);
    arrivals_ = std::vector<std::atomic<unsigned>>(joints_.size());
  }

  /// Makes one part of all.
  void run() {
    parallel_chunks(pieces_.size(), 1, sharing_.threads, [this] {
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
    TwoParts sites;
    Goal goal;
    unsigned threads;  ///< that have nothing else to do, if all pieces are alike
    std::array<Part, 2> parts;
  };

  /// Cuts sites [lo, hi), which make a part that goes to `goal`, for so many threads.
  void divide(Index lo, Index hi, Goal goal, unsigned threads) {
    const auto keys = keys_.subspan(lo, hi - lo);
    if (keys.size() <= most_sites() || keys.front() == keys.back()) {
      pieces_.push_back({lo, hi, goal});
      return;
    }
    const Cut cut = cut_of(keys);
    const std::size_t joint = joints_.size();
    joints_.push_back({cut.axis, {lo, lo + cut.low, hi}, goal, threads, {}});
    divide(lo, lo + cut.low, {joint, 0}, threads / 2);
    divide(lo + cut.low, hi, {joint, 1}, threads / 2);
  }

  /// Brings a part where it goes, and with it whatever it completes.
  void bring(Part part, Goal goal) {
    for (; goal.joint != kNoJoint; goal = joints_[goal.joint].goal) {
      Joint& joint = joints_[goal.joint];
      joint.parts[goal.side] = part;
      if (arrivals_[goal.joint].fetch_add(1) == 0) return;  // the other part's thread goes on
      part = merged(joint);
    }
  }

  /// Of sites in a piece, if more are not in one cell: some pieces a thread, so that none waits long for the
  /// last; all for a single thread.
  std::size_t most_sites() const noexcept {
    constexpr std::size_t kPiecesOfThread = 16;
    if (sharing_.threads == 1) return keys_.size();
    return std::max<std::size_t>(sharing_.least_piece, keys_.size() / kPiecesOfThread / sharing_.threads);
  }

  Part merged(const Joint& joint) const {
    const auto& [left, right] = joint.parts;
    const Index slot = slot_at(joint.sites.mid);
    SeamSplit split(arrays_, joint.sites, joint.threads, sharing_.least_edges);
    return merge_parts(arrays_, left, right, joint.axis, slot, joint.threads > 1 ? &split : nullptr);
  }

  PartArrays arrays_;
  std::span<const Index> keys_;
  Sharing sharing_;
  std::vector<Piece> pieces_;
  std::vector<Joint> joints_;
  std::vector<std::atomic<unsigned>> arrivals_;
};

}  // namespace

GhostedTriangulation divide_and_conquer(std::span<const Point2> sites, std::span<const std::uint32_t> keys,
                                        const Sharing& sharing) {
  THALWEG_ASSERT(sites.size() >= 2 && sites.size() <= kMaxSites && keys.size() == sites.size());
  const auto count = static_cast<Index>(sites.size());
  GhostedTriangulation mesh;
  mesh.origin = Array<Index>(std::size_t{8} * (count - 1));
  mesh.twin = Array<Index>(std::size_t{8} * (count - 1));
  const PartArrays arrays{sites.data(), mesh.origin.data(), mesh.twin.data()};
  SharedBuild(arrays, keys, sharing).run();
  return mesh;
}

}  // namespace thalweg::detail
