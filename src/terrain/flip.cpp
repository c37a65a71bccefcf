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
#include "kernel/prefetch.hpp"
#include "kernel/radix_sort.hpp"
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

/// The circles through c, d and a, and through c, d and b, where a and b are on different sides of cd.
///
/// Of two circles through c and d, that which reaches further on one side of the line reaches less far on the
/// other. So a is inside the circle of b iff b is inside that of a. If they are, all that the circle of a
/// holds on a's side of the line, or on the line, is inside that of b too; if they are not, all that it holds
/// on b's side or on the line.
class CirclePair {
 public:
  explicit CirclePair(const DelaunayGraph& graph) : graph_(&graph), counter_(graph) {}

  /// Fills in the orders of a candidate. If one of them is more than k, the other may be missing. Returns
  /// the larger. Few circles that are larger than their partner hold fewer sites: that one is looked at
  /// first.
  unsigned find_orders(Candidate& candidate, unsigned k) {
    auto& [halfedge, a, b, c, d, order_at_a, order_at_b] = candidate;
    return is_larger(c, d, b, a) ? count(d, c, b, a, k, order_at_b, order_at_a)
                                 : count(c, d, a, b, k, order_at_a, order_at_b);
  }

  std::uint64_t counts() const noexcept { return counter_.calls(); }

 private:
  /// The orders of d, c, a and then of c, d, b. Requires: d, c, a counter-clockwise.
  unsigned count(VertexId c, VertexId d, VertexId a, VertexId b, unsigned k, unsigned& at_a, unsigned& at_b) {
    const auto at = [&](VertexId v) { return graph_->point(v); };
    const bool hold_each_other = incircle_sign(at(d), at(c), at(a), at(b)) > 0;
    at_a = counter_.count_in_circle(d, c, a, k, std::span(&b, hold_each_other ? 1 : 0));
    if (at_a > k) return at_a;
    shared_.clear();
    if (hold_each_other) shared_.push_back(a);
    for (const VertexId site : counter_.inside()) {
      const int side = orient2d_sign(at(d), at(c), at(site));  // positive: on a's
      if (hold_each_other ? side >= 0 : side <= 0) shared_.push_back(site);
    }
    at_b = counter_.count_in_circle(c, d, b, k, shared_);
    return std::max(at_a, at_b);
  }

  /// Whether, but for rounding, the circle through c, d, p is larger than that through c, d, q: it is where
  /// cd is seen under an angle with a smaller sine.
  bool is_larger(VertexId c, VertexId d, VertexId p, VertexId q) const noexcept {
    const auto [cross_p, product_p] = squared_sine(graph_->point(c), graph_->point(d), graph_->point(p));
    const auto [cross_q, product_q] = squared_sine(graph_->point(c), graph_->point(d), graph_->point(q));
    return cross_p * product_q < cross_q * product_p;
  }

  /// The squared sine of the angle under which p sees cd: numerator and denominator, rounded.
  static std::pair<double, double> squared_sine(Point2 c, Point2 d, Point2 p) noexcept {
    const double cx = c.x - p.x, cy = c.y - p.y, dx = d.x - p.x, dy = d.y - p.y;
    const double cross = cx * dy - cy * dx;
    return {cross * cross, (cx * cx + cy * cy) * (dx * dx + dy * dy)};
  }

  const DelaunayGraph* graph_;
  CircleCounter counter_;
  std::vector<VertexId> shared_;  // sites that are known to be inside the second circle
};

class FlipRun {
 public:
  FlipRun(const Surface& surface, unsigned k, const Watch& watch)
      : surface_(surface), watch_(watch), k_(k), rank_(surface.ranks(watch.threads)), ledger_(surface) {
    // A copy: on rough ground flips touch nearly every stretch of a revision.
    outcome_.triangulation = surface.delaunay();
    outcome_.face_orders.assign(outcome_.triangulation.face_count(), 0);
    for (unsigned i = 0; i < watch.threads; ++i) {
      workers_.push_back({CirclePair(surface.graph()), std::vector<Array<Candidate>>(k + std::size_t{1})});
    }
  }

