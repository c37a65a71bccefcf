/// Flips by order buckets.
///
/// A flip never makes a pit. Let c be the lowest of the corners a, b, c, d and cd replace ab. Only a and b
/// lose a neighbour, each other, and both keep c, which is no higher: whoever drained to the other, or was
/// one flat with it, still does or is through c. So the pits can be followed without looking at the
/// triangulation. If c is lower than d, the pit of d, if any, is gone. If they are level, their flats become
/// one: two pits make one, and a pit that meets a flat that drains is gone.
#include "terrain/flip.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "kernel/assert.hpp"
#include "kernel/parallel.hpp"
#include "kernel/predicates_inline.hpp"
#include "terrain/disjoint_sets.hpp"

namespace thalweg::detail {
namespace {

/// A flip that may be done: half-edge a -> b with the apexes c, the lowest of the four, and d, as they were
/// when it was found, and the orders of the triangles d, c, a and c, d, b.
struct Candidate {
  HalfedgeId halfedge;
  VertexId a, b, c, d;
  unsigned order_at_a, order_at_b;
};

/// The Delaunay pits while flips remove and join them.
class PitLedger {
 public:
  explicit PitLedger(const Surface& surface)
      : surface_(&surface),
        groups_(surface.pits().size()),
        gone_(surface.pits().size(), 0),
        left_(surface.pits().size()) {
    for (std::uint32_t i = 0; i < left_; ++i) lowest_.push_back(surface.lowest(surface.pits()[i]));
  }

  std::uint32_t left() const noexcept { return left_; }

  /// Records the new edge from c to d, of which c is the lower in elevation order. Returns the first vertex
  /// of the pit that is no more, because it drains or belongs to another one now; invalid if there is none.
  VertexId join(VertexId c, VertexId d) {
    const std::uint32_t at_d = alive(d);
    if (surface_->z(c) < surface_->z(d)) return end(at_d);
    const std::uint32_t at_c = alive(c);
    if (at_c == at_d) return VertexId();
    if (at_c == Surface::kNoPit) return end(at_d);
    if (at_d == Surface::kNoPit) return end(at_c);
    const VertexId low = lowest_[at_c], high = lowest_[at_d];
    groups_.join(at_c, at_d);
    lowest_[groups_.find(at_c)] =
        std::min(low, high, [&](VertexId u, VertexId v) { return surface_->lower(u, v); });
    --left_;
    return std::max(low, high, [&](VertexId u, VertexId v) { return surface_->lower(u, v); });
  }

 private:
  /// The group of pits that v lies on, or kNoPit if it drains.
  std::uint32_t alive(VertexId v) noexcept {
    const std::uint32_t pit = surface_->pit_of(v);
    if (pit == Surface::kNoPit) return pit;
    const std::uint32_t group = groups_.find(pit);
    return gone_[group] != 0 ? Surface::kNoPit : group;
  }

  VertexId end(std::uint32_t group) {
    if (group == Surface::kNoPit) return VertexId();
    gone_[group] = 1;
    --left_;
    return lowest_[group];
  }

  const Surface* surface_;
  DisjointSets groups_;
  std::vector<std::uint8_t> gone_;
  std::vector<VertexId> lowest_;  // of each group, at its root
  std::uint32_t left_;
};

class FlipRun {
 public:
  FlipRun(const Surface& surface, unsigned k, const Watch& watch)
      : surface_(surface),
        watch_(watch),
        k_(k),
        rank_(surface.ranks()),
        ledger_(surface),
        buckets_(k + std::size_t{1}) {
    // A copy: on rough ground flips touch nearly every stretch of a revision.
    outcome_.triangulation = surface.delaunay();
    outcome_.face_orders.assign(outcome_.triangulation.face_count(), 0);
    for (unsigned i = 0; i < watch.threads; ++i) counters_.emplace_back(surface.graph());
  }

