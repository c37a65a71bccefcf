/// Ghosts leave holes among the slots. They are filled block by block with the last faces of the block:
/// threads then need nothing of each other, and faces stay near their sites.
#include "kernel/without_ghosts.hpp"

#include <algorithm>
#include <cstddef>
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
        ghosts_(blocks_.size()),
        hull_(blocks_.size()),
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

  static Index first_slot(std::size_t block) noexcept { return static_cast<Index>(block * kBlockSlots); }
  Index first_face(std::size_t block) const noexcept { return first_slot(block) - blocks_[block].shift / 3; }

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
  template <class Convert>
  Array<Index> packed(const Array<Index>& slots, Convert&& convert);
  Array<Index> outgoing_of(const Array<Index>& origin);

  /// The word of `origin` that has no corner tells of a face that was moved the first half-edge of its new
  /// slot.
  GhostedTriangulation mesh_;
  Index slot_count_;
  Index face_count_ = 0;
  std::vector<Block> blocks_;
  std::vector<std::vector<Index>> ghosts_;  ///< of each block, their slots, ascending
  std::vector<std::vector<Index>> hull_;    ///< and behind each of them the half-edge along the hull
  std::size_t parts_;
};

void Packing::find_ghosts() {
  each_block([&](std::size_t b) {
    const Index begin = first_slot(b), end = std::min(begin + kBlockSlots, slot_count_);
    std::vector<Index> found(end - begin);
    Index count = 0;
    for (Index slot = begin; slot < end; ++slot) {
      const Index* corners = &mesh_.origin[4 * std::size_t{slot}];
      found[count] = slot;  // a branch would be a guess where ghosts are many
      count += (corners[0] | corners[1] | corners[2]) >> 31;  // no site has this bit
    }
    ghosts_[b].assign(found.begin(), found.begin() + count);
    blocks_[b].end = 4 * (end - count);
  });
  Index ghosts = 0;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    blocks_[b].shift = 3 * ghosts;
    ghosts += static_cast<Index>(ghosts_[b].size());
  }
  face_count_ = slot_count_ - ghosts;
}

/// Lets the hull have no twin, and notes it.
void Packing::cut_off_ghosts() {
  each_block([&](std::size_t b) {
    hull_[b].reserve(ghosts_[b].size());
    for (const Index ghost : ghosts_[b]) {
      Index h = 4 * ghost;
      while (mesh_.origin[prev_of(h)] != kGhost) ++h;
      hull_[b].push_back(mesh_.twin[h]);
      mesh_.twin[mesh_.twin[h]] = kNone;
    }
  });
}

/// Moves the last faces of each block into the slots of ghosts.
void Packing::fill_holes() {
  each_block([&](std::size_t b) {
    const Index tail = blocks_[b].end / 4;
    const auto tail_ghosts = std::lower_bound(ghosts_[b].begin(), ghosts_[b].end(), tail);
    auto next_ghost = tail_ghosts;
    Index from = tail;
    for (auto to = ghosts_[b].begin(); to != tail_ghosts; ++to, ++from) {
      for (; next_ghost != ghosts_[b].end() && *next_ghost == from; ++next_ghost) ++from;
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

/// Three words a face from four a slot, each of them converted.
template <class Convert>
Array<Index> Packing::packed(const Array<Index>& slots, Convert&& convert) {
  Array<Index> faces(3 * std::size_t{face_count_});
  each_block([&](std::size_t b) {
    const std::size_t begin = 4 * std::size_t{first_slot(b)};
    Index* face = faces.data() + 3 * std::size_t{first_face(b)};
    for (std::size_t slot = begin; slot < blocks_[b].end; slot += 4, face += 3) {
      for (std::size_t i = 0; i < 3; ++i) face[i] = convert(slots[slot + i]);
    }
  });
  return faces;
}

/// For every site the half-edge along the hull that leaves it, or else the first of all that do. Each part of
/// the faces has a part of the sites for itself: those that lie where its triangles do. What the parts find
/// for one another comes later, and then the hull, of which one half-edge leaves a site.
Array<Index> Packing::outgoing_of(const Array<Index>& origin) {
  const std::size_t site_count = slot_count_ / 2 + 1;
  Array<Index> outgoing(site_count);
  using Strays = std::vector<std::vector<Index>>;
  std::vector<Strays> strays(parts_);  // of each part those for each
  parallel_parts(blocks_.size(), parts_, [&](std::size_t part, std::size_t begin, std::size_t end) {
    const std::size_t low = begin * kBlockSites;
    const std::size_t high = end == blocks_.size() ? site_count : end * kBlockSites;
    std::fill(&outgoing[low], &outgoing[low] + (high - low), kNone);
    Strays for_others(parts_);  // its own, or threads would write to the same lines of memory
    const Index first = 3 * first_face(begin),
                last = 3 * (end == blocks_.size() ? face_count_ : first_face(end));
    for (Index h = last; h-- > first;) {
      const Index v = origin[h];
      if (v - low < high - low) {
        outgoing[v] = h;
      } else {
        for_others[part_of(v)].push_back(h);
      }
    }
    strays[part] = std::move(for_others);
  });
  parallel_parts(parts_, parts_, [&](std::size_t to, std::size_t, std::size_t) {
    for (const Strays& of_part : strays) {
      for (const Index h : of_part[to]) outgoing[origin[h]] = std::min(outgoing[origin[h]], h);
    }
  });
  each_block([&](std::size_t b) {
    for (const Index h : hull_[b]) outgoing[origin[h]] = h;
  });
  return outgoing;
}

/// One array comes after the other, so that no more memory is held than there must be.
Triangulation Packing::run() {
  cut_off_ghosts();
  fill_holes();
  each_block([&](std::size_t b) { std::ranges::transform(hull_[b], hull_[b].begin(), renumbering()); });
  Array<Index> twin = packed(mesh_.twin, renumbering());
  mesh_.twin = Array<Index>();  // braces would empty it and keep the memory
  Array<Index> origin = packed(mesh_.origin, [](Index v) { return v; });
  mesh_.origin = Array<Index>();
  Array<Index> outgoing = outgoing_of(origin);
  return linked(std::move(origin), std::move(twin), std::move(outgoing));
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
