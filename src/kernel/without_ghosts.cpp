/// Faces move together, and keep their order. Where blocks of slots have no ghosts, which is the rule,
/// numbers follow by arithmetic.
#include "kernel/without_ghosts.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "kernel/parallel.hpp"

namespace thalweg::detail {
namespace {

using Index = std::uint32_t;

constexpr Index kNone = HalfedgeId::kInvalid;

/// Two slots a site. Small, so that for few of them a number is more than arithmetic.
constexpr Index kBlockSlots = 1u << 9, kBlockSites = kBlockSlots / 2;

/// So many at least are worth a thread.
constexpr std::size_t kBlocksOfThread = 64;

class Packing {
 public:
  Packing(GhostedTriangulation mesh, unsigned threads)
      : mesh_(std::move(mesh)),
        slot_count_(static_cast<Index>(mesh_.origin.size() / 4)),
        blocks_((slot_count_ + kBlockSlots - 1) / kBlockSlots),
        parts_(parts_of(blocks_.size(), kBlocksOfThread, threads)) {
    count_ghosts();
  }

  Index face_count() const noexcept { return slot_count_ - ghost_count_; }

  /// Requires: there are faces. (Otherwise ghosts have ghosts behind them.)
  Triangulation run();

 private:
  struct Block {
    Index ghosts_before = 0;
    Index ghosts = 0;
  };

  struct Corners {
    Array<Index> origin;    ///< of every half-edge
    Array<Index> outgoing;  ///< a half-edge of every site
  };

  using Slots = std::array<Index, kBlockSlots>;

  /// Half-edges that leave sites of other parts, some for each.
  using Strays = std::vector<Array<Index>>;

  static Index first_slot(std::size_t block) noexcept { return static_cast<Index>(block * kBlockSlots); }
  Index end_slot(std::size_t block) const noexcept { return std::min(first_slot(block + 1), slot_count_); }

  /// 1 for the corners of a ghost, else 0.
  static Index is_ghost(const Index* corners) noexcept {
    return (corners[0] | corners[1] | corners[2]) >> 31;  // no site has this bit
  }
  /// The packed number of a half-edge of a face; none of none. A copy of its own: who writes numbers might
  /// change what `this` says.
  auto renumbering() const noexcept {
    return [blocks = blocks_.data(), origins = mesh_.origin.data()](Index h) {
      if (h == kNone) return kNone;
      const Block block = blocks[h / (4 * kBlockSlots)];
      if (block.ghosts == 0) [[likely]]
        return h - h / 4 - 3 * block.ghosts_before;
      return origins[h | 3] + h % 4;
    };
  }

  std::span<Index> hull_of(const Block& block) noexcept {
    return std::span(hull_).subspan(block.ghosts_before, block.ghosts);
  }
  /// The part of the blocks that has a site.
  std::size_t part_of(Index site) const noexcept {
    return part_with(std::min<std::size_t>(site / kBlockSites, blocks_.size() - 1), blocks_.size(), parts_);
  }

  /// Calls task(block) for every block, in each thread from the last to the first. So goes all here, since
  /// pack_corners must and memory is read ahead in one direction.
  template <class Task>
  void each_block(Task&& task) {
    parallel_parts(blocks_.size(), parts_, [&](std::size_t, std::size_t begin, std::size_t end) {
      while (end-- > begin) task(end);
    });
  }
  std::span<const Index> slots_of(std::size_t block, bool ghosts, Slots& room) const;
  template <class Task>
  void each_face(std::size_t block, Task task) const;

  void count_ghosts();
  void cut_off_ghosts(std::size_t block);
  Array<Index> packed_twins();
  Array<std::uint8_t> pack_hull();
  /// Out of line: it is seldom called, and would take registers from the loop that calls it.
  [[gnu::noinline]] void add_stray(Strays& strays, Index site, Index h) const {
    strays[part_of(site)].push_back(h);
  }
  Strays pack_corners(std::size_t begin, std::size_t end, std::span<const std::uint8_t> on_hull,
                      Corners& corners);
  Corners packed_corners();