  Outcome run(std::vector<std::uint32_t>* pits_at) {
    if (k_ > 0) collect_all();
    if (pits_at != nullptr) pits_at->assign(1, ledger_.left());
    for (unsigned level = 1; level <= k_ && !watch_.stopped(); ++level) {
      while (!buckets_[level].empty() && !watch_.stopped()) flip_wave(level);
      if (pits_at != nullptr) pits_at->push_back(ledger_.left());
      watch_.report("flipping", static_cast<double>(level) / k_);
    }
    outcome_.pits = ledger_.left();
    for (const CircleCounter& counter : counters_) outcome_.circle_counts += counter.calls();
    return std::move(outcome_);
  }

 private:
  bool is_lower(VertexId u, VertexId v) const noexcept { return rank_[u.index()] < rank_[v.index()]; }

  /// The order bucket of the flip of h, with the candidate; k + 1 if it is not to be done.
  unsigned assess(CircleCounter& counter, HalfedgeId h, Candidate& candidate) const {
    const Triangulation& t = outcome_.triangulation;
    if (t.on_hull(h)) return k_ + 1;
    HalfedgeId edge = h;
    if (is_lower(t.apex(t.twin(h)), t.apex(h))) edge = t.twin(h);
    const VertexId a = t.origin(edge), b = t.dest(edge), c = t.apex(edge), d = t.apex(t.twin(edge));
    if (!is_lower(c, a) || !is_lower(c, b)) return k_ + 1;
    const auto at = [&](VertexId v) { return surface_.sites()[v.index()]; };
    if (orient2d_sign(at(d), at(c), at(a)) <= 0 || orient2d_sign(at(d), at(c), at(b)) >= 0) return k_ + 1;
    candidate = {edge, a, b, c, d, counter.count_in_circle(d, c, a, k_), 0};
    if (candidate.order_at_a > k_) return candidate.order_at_a;
    candidate.order_at_b = counter.count_in_circle(c, d, b, k_);
    return std::max({1u, candidate.order_at_a, candidate.order_at_b});
  }

  void collect_all() {
    std::vector<HalfedgeId> all;
    for (std::uint32_t i = 0; i < outcome_.triangulation.halfedge_count(); ++i) {
      if (HalfedgeId(i) < outcome_.triangulation.twin(HalfedgeId(i))) all.emplace_back(i);  // once an edge
    }
    collect(all, 0);
  }

  /// Puts the candidates among these edges into their buckets, at `level` at least: what a lower round would
  /// have done, had it been possible then, is done in this one. Half-edges in ascending order are near each
  /// other in the plane, so that one circle is searched where the last one has just been; and they are shared
  /// among threads. The order within a bucket is of no meaning.
  void collect(std::span<const HalfedgeId> edges, unsigned level) {
    constexpr std::size_t kChunk = 1 << 12;
    std::vector<std::vector<std::pair<unsigned, Candidate>>> lists((edges.size() + kChunk - 1) / kChunk);
    std::atomic<std::size_t> worker{0};
    parallel_chunks(edges.size(), kChunk, watch_.threads, [&] {
      return [&, &counter = counters_[worker++]](std::size_t begin, std::size_t end) {
        if (watch_.stopped()) return;
        for (std::size_t i = begin; i < end; ++i) {
          Candidate candidate;
          const unsigned order = assess(counter, edges[i], candidate);
          if (order <= k_) lists[begin / kChunk].emplace_back(order, candidate);
        }
      };
    });
    for (const auto& list : lists) {
      for (const auto& [order, candidate] : list) buckets_[std::max(order, level)].push_back(candidate);
    }
  }

