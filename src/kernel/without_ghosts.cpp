/// Ghosts leave holes among the slots. They are filled block by block with the last faces of the block:
/// threads then need nothing of each other, and faces stay near their sites.
#include "kernel/without_ghosts.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "kernel/parallel.hpp"

namespace thalweg::detail {
namespace {

using Index = std::uint32_t;

constexpr Index kNone = HalfedgeId::kInvalid;

/// Two slots a site.
constexpr Index kBlockSlots = 1u << 14, kBlockSites = kBlockSlots / 2;

/// So many at least are worth a thread.
constexpr std::size_t kBlocksOfThread = 4;

class Packing {
 public:
  Packing(GhostedTriangulation mesh, unsigned threads)
      : mesh_(std::move(mesh)),
        slot_count_(static_cast<Index>(mesh_.origin.size() / 4)),
        blocks_((slot_count_ + kBlockSlots - 1) / kBlockSlots),
        parts_(parts_of(blocks_.size(), kBlocksOfThread, threads)) {
    find_ghosts();
  }

  Index face_count() const noexcept { return face_count_; }

  /// Requires: there are faces. (Otherwise ghosts have ghosts behind them.)
  Triangulation run();

 private:
  /// In the end the faces of a block are in its first slots, one after the other.
  struct Block {
    Index end = 0;    ///< the first half-edge of the slot behind them
    Index shift = 0;  ///< three times the ghosts before the block
  };

  struct Corners {
    Array<Index> origin;    ///< of every half-edge
    Array<Index> outgoing;  ///< a half-edge of every site
  };

  /// Half-edges that leave sites of other parts, some for each.
  using Strays = std::vector<Array<Index>>;

  static Index first_slot(std::size_t block) noexcept { return static_cast<Index>(block * kBlockSlots); }
  Index end_slot(std::size_t block) const noexcept { return std::min(first_slot(block + 1), slot_count_); }
  Index first_face(std::size_t block) const noexcept { return first_slot(block) - blocks_[block].shift / 3; }

  /// What is told of the ghosts of a block.
  std::span<Index> of_block(Array<Index>& of_ghosts, std::size_t block) const noexcept {
    return std::span(of_ghosts).subspan(blocks_[block].shift / 3, end_slot(block) - blocks_[block].end / 4);
  }

  /// The part of the blocks that has a site.
  std::size_t part_of(Index site) const noexcept {
    return part_with(std::min<std::size_t>(site / kBlockSites, blocks_.size() - 1), blocks_.size(), parts_);
  }

  /// Calls task(block) for every block.
  template <class Task>
  void each_block(Task&& task) {
    parallel_parts(blocks_.size(), parts_, [&](std::size_t, std::size_t begin, std::size_t end) {
      for (; begin < end; ++begin) task(begin);
    });
  }

  void find_ghosts();
  void cut_off_ghosts();
  void fill_holes();
  auto renumbering() const noexcept;
  Array<Index> packed_twins();
  /// Out of line: it is seldom called, and would take registers from the loop that calls it.
  [[gnu::noinline]] void add_stray(Strays& strays, Index site, Index h) const {
    strays[part_of(site)].push_back(h);
  }
  Strays pack_corners(std::size_t begin, std::size_t end, Corners& corners);
  Corners packed_corners();

