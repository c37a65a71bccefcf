/// Faces move together in the memory they are in, and keep their order. Where blocks of slots have no ghosts,
/// which is the rule, numbers follow by arithmetic.
#include "kernel/without_ghosts.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "kernel/cut_short.hpp"
#include "kernel/parallel.hpp"

namespace thalweg::detail {
namespace {

using Index = std::uint32_t;

constexpr Index kNone = HalfedgeId::kInvalid;

/// Two slots a site. Small, so that for few of them a number is more than arithmetic.
constexpr Index kBlockSlots = 1u << 9, kBlockSites = kBlockSlots / 2;

/// So many at least are worth a thread.
constexpr std::size_t kBlocksOfThread = 16;

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
  Triangulation run(const VertexNames& names);

 private:
  struct Block {
    Index ghosts_before = 0;
    Index ghosts = 0;
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
  /// The packed number of a half-edge; none of a ghost's. A copy of its own: who writes numbers might change
  /// what `this` says.
  auto renumbering() const noexcept {
    return [blocks = blocks_.data(), origins = mesh_.origin.data()](Index h) {
      const Block block = blocks[h / (4 * kBlockSlots)];
      if (block.ghosts == 0) [[likely]]
        return h - h / 4 - 3 * block.ghosts_before;
      const Index first = origins[h | 3];
      return first == kNone ? kNone : first + h % 4;  // a choice; a branch would be a guess on a curve
    };
  }

  std::span<Index> hull_of(const Block& block) noexcept {
    return std::span(hull_).subspan(block.ghosts_before, block.ghosts);
  }
  /// The part of the blocks that has a site.
  std::size_t part_of(Index site) const noexcept {
    return part_with(std::min<std::size_t>(site / kBlockSites, blocks_.size() - 1), blocks_.size(), parts_);
  }

  /// Calls task(block) for every block, on all threads.
  template <class Task>
  void each_block(const Task& task) {
    parallel_parts(blocks_.size(), parts_, [&](std::size_t, std::size_t begin, std::size_t end) {
      for (; begin < end; ++begin) task(begin);
    });
  }
  template <class Task>
  void each_wave(const Task& task);
  std::span<const Index> slots_of(std::size_t block, bool ghosts, Slots& room) const;
  template <class Task>
  void each_face(std::size_t block, Task task) const;

  void count_ghosts();
  void cut_off_ghosts(std::size_t block);
  void pack_twins();
  Array<std::uint8_t> pack_hull();
  /// Out of line: it is seldom called, and would take registers from the loop that calls it.
  [[gnu::noinline]] void add_stray(Strays& strays, Index site, Index h) const {
    strays[part_of(site)].push_back(h);
  }
  void pack_corners(std::size_t begin, std::size_t end, std::span<const Index> names,
                    std::span<const std::uint8_t> on_hull, Strays& strays);
  void find_outgoing(const VertexNames& names, const std::vector<Strays>& strays);