  Outcome run(std::vector<std::uint32_t>* pits_at) {
    if (k_ > 0) collect_all();
    if (pits_at != nullptr) pits_at->assign(1, ledger_.left());
    for (unsigned level = 1; level <= k_ && !watch_.stopped(); ++level) {
      while (next_wave(level) && !watch_.stopped()) flip_wave(level);
      if (pits_at != nullptr) pits_at->push_back(ledger_.left());
      watch_.report("flipping", static_cast<double>(level) / k_);
    }
    outcome_.pits = ledger_.left();
    for (const Worker& worker : workers_) outcome_.circle_counts += worker.circles.counts();
    return std::move(outcome_);
  }

 private:
  /// What one thread has for itself.
  struct Worker {
    CirclePair circles;
    std::vector<Array<Candidate>> buckets;  // by order; their order within is of no meaning
  };

  bool is_lower(VertexId u, VertexId v) const noexcept { return rank_[u.index()] < rank_[v.index()]; }

  /// The one half-edge of the face f whose flip may lower something: the apex is the lowest of the four
  /// corners. Invalid if there is none.
  HalfedgeId flip_from(FaceId f) const noexcept {
    const Triangulation& t = outcome_.triangulation;
    HalfedgeId h = Triangulation::halfedge(f);
    HalfedgeId lowest = h;  // leads away from the lowest corner
    for (h = Triangulation::next(h); h != Triangulation::halfedge(f); h = Triangulation::next(h)) {
      if (is_lower(t.origin(h), t.origin(lowest))) lowest = h;
    }
    const HalfedgeId opposite = Triangulation::next(lowest);
    const HalfedgeId twin = t.twin(opposite);
    return twin.valid() && is_lower(t.origin(lowest), t.apex(twin)) ? opposite : HalfedgeId();
  }

  /// That half-edge of an edge whose apex is the lowest of the four corners; invalid if it is neither.
  HalfedgeId flip_of(HalfedgeId h) const noexcept {
    const Triangulation& t = outcome_.triangulation;
    if (t.on_hull(h)) return HalfedgeId();
    if (is_lower(t.apex(t.twin(h)), t.apex(h))) h = t.twin(h);
    const VertexId c = t.apex(h);
    return is_lower(c, t.origin(h)) && is_lower(c, t.dest(h)) ? h : HalfedgeId();
  }

  void collect_all() {
    collect(outcome_.triangulation.face_count(), 0,
            [&](std::size_t i) { return flip_from(FaceId(static_cast<std::uint32_t>(i))); });
  }

  /// Puts the candidates among `count` half-edges into the buckets, at `level` at least: what a lower round
  /// would have done, had it been possible then, is done in this one. They are shared among threads, and such
  /// as follow each other should be near each other, so that one circle is searched where the last one has
  /// just been.
  template <class HalfedgeAt>
  void collect(std::size_t count, unsigned level, HalfedgeAt&& halfedge_at) {
    constexpr std::size_t kChunk = 1 << 12;
    std::atomic<std::size_t> next_worker{0};
    parallel_chunks(count, kChunk, watch_.threads, [&] {
      return [&, &worker = workers_[next_worker++]](std::size_t begin, std::size_t end) {
        if (watch_.stopped()) return;
        for (std::size_t i = begin; i < end; ++i) {
          if (const HalfedgeId h = halfedge_at(i); h.valid()) assess(worker, h, level);
        }
      };
    });
  }

  /// Puts the flip of h into its bucket, if it is one and its order is not too high.
  void assess(Worker& worker, HalfedgeId h, unsigned level) const {
    const Triangulation& t = outcome_.triangulation;
    const VertexId a = t.origin(h), b = t.dest(h), c = t.apex(h), d = t.apex(t.twin(h));
    const auto at = [&](VertexId v) { return surface_.sites()[v.index()]; };
    if (orient2d_sign(at(d), at(c), at(a)) <= 0 || orient2d_sign(at(d), at(c), at(b)) >= 0) return;
    Candidate candidate{h, a, b, c, d, 0, 0};
    const unsigned order = worker.circles.find_orders(candidate, k_);
    if (order <= k_) worker.buckets[std::max({1u, order, level})].push_back(candidate);
  }

