/// The trail replayed step by step: every flip and every insertion is what the paper allows, and what the
/// step says it is.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "kernel/edge_insertion.hpp"
#include "support/run.hpp"

namespace {

using support::Cloud;
using support::minimize;
using support::Prepared;
using thalweg::HalfedgeId;
using thalweg::Method;
using thalweg::Minimized;
using thalweg::TrailStep;
using thalweg::Triangulation;

/// Place of each site in elevation order, from 0.
std::vector<std::uint32_t> ranks(const std::vector<oracle::Site>& s) {
  std::vector<std::uint32_t> rank(s.size(), 0);
  for (std::uint32_t i = 0; i < s.size(); ++i) {
    for (const oracle::Site& other : s) rank[i] += support::lower(other, s[i]) ? 1u : 0u;
  }
  return rank;
}

std::uint64_t sum_of_lower_ends(const Triangulation& t, const std::vector<std::uint32_t>& rank) {
  std::uint64_t sum = 0;
  for (const auto& [u, v] : oracle::edges_of(support::triangles_of(t))) sum += std::min(rank[u], rank[v]);
  return sum;
}

/// Names of all pits.
std::set<std::uint32_t> pit_names(const Prepared& p, const Triangulation& t) {
  std::set<std::uint32_t> names;
  for (const oracle::Pit& pit : oracle::pits(p.sites, support::triangles_of(t))) {
    names.insert(support::name_of(p.sites, pit));
  }
  return names;
}

oracle::Pair pair_of(thalweg::VertexId u, thalweg::VertexId v) {
  return std::minmax(u.index(), v.index());
}

/// Lemma 4: once ab was present, no cd with min(c, d) >= min(a, b) that crosses it appears.
bool obeys_lemma4(const Prepared& p, const std::set<oracle::Pair>& ever, oracle::Pair fresh,
                  const std::vector<std::uint32_t>& rank) {
  return std::none_of(ever.begin(), ever.end(), [&](const oracle::Pair& old) {
    return oracle::cross(p.sites[old.first], p.sites[old.second], p.sites[fresh.first],
                         p.sites[fresh.second]) &&
           std::min(rank[fresh.first], rank[fresh.second]) >= std::min(rank[old.first], rank[old.second]);
  });
}

/// What holds between any two steps: a triangulation of all sites, by both checkers, of order at most k.
void check_state(const Prepared& p, const Triangulation& t, unsigned k) {
  const auto triangles = support::triangles_of(t);
  RC_ASSERT(!t.find_fault());
  RC_ASSERT(oracle::is_triangulation(p.sites, triangles));
  RC_ASSERT(thalweg::find_faults(p.places, triangles).empty());
  for (const oracle::Tri& triangle : triangles) RC_ASSERT(oracle::triangle_order(p.sites, triangle) <= k);
}

void check_flip_step(const Prepared& p, const TrailStep& step, unsigned k,
                     const std::vector<std::uint32_t>& rank, Triangulation& t) {
  RC_ASSERT(step.kind == TrailStep::Kind::flip);
  RC_ASSERT(step.order <= k);
  HalfedgeId h = t.find_halfedge(step.old_u, step.old_v);
  RC_ASSERT(h.valid() && !t.on_hull(h));
  const std::uint32_t a = step.old_u.index(), b = step.old_v.index(), c = step.u.index(), d = step.v.index();
  RC_ASSERT(pair_of(t.apex(h), t.apex(t.twin(h))) == pair_of(step.u, step.v));
  RC_ASSERT(oracle::cross(p.sites[a], p.sites[b], p.sites[c], p.sites[d]));
  RC_ASSERT(rank[c] < std::min({rank[a], rank[b], rank[d]}));
  RC_ASSERT(oracle::triangle_order(p.sites, a, c, d) <= step.order);
  RC_ASSERT(oracle::triangle_order(p.sites, b, c, d) <= step.order);

  const std::uint64_t sum = sum_of_lower_ends(t, rank);
  const auto before = pit_names(p, t);
  t.flip(h);
  check_state(p, t, step.order);
  RC_ASSERT(sum_of_lower_ends(t, rank) < sum);

  const auto after = pit_names(p, t);
  const bool removes = step.pit.valid();
  RC_ASSERT(after.size() + (removes ? 1 : 0) == before.size());
  if (removes) RC_ASSERT(before.count(step.pit.index()) == 1u);
  if (removes) RC_ASSERT(after.count(step.pit.index()) == 0u);
}

RC_GTEST_PROP(FlipTrailLaws, EveryStepIsAllowed, ()) {
  const Cloud cloud = *support::clouds(25);
  const unsigned k = *rc::gen::inRange(0u, 9u);
  const Prepared p(cloud);
  const Minimized m = minimize(cloud, Method::flip, k);
  const auto rank = ranks(p.sites);
  Triangulation t = p.delaunay;
  std::set<oracle::Pair> ever;
  for (const oracle::Pair& e : oracle::edges_of(support::triangles_of(t))) ever.insert(e);
  unsigned round = 0;
  RC_ASSERT(m.flips == m.trail.size());
  RC_ASSERT(m.insertions == 0u);
  for (const TrailStep& step : m.trail) {
    RC_ASSERT(step.order >= round);
    round = step.order;
    check_flip_step(p, step, k, rank, t);
    const oracle::Pair fresh = pair_of(step.u, step.v);
    RC_ASSERT(obeys_lemma4(p, ever, fresh, rank));
    RC_ASSERT(ever.insert(fresh).second);  // an edge flipped out never returns
  }
  RC_ASSERT(oracle::normal_form(support::triangles_of(t)) ==
            oracle::normal_form(support::triangles_of(m.triangulation)));
}

/// The heuristic stops only when no flip is left that it may do.
RC_GTEST_PROP(FlipTrailLaws, NothingIsLeftToFlip, ()) {
  const Cloud cloud = *support::clouds(30);
  const unsigned k = *rc::gen::inRange(1u, 9u);
  const Prepared p(cloud);
  const auto rank = ranks(p.sites);
  const Minimized m = minimize(cloud, Method::flip, k);
  const Triangulation& t = m.triangulation;
  for (std::uint32_t i = 0; i < t.halfedge_count(); ++i) {
    const HalfedgeId h(i);
    if (t.on_hull(h)) continue;
    const std::uint32_t a = t.origin(h).index(), b = t.dest(h).index(), c = t.apex(h).index(),
                        d = t.apex(t.twin(h)).index();
    if (std::min(rank[c], rank[d]) > std::min(rank[a], rank[b])) continue;
    if (!oracle::cross(p.sites[a], p.sites[b], p.sites[c], p.sites[d])) continue;
    RC_ASSERT(std::max(oracle::triangle_order(p.sites, a, c, d), oracle::triangle_order(p.sites, b, c, d)) >
              k);
  }
}

RC_GTEST_PROP(FlipTrailLaws, LargerOrderGoesOnWhereSmallerEnds, ()) {
  const Cloud cloud = *support::clouds(40);
  const unsigned k = *rc::gen::inRange(0u, 8u);
  for (const Method method : {Method::flip, Method::hull}) {
    const Minimized here = minimize(cloud, method, k), further = minimize(cloud, method, k + 1);
    RC_ASSERT(here.trail.size() <= further.trail.size());
    for (std::size_t i = 0; i < here.trail.size(); ++i) {
      RC_ASSERT(here.trail[i].u == further.trail[i].u && here.trail[i].v == further.trail[i].v);
      RC_ASSERT(here.trail[i].order == further.trail[i].order);
    }
    if (further.trail.size() > here.trail.size()) {
      RC_ASSERT(further.trail[here.trail.size()].order == k + 1);
    }
  }
}

RC_GTEST_PROP(HullTrailLaws, EveryStepIsAllowed, ()) {
  const Cloud cloud = *support::clouds(25);
  const unsigned k = *rc::gen::inRange(0u, 9u);
  const Prepared p(cloud);
  const Minimized m = minimize(cloud, Method::hull, k);
  RC_ASSERT(m.insertions == m.trail.size());
  RC_ASSERT(m.flips == 0u);
  unsigned order = 0;
  for (std::size_t i = 0; i < m.trail.size(); ++i) {
    const TrailStep& step = m.trail[i];
    RC_ASSERT(step.kind == TrailStep::Kind::insertion);
    RC_ASSERT(step.order >= order && step.order <= k);
    order = step.order;
    const std::uint32_t u = step.u.index(), v = step.v.index();
    RC_ASSERT(oracle::useful_order(p.sites, u, v) == step.order);
    RC_ASSERT(p.sites[v].z <= p.sites[u].z);
    RC_ASSERT(!p.delaunay.joined(step.u, step.v));
    RC_ASSERT(m.triangulation.joined(step.u, step.v));
    RC_ASSERT(step.pit.valid());
    for (std::size_t j = 0; j < i; ++j) {
      RC_ASSERT(!oracle::cross(p.sites[u], p.sites[v], p.sites[m.trail[j].u.index()],
                               p.sites[m.trail[j].v.index()]));
    }
  }
  RC_ASSERT(m.pits.total + m.trail.size() <= m.delaunay_pits.total);
  for (const TrailStep& step : m.trail) RC_ASSERT(p.sites[step.pit.index()].z == p.sites[step.u.index()].z);
}

/// The faces of the Delaunay triangulation that the open segment uv passes through.
std::vector<thalweg::FaceId> faces_under(const Prepared& p, std::uint32_t u, std::uint32_t v) {
  std::set<thalweg::FaceId> faces;
  for (std::uint32_t i = 0; i < p.delaunay.halfedge_count(); ++i) {
    const HalfedgeId h(i);
    const std::uint32_t a = p.delaunay.origin(h).index(), b = p.delaunay.dest(h).index();
    if (oracle::cross(p.sites[u], p.sites[v], p.sites[a], p.sites[b])) faces.insert(Triangulation::face(h));
  }
  return {faces.begin(), faces.end()};
}

/// The insertions done again one by one, as the paper says it: the faces under the edge, none of them marked
/// by an earlier one, give way to the constrained Delaunay triangles beside it, and are marked.
RC_GTEST_PROP(HullTrailLaws, EveryStepKeepsTheLaws, ()) {
  const Cloud cloud = *support::clouds(25);
  const unsigned k = *rc::gen::inRange(0u, 9u);
  const Prepared p(cloud);
  const Minimized m = minimize(cloud, Method::hull, k);
  Triangulation t = p.delaunay;
  std::set<thalweg::FaceId> marked;
  thalweg::detail::EdgeInsertion insertion;
  for (const TrailStep& step : m.trail) {
    const auto faces = faces_under(p, step.u.index(), step.v.index());
    for (const thalweg::FaceId f : faces) RC_ASSERT(marked.insert(f).second);
    const auto before = pit_names(p, t);
    RC_ASSERT(before.count(step.pit.index()) == 1u);
    RC_ASSERT(insertion.plan(t, p.places, step.u, step.v));
    std::vector<thalweg::FaceId> planned(insertion.faces().begin(), insertion.faces().end());
    std::sort(planned.begin(), planned.end());
    RC_ASSERT(planned == faces);
    insertion.apply(t);
    check_state(p, t, step.order);
    RC_ASSERT(t.joined(step.u, step.v));
    const auto after = pit_names(p, t);
    RC_ASSERT(after.size() < before.size());
    RC_ASSERT(after.count(step.pit.index()) == 0u);
  }
  RC_ASSERT(oracle::normal_form(support::triangles_of(t)) ==
            oracle::normal_form(support::triangles_of(m.triangulation)));
}

/// Joining two lakes left the one that keeps its name reported as removed.
TEST(HullTrail, NamesTheLakeThatIsNoMore) {
  const Cloud cloud{{{65, 0, 0}, {60, 25, 0}, {0, 0, 1}, {62, 16, 1}}};
  const Minimized m = minimize(cloud, Method::hull, 1);
  ASSERT_EQ(m.trail.size(), 1u);
  EXPECT_EQ(m.trail[0].pit.index(), 0u);
}

/// No triangle of the result has its circle around a site that it could see: away from the inserted edges the
/// terrain is still Delaunay.
RC_GTEST_PROP(HullTrailLaws, ResultIsConstrainedDelaunay, ()) {
  const Cloud cloud = *support::clouds(25);
  const unsigned k = *rc::gen::inRange(0u, 9u);
  const Prepared p(cloud);
  const Minimized m = minimize(cloud, Method::hull, k);
  std::set<oracle::Pair> inserted;
  for (const TrailStep& step : m.trail) inserted.insert(pair_of(step.u, step.v));
  const Triangulation& t = m.triangulation;
  for (std::uint32_t i = 0; i < t.halfedge_count(); ++i) {
    const HalfedgeId h(i);
    if (t.on_hull(h) || inserted.count(pair_of(t.origin(h), t.dest(h))) > 0) continue;
    RC_ASSERT(oracle::in_circle(p.sites[t.origin(h).index()], p.sites[t.dest(h).index()],
                                p.sites[t.apex(h).index()], p.sites[t.apex(t.twin(h)).index()]) <= 0);
  }
}

RC_GTEST_PROP(BestTrailLaws, CountsItsSteps, ()) {
  const Cloud cloud = *support::clouds(30);
  const unsigned k = *rc::gen::inRange(0u, 9u);
  const Minimized m = minimize(cloud, Method::best, k);
  const auto flips = static_cast<std::uint64_t>(std::count_if(
      m.trail.begin(), m.trail.end(), [](const TrailStep& s) { return s.kind == TrailStep::Kind::flip; }));
  RC_ASSERT(m.flips == flips);
  RC_ASSERT(m.insertions == m.trail.size() - flips);
  for (const TrailStep& step : m.trail) RC_ASSERT(step.order <= k);
}

}  // namespace