  /// The word of `origin` that has no corner tells of a face that was moved the first half-edge of its new
  /// slot.
  GhostedTriangulation mesh_;
  Index slot_count_;
  Index face_count_ = 0;
  std::vector<Block> blocks_;
  Array<Index> ghosts_;  ///< their slots, ascending
  Array<Index> hull_;    ///< behind each of them the half-edge along the hull
  std::size_t parts_;
};

void Packing::find_ghosts() {
  std::vector<Array<Index>> ghosts(parts_);
  parallel_parts(blocks_.size(), parts_, [&](std::size_t part, std::size_t begin, std::size_t end) {
    Array<Index> found(kBlockSlots), all;
    for (std::size_t b = begin; b < end; ++b) {
      Index count = 0;
      for (Index slot = first_slot(b); slot < end_slot(b); ++slot) {
        const Index* corners = &mesh_.origin[4 * std::size_t{slot}];
        found[count] = slot;  // a branch would be a guess where ghosts are many
        count += (corners[0] | corners[1] | corners[2]) >> 31;  // no site has this bit
      }
      all.insert(all.end(), found.data(), found.data() + count);
      blocks_[b].end = 4 * (end_slot(b) - count);
    }
    ghosts[part] = std::move(all);
  });
  Index count = 0;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    blocks_[b].shift = 3 * count;
    count += end_slot(b) - blocks_[b].end / 4;
  }
  face_count_ = slot_count_ - count;
  ghosts_ = Array<Index>(count);
  hull_ = Array<Index>(count);
  parallel_parts(blocks_.size(), parts_, [&](std::size_t part, std::size_t begin, std::size_t) {
    std::ranges::copy(ghosts[part], of_block(ghosts_, begin).data());
  });
}

/// Lets the hull have no twin, and notes it.
void Packing::cut_off_ghosts() {
  each_block([&](std::size_t b) {
    std::ranges::transform(of_block(ghosts_, b), of_block(hull_, b).begin(), [&](Index ghost) {
      Index h = 4 * ghost;
      while (mesh_.origin[prev_of(h)] != kGhost) ++h;
      const Index along = mesh_.twin[h];
      mesh_.twin[along] = kNone;
      return along;
    });
  });
}

/// Moves the last faces of each block into the slots of ghosts.
void Packing::fill_holes() {
  each_block([&](std::size_t b) {
    const Index tail = blocks_[b].end / 4;
    const auto ghosts = of_block(ghosts_, b);
    const auto tail_ghosts = std::ranges::lower_bound(ghosts, tail);
    auto next_ghost = tail_ghosts;
    Index from = tail;
    for (auto to = ghosts.begin(); to != tail_ghosts; ++to, ++from) {
      for (; next_ghost != ghosts.end() && *next_ghost == from; ++next_ghost) ++from;
      std::copy_n(&mesh_.origin[4 * std::size_t{from}], 3, &mesh_.origin[4 * std::size_t{*to}]);
      std::copy_n(&mesh_.twin[4 * std::size_t{from}], 3, &mesh_.twin[4 * std::size_t{*to}]);
      mesh_.origin[4 * std::size_t{from} + 3] = 4 * *to;
    }
  });
}

/// What gives a half-edge, of a face that was in its slot before holes were filled, its number; none for
/// none.
auto Packing::renumbering() const noexcept {
  return [blocks = blocks_.data(), moved = mesh_.origin.data()](Index h) {
    if (h == kNone) return kNone;
    const Block& block = blocks[h / (4 * kBlockSlots)];
    const Index place = h < block.end ? h : moved[h | 3] + h % 4;
    return place - place / 4 - block.shift;
  };
}

/// Three words a face from four a slot, with their new numbers.
Array<Index> Packing::packed_twins() {
  Array<Index> twin(3 * std::size_t{face_count_});
  each_block([&](std::size_t b) {
    const auto renumbered = renumbering();
    Index* face = &twin[0] + 3 * std::size_t{first_face(b)};
    for (std::size_t slot = 4 * std::size_t{first_slot(b)}; slot < blocks_[b].end; slot += 4, face += 3) {
      for (std::size_t i = 0; i < 3; ++i) face[i] = renumbered(mesh_.twin[slot + i]);
    }
  });
  return twin;
}

/// Three words a face from four a slot, for the blocks of a part from the last to the first, so that each
/// site of the part is left with the first half-edge that leaves it. Returns those that leave others' sites.
Packing::Strays Packing::pack_corners(std::size_t begin, std::size_t end, Corners& corners) {
  const std::size_t low = begin * kBlockSites;
  const std::size_t high = end == blocks_.size() ? corners.outgoing.size() : end * kBlockSites;
  Index* const outgoing = corners.outgoing.data();
  std::fill(outgoing + low, outgoing + high, kNone);
  Strays strays(parts_);
  for (std::size_t b = end; b-- > begin;) {
    const Index* const first = &mesh_.origin[4 * std::size_t{first_slot(b)}];
    Index h = 3 * (first_face(b) + blocks_[b].end / 4 - first_slot(b));
    for (const Index* slot = mesh_.origin.data() + blocks_[b].end; slot != first;) {
      slot -= 4;
      for (std::size_t i = 3; i-- > 0;) {
        const Index v = slot[i];
        corners.origin[--h] = v;
        if (v - low < high - low) {
          outgoing[v] = h;
        } else {
          add_stray(strays, v, h);
        }
      }
    }
  }
  return strays;
}

/// The origins, and for every site the half-edge along the hull that leaves it, or else the first of all that
/// do. Each part of the faces has a part of the sites for itself: those that lie where its triangles do. What
/// the parts find for one another comes later, and then the hull, of which one half-edge leaves a site.
Packing::Corners Packing::packed_corners() {
  Corners corners{Array<Index>(3 * std::size_t{face_count_}), Array<Index>(slot_count_ / 2 + 1)};
  std::vector<Strays> strays(parts_);  // of each part
  parallel_parts(blocks_.size(), parts_, [&](std::size_t part, std::size_t begin, std::size_t end) {
    strays[part] = pack_corners(begin, end, corners);
  });
  parallel_parts(parts_, parts_, [&](std::size_t to, std::size_t, std::size_t) {
    for (const Strays& of_part : strays) {
      for (const Index h : of_part[to]) {
        Index& first = corners.outgoing[corners.origin[h]];
        first = std::min(first, h);
      }
    }
  });
  each_block([&](std::size_t b) {
    for (const Index h : of_block(hull_, b)) corners.outgoing[corners.origin[h]] = h;
  });
  return corners;
}

/// One array comes after the other, so that no more memory is held than there must be.
Triangulation Packing::run() {
  cut_off_ghosts();
  fill_holes();
  each_block([&](std::size_t b) {
    std::ranges::transform(of_block(hull_, b), of_block(hull_, b).begin(), renumbering());
  });
  Array<Index> twin = packed_twins();
  mesh_.twin = Array<Index>();  // braces would empty it and keep the memory
  Corners corners = packed_corners();
  return linked(std::move(corners.origin), std::move(twin), std::move(corners.outgoing));
}

}  // namespace

Result<Triangulation> without_ghosts(GhostedTriangulation mesh, unsigned threads) {
  Packing packing(std::move(mesh), threads);
  if (packing.face_count() == 0) {
    return Error{ErrorCode::all_collinear, "all points lie on one line: there is no triangle"};
  }
  return packing.run();
}

}  // namespace thalweg::detail