  /// Takes all candidates that wait at this level, in the order of their new edges' ranks. Returns whether
  /// there are any.
  bool next_wave(unsigned level) {
    wave_.clear();
    wave_.swap(workers_[0].buckets[level]);
    for (std::size_t i = 1; i < workers_.size(); ++i) {
      Array<Candidate>& more = workers_[i].buckets[level];
      wave_.insert(wave_.end(), more.begin(), more.end());
      more.clear();
    }
    order_.resize(wave_.size());
    for (std::uint32_t i = 0; i < wave_.size(); ++i) order_[i] = keyed_row(rank_[wave_[i].c.index()], i);
    radix_sort(order_, watch_.threads);
    sort_runs(order_, [&](std::uint32_t x, std::uint32_t y) {
      const VertexId d_x = wave_[x].d, d_y = wave_[y].d;
      return d_x != d_y ? is_lower(d_x, d_y) : wave_[x].halfedge < wave_[y].halfedge;
    });
    return !wave_.empty();
  }

  const Candidate& in_order(std::size_t i) const noexcept { return wave_[row_of(order_[i])]; }

  /// Asks for the memory that the candidates after the i-th will need, which in the order of ranks lie all
  /// over the terrain. In three steps, since one tells where the next leads.
  void approach(std::size_t i) const noexcept {
    constexpr std::size_t kFirst = 64, kSecond = 32, kThird = 16;
    if (i + kFirst < order_.size()) prefetch(&in_order(i + kFirst));
    if (i + kSecond < order_.size()) {
      const Candidate& candidate = in_order(i + kSecond);
      prefetch_face(candidate.halfedge);
      surface_.prefetch_elevation(candidate.c);
      surface_.prefetch_elevation(candidate.d);
    }
    if (i + kThird < order_.size()) {
      // Flips renumber half-edges: this one may be another edge's by now, one on the hull.
      const HalfedgeId twin = outcome_.triangulation.twin(in_order(i + kThird).halfedge);
      if (twin.valid()) prefetch_face(twin);
    }
  }

  void prefetch_face(HalfedgeId h) const noexcept {
    const std::uint32_t face = Triangulation::face(h).index();
    for (const std::uint32_t corner : {3 * face, 3 * face + 2}) {  // the two may lie in different lines
      prefetch(&outcome_.triangulation.origins()[corner]);
      prefetch(&outcome_.triangulation.twins()[corner]);
    }
    prefetch(&outcome_.face_orders[face]);
  }

  void flip_wave(unsigned level) {
    for (std::size_t i = 0; i < order_.size(); ++i) {
      approach(i);
      if (is_current(in_order(i))) flip(in_order(i), level);
    }
    collect_sides(level);
  }

  /// What the flips of a wave have made possible. They are looked at when the wave is over: what a later flip
  /// of the wave has changed again would only have been in vain, and no flip of a wave depends on what an
  /// earlier one of it made possible.
  void collect_sides(unsigned level) {
    sort_sides();
    collect(sides_.size(), level, [&](std::size_t i) { return flip_of(sides_[i]); });
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

  /// A half-edge that still leads from a to b is that edge's, which was inner and so has a twin.
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
  Array<std::uint32_t> rank_;
  std::vector<Worker> workers_;  // one a thread
  PitLedger ledger_;
  Array<Candidate> wave_;
  Array<KeyedRow> order_;       // in which the wave is taken
  Array<HalfedgeId> sides_;     // of the quadrilaterals flipped in this wave, but for the hull
  Array<std::uint64_t> marks_;  // a bit for each half-edge
  Outcome outcome_;
};

}  // namespace

Outcome flip_pits(const Surface& surface, unsigned k, const Watch& watch,
                  std::vector<std::uint32_t>* pits_at) {
  return FlipRun(surface, k, watch).run(pits_at);
}

}  // namespace thalweg::detail