  /// In blocks with ghosts, the word of `origin` that has no corner comes to have the first half-edge of the
  /// packed face, or kNone in a ghost.
  GhostedTriangulation mesh_;
  Index slot_count_;
  Index ghost_count_ = 0;
  std::vector<Block> blocks_;
  Array<Index> hull_;      ///< for each ghost the half-edge behind it, along the hull
  Array<Index> outgoing_;  ///< a half-edge of every site, then of every vertex
  std::size_t parts_;
};

/// Calls task(part, begin, end) for ranges of blocks that make all of them; those of one part come one after
/// the other. A range may write three words a slot, from the front of an array on, over four: at most a third
/// as many blocks as are done are shared out at a time, so that nobody writes where others still read.
template <class Task>
void Packing::each_wave(const Task& task) {
  constexpr std::size_t kFirst = 3 * 2 * kBlocksOfThread;  // then two threads have work
  const std::size_t count = blocks_.size();
  std::size_t done = parts_ == 1 ? count : std::min(count, kFirst);
  task(std::size_t{0}, std::size_t{0}, done);
  while (done < count) {
    const std::size_t wave = std::min(done / 3, count - done);
    parallel_parts(
        wave, parts_of(wave, kBlocksOfThread, static_cast<unsigned>(parts_)),
        [&](std::size_t part, std::size_t begin, std::size_t end) { task(part, done + begin, done + end); });
    done += wave;
  }
}

/// Those slots of a block that are ghosts, or those that are faces. No branch: it would be a guess where they
/// mix.
std::span<const Index> Packing::slots_of(std::size_t block, bool ghosts, Slots& room) const {
  const Index* const origins = mesh_.origin.data();
  const Index wanted = ghosts ? 1 : 0;
  Index count = 0;
  for (Index slot = first_slot(block), end = end_slot(block); slot < end; ++slot) {
    room[count] = slot;
    count += is_ghost(origins + 4 * std::size_t{slot}) == wanted;
  }
  return std::span(room).first(count);
}

/// Calls task(slot, h) for every face of a block; h is the first half-edge of the packed face.
template <class Task>
void Packing::each_face(std::size_t block, Task task) const {
  const auto [before, ghosts] = blocks_[block];
  Index h = 3 * (first_slot(block) - before);
  if (ghosts == 0) {
    for (Index slot = first_slot(block), end = end_slot(block); slot < end; ++slot, h += 3) task(slot, h);
    return;
  }
  Slots room;
  for (const Index slot : slots_of(block, false, room)) {
    task(slot, h);
    h += 3;
  }
}

void Packing::count_ghosts() {
  each_block([&](std::size_t b) {
    Index count = 0;
    for (Index slot = first_slot(b), end = end_slot(b); slot < end; ++slot)
      count += is_ghost(&mesh_.origin[4 * std::size_t{slot}]);
    blocks_[b].ghosts = count;
  });
  for (Block& block : blocks_) {
    block.ghosts_before = ghost_count_;
    ghost_count_ += block.ghosts;
  }
}

/// Numbers the faces, and notes what is behind the ghosts, if there are any.
void Packing::cut_off_ghosts(std::size_t block) {
  const auto [before, ghosts] = blocks_[block];
  if (ghosts == 0) return;
  Index* const origins = mesh_.origin.data();
  Index h = 3 * (first_slot(block) - before);
  for (Index slot = first_slot(block), end = end_slot(block); slot < end; ++slot) {
    Index* const of_slot = origins + 4 * std::size_t{slot};
    const Index ghost = is_ghost(of_slot);
    of_slot[3] = ghost != 0 ? kNone : h;
    h += 3 - 3 * ghost;
  }
  Slots room;
  std::ranges::transform(slots_of(block, true, room), hull_of(blocks_[block]).begin(), [&](Index ghost) {
    Index side = 4 * ghost;
    while (origins[prev_of(side)] != kGhost) ++side;
    return mesh_.twin[side];
  });
}

/// Three words a face from four a slot, with their new numbers.
void Packing::pack_twins() {
  each_wave([&](std::size_t, std::size_t begin, std::size_t end) {
    for (; begin < end; ++begin) {
      each_face(begin, [renumbered = renumbering(), twins = mesh_.twin.data()](Index slot, Index first) {
        for (std::size_t i = 0; i < 3; ++i) twins[first + i] = renumbered(twins[4 * std::size_t{slot} + i]);
      });
    }
  });
  cut_short(mesh_.twin, 3 * std::size_t{face_count()});
}

/// Lets the sites on the hull be left by the half-edge along it. Returns for every site whether it is one.
Array<std::uint8_t> Packing::pack_hull() {
  Array<std::uint8_t> on_hull(outgoing_.size(), std::uint8_t{0});
  each_block([&](std::size_t b) {
    for (const Index h : hull_of(blocks_[b])) {
      const Index site = mesh_.origin[h];  // no other thread's: one edge along the hull leaves it
      on_hull[site] = 1;
      outgoing_[site] = renumbering()(h);
    }
  });
  return on_hull;
}

/// Three words a face from four a slot, with the names of the sites, for a range of blocks; and for the sites
/// within the hull that lie where its triangles do, the first of its half-edges that leave them. Those that
/// leave others' are strays.
void Packing::pack_corners(std::size_t begin, std::size_t end, std::span<const Index> names,
                           std::span<const std::uint8_t> on_hull, Strays& strays) {
  const std::size_t low = begin * kBlockSites;
  const std::size_t high = end == blocks_.size() ? outgoing_.size() : end * kBlockSites;
  Index* const outgoing = outgoing_.data();
  for (std::size_t v = low; v < high; ++v) outgoing[v] = on_hull[v] != 0 ? outgoing[v] : kNone;
  for (std::size_t b = begin; b < end; ++b) {
    each_face(b, [=, this, origins = mesh_.origin.data(), &strays](Index slot, Index first) {
      const Index* const of_slot = origins + 4 * std::size_t{slot};
      for (Index i = 0; i < 3; ++i) {
        const Index v = of_slot[i];
        origins[first + i] = names.empty() ? v : names[v];
        if (on_hull[v] != 0) continue;
        if (v - low < high - low) {
          outgoing[v] = std::min(outgoing[v], first + i);
        } else {
          add_stray(strays, v, first + i);
        }
      }
    });
  }
}

/// Gives every site its name, and those within the hull the first half-edge of all that leave them: each
/// thread has met those of some sites, and what else leaves these, others have found.
void Packing::find_outgoing(const VertexNames& names, const std::vector<Strays>& strays) {
  if (!names.of_site.empty()) {
    Array<Index> named(names.count);
    if (names.count > outgoing_.size()) std::fill(named.begin(), named.end(), kNone);
    parallel_for(outgoing_.size(), static_cast<unsigned>(parts_),
                 [&](std::size_t site) { named[names.of_site[site]] = outgoing_[site]; });
    outgoing_ = std::move(named);
  }
  parallel_parts(parts_, parts_, [&](std::size_t to, std::size_t, std::size_t) {
    for (const Strays& of_part : strays) {
      for (const Index h : of_part[to]) {
        Index& first = outgoing_[mesh_.origin[h]];
        first = std::min(first, h);
      }
    }
  });
}

Triangulation Packing::run(const VertexNames& names) {
  hull_ = Array<Index>(ghost_count_);
  each_block([&](std::size_t b) { cut_off_ghosts(b); });
  pack_twins();
  outgoing_ = Array<Index>(slot_count_ / 2 + 1);
  const Array<std::uint8_t> on_hull = pack_hull();
  std::vector<Strays> strays(parts_, Strays(parts_));  // of each part
  each_wave([&](std::size_t part, std::size_t begin, std::size_t end) {
    pack_corners(begin, end, names.of_site, on_hull, strays[part]);
  });
  cut_short(mesh_.origin, 3 * std::size_t{face_count()});
  find_outgoing(names, strays);
  return linked(std::move(mesh_.origin), std::move(mesh_.twin), std::move(outgoing_));
}

}  // namespace

Result<Triangulation> without_ghosts(GhostedTriangulation mesh, const VertexNames& names, unsigned threads) {
  Packing packing(std::move(mesh), threads);
  if (packing.face_count() == 0) {
    return Error{ErrorCode::all_collinear, "all points lie on one line: there is no triangle"};
  }
  return packing.run(names);
}

}  // namespace thalweg::detail