  /// Takes all candidates that wait at this level, in the order of their new edges' ranks.
  void flip_wave(unsigned level) {
    wave_.clear();
    for (const Candidate& candidate : buckets_[level]) {
      wave_.emplace_back((std::uint64_t{rank_[candidate.c.index()]} << 32) | rank_[candidate.d.index()],
                         candidate);
    }
    buckets_[level].clear();
    std::sort(wave_.begin(), wave_.end(), [](const auto& x, const auto& y) {
      return x.first != y.first ? x.first < y.first : x.second.halfedge < y.second.halfedge;
    });
    for (const auto& [key, candidate] : wave_) {
      if (is_current(candidate)) flip(candidate, level);
    }
    collect_sides(level);
  }

  /// What the flips of a wave have made possible. They are looked at when the wave is over: what a later flip
  /// of the wave has changed again would only have been in vain, and no flip of a wave depends on what an
  /// earlier one of it made possible.
  void collect_sides(unsigned level) {
    sort_sides();
    collect(sides_, level);
    sides_.clear();
  }

  /// Sorts the sides and leaves each once. Many are not compared but marked, a bit for each half-edge.
  void sort_sides() {
    constexpr std::size_t kWord = 64;
    const std::size_t words = outcome_.triangulation.halfedge_count() / kWord + 1;
    if (sides_.size() < words) {
      std::sort(sides_.begin(), sides_.end());
      sides_.erase(std::unique(sides_.begin(), sides_.end()), sides_.end());
      return;
    }
    marks_.assign(words, 0);
    for (const HalfedgeId side : sides_)
      marks_[side.index() / kWord] |= std::uint64_t{1} << side.index() % kWord;
    sides_.clear();
    for (std::size_t i = 0; i < words; ++i) {
      for (std::uint64_t rest = marks_[i]; rest != 0; rest &= rest - 1) {
        sides_.emplace_back(static_cast<std::uint32_t>(i * kWord) +
                            static_cast<std::uint32_t>(std::countr_zero(rest)));
      }
    }
  }

  /// Inner edges stay inner, whatever is flipped.
  bool is_current(const Candidate& candidate) const {
    const Triangulation& t = outcome_.triangulation;
    const HalfedgeId h = candidate.halfedge;
    return t.origin(h) == candidate.a && t.dest(h) == candidate.b && t.apex(h) == candidate.c &&
           t.apex(t.twin(h)) == candidate.d;
  }

  void flip(const Candidate& candidate, unsigned level) {
    Triangulation& t = outcome_.triangulation;
    const HalfedgeId h = t.flip(candidate.halfedge);
    const HalfedgeId twin = t.twin(h);
    outcome_.face_orders[Triangulation::face(h).index()] = candidate.order_at_a;
    outcome_.face_orders[Triangulation::face(twin).index()] = candidate.order_at_b;
    ++outcome_.flips;
    const VertexId pit = ledger_.join(candidate.c, candidate.d);
    if (watch_.keep_trail) {
      outcome_.trail.push_back(
          {TrailStep::Kind::flip, level, candidate.c, candidate.d, candidate.a, candidate.b, pit});
    }
    for (const HalfedgeId side : {Triangulation::next(h), Triangulation::prev(h), Triangulation::next(twin),
                                  Triangulation::prev(twin)}) {
      if (const HalfedgeId other = t.twin(side); other.valid()) sides_.push_back(std::min(side, other));
    }
  }

  const Surface& surface_;
  const Watch& watch_;
  const unsigned k_;
  std::vector<std::uint32_t> rank_;
  std::vector<CircleCounter> counters_;  // one a thread
  PitLedger ledger_;
  std::vector<std::vector<Candidate>> buckets_;
  std::vector<std::pair<std::uint64_t, Candidate>> wave_;
  std::vector<HalfedgeId> sides_;     // of the quadrilaterals flipped in this wave, but for the hull
  std::vector<std::uint64_t> marks_;  // a bit for each half-edge
  Outcome outcome_;
};

}  // namespace

Outcome flip_pits(const Surface& surface, unsigned k, const Watch& watch,
                  std::vector<std::uint32_t>* pits_at) {
  return FlipRun(surface, k, watch).run(pits_at);
}

}  // namespace thalweg::detail