  /// In blocks with ghosts, the word of `origin` that has no corner comes to have the first half-edge of the
  /// packed face.
  GhostedTriangulation mesh_;
  Index slot_count_;
  Index ghost_count_ = 0;
  std::vector<Block> blocks_;
  Array<Index> hull_;  ///< for each ghost the half-edge behind it, along the hull
  std::size_t parts_;
};

/// Those slots of a block that are ghosts, or those that are faces, from the last to the first. No branch: it
/// would be a guess where they mix.
std::span<const Index> Packing::slots_of(std::size_t block, bool ghosts, Slots& room) const {
  const Index* const origins = mesh_.origin.data();
  const Index wanted = ghosts ? 1 : 0;
  Index count = 0;
  for (Index slot = end_slot(block), first = first_slot(block); slot > first;) {
    room[count] = --slot;
    count += is_ghost(origins + 4 * std::size_t{slot}) == wanted;
  }
  return std::span(room).first(count);
}

/// Calls task(slot, h) for every face of a block, from the last to the first; h is the first half-edge of the
/// packed face.
template <class Task>
void Packing::each_face(std::size_t block, Task task) const {
  const auto [before, ghosts] = blocks_[block];
  Index h = 3 * (end_slot(block) - before - ghosts);
  if (ghosts == 0) {
    for (Index slot = end_slot(block), first = first_slot(block); slot-- > first;) task(slot, h -= 3);
    return;
  }
  Slots room;
  for (const Index slot : slots_of(block, false, room)) task(slot, h -= 3);
}

void Packing::count_ghosts() {
  each_block([&](std::size_t b) {
    Index count = 0;
    for (Index slot = end_slot(b), first = first_slot(b); slot-- > first;)
      count += is_ghost(&mesh_.origin[4 * std::size_t{slot}]);
    blocks_[b].ghosts = count;
  });
  for (Block& block : blocks_) {
    block.ghosts_before = ghost_count_;
    ghost_count_ += block.ghosts;
  }
}

/// Lets the hull have no twin, notes it, and numbers the faces, if there are ghosts.
void Packing::cut_off_ghosts(std::size_t block) {
  if (blocks_[block].ghosts == 0) return;
  each_face(block,
            [origins = mesh_.origin.data()](Index slot, Index h) { origins[4 * std::size_t{slot} + 3] = h; });
  Slots room;
  std::ranges::transform(slots_of(block, true, room), hull_of(blocks_[block]).begin(), [&](Index ghost) {
    Index h = 4 * ghost;
    while (mesh_.origin[prev_of(h)] != kGhost) ++h;
    const Index along = mesh_.twin[h];
    mesh_.twin[along] = kNone;
    return along;
  });
}

/// Three words a face from four a slot, with their new numbers.
Array<Index> Packing::packed_twins() {
  Array<Index> twin(3 * std::size_t{face_count()});
  each_block([&](std::size_t b) {
    each_face(
        b, [renumbered = renumbering(), to = twin.data(), from = mesh_.twin.data()](Index slot, Index first) {
          for (std::size_t i = 0; i < 3; ++i) to[first + i] = renumbered(from[4 * std::size_t{slot} + i]);
        });
  });
  return twin;
}

/// Gives the hull its new numbers. Returns for every site whether it is on the hull, if several parts are to
/// know.
Array<std::uint8_t> Packing::pack_hull() {
  const bool told = parts_ > 1;
  Array<std::uint8_t> on_hull(told ? slot_count_ / 2 + 1 : 0, std::uint8_t{0});
  each_block([&](std::size_t b) {
    for (Index& h : hull_of(blocks_[b])) {
      if (told) on_hull[mesh_.origin[h]] = 1;  // no other thread's: one edge along the hull leaves a site
      h = renumbering()(h);
    }
  });
  return on_hull;
}

/// Three words a face from four a slot, for the blocks of a part, so that each site of the part is left with
/// the first half-edge that leaves it, which is met last. Returns those that leave others' sites within the
/// hull.
Packing::Strays Packing::pack_corners(std::size_t begin, std::size_t end,
                                      std::span<const std::uint8_t> on_hull, Corners& corners) {
  const std::size_t low = begin * kBlockSites;
  const std::size_t high = end == blocks_.size() ? corners.outgoing.size() : end * kBlockSites;
  Index* const outgoing = corners.outgoing.data();
  std::fill(outgoing + low, outgoing + high, kNone);
  Strays strays(parts_);
  for (std::size_t b = end; b-- > begin;) {
    each_face(b, [=, this, from = mesh_.origin.data(), to = corners.origin.data(), &strays](Index slot,
                                                                                            Index first) {
      const Index* const of_slot = from + 4 * std::size_t{slot};
      for (Index i = 3; i-- > 0;) {
        const Index v = of_slot[i];
        to[first + i] = v;
        if (v - low < high - low) {
          outgoing[v] = first + i;
        } else if (on_hull[v] == 0) {
          add_stray(strays, v, first + i);
        }
      }
    });
  }
  return strays;
}

/// The origins, and for every site the half-edge along the hull that leaves it, or else the first of all that
/// do. Each part of the faces has a part of the sites for itself: those that lie where its triangles do. What
/// the parts find for one another comes later, and then the hull.
Packing::Corners Packing::packed_corners() {
  const Array<std::uint8_t> on_hull = pack_hull();
  Corners corners{Array<Index>(3 * std::size_t{face_count()}), Array<Index>(slot_count_ / 2 + 1)};
  std::vector<Strays> strays(parts_);  // of each part
  parallel_parts(blocks_.size(), parts_, [&](std::size_t part, std::size_t begin, std::size_t end) {
    strays[part] = pack_corners(begin, end, on_hull, corners);
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
    for (const Index h : hull_of(blocks_[b])) corners.outgoing[corners.origin[h]] = h;
  });
  return corners;
}

/// One array comes after the other, so that no more memory is held than there must be.
Triangulation Packing::run() {
  hull_ = Array<Index>(ghost_count_);
  each_block([&](std::size_t b) { cut_off_ghosts(b); });
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
