/// Every algorithm on every case of the degenerate corpus: the right error, or a result that holds by
/// definition.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "oracle/exact_predicates.hpp"
#include "oracle/voronoi.hpp"
#include "support/brute.hpp"
#include "support/corpus.hpp"
#include "support/delaunay_check.hpp"
#include "support/run.hpp"
#include "thalweg/thalweg.hpp"

namespace {

using support::Rows;
using thalweg::ErrorCode;
using thalweg::FaceId;
using thalweg::Method;
using thalweg::Minimized;
using thalweg::MinimizeOptions;
using thalweg::Point2;
using thalweg::Triangulation;
using thalweg::VertexId;

constexpr std::size_t kFew = 9;  ///< sites, of which all triangulations can be looked at at once

std::vector<support::CorpusCase> cases() {
  return support::corpus(THALWEG_TEST_DATA "/../corpus");
}

class Corpus : public testing::TestWithParam<support::CorpusCase> {
 protected:
  Corpus()
      : points_(GetParam().points), places_(GetParam().places()), rows_(support::distinct_rows(places_)) {}

  /// Whether there is anything to triangulate; if not, expects `result` to say why.
  template <class T>
  bool expect_verdict(const thalweg::Result<T>& result) const {
    if (rows_.size() >= 3 && !support::all_collinear(places_, rows_)) {
      EXPECT_TRUE(result) << result.error().message;
      return static_cast<bool>(result);
    }
    EXPECT_FALSE(result);
    if (result) return false;
    const auto expected = rows_.size() < 3 ? ErrorCode::too_few_points : ErrorCode::all_collinear;
    EXPECT_EQ(result.error().code, expected) << result.error().message;
    return false;
  }

  std::vector<std::array<std::uint32_t, 3>> triangles_over_sites(const Triangulation& t) const {
    auto triangles = support::triangles_of(t);
    std::vector<std::uint32_t> place(places_.size());
    std::vector<bool> used(places_.size());
    for (const auto& triangle : triangles) {
      for (const std::uint32_t v : triangle) used[v] = true;
    }
    std::uint32_t next = 0;
    for (std::size_t v = 0; v < place.size(); ++v) place[v] = used[v] ? next++ : 0;
    for (auto& triangle : triangles) {
      for (std::uint32_t& v : triangle) v = place[v];
    }
    return triangles;
  }

  /// The places of the vertices that are not isolated.
  std::vector<Point2> used_places(const Triangulation& t) const {
    std::vector<Point2> result;
    for (std::uint32_t v = 0; v < places_.size(); ++v) {
      if (!t.isolated(VertexId(v))) result.push_back(places_[v]);
    }
    return result;
  }

  void expect_sound(const Triangulation& t) const {
    EXPECT_EQ(t.find_fault(), std::nullopt);
    const std::vector<Point2> used = used_places(t);
    EXPECT_EQ(used.size(), rows_.size());
    EXPECT_TRUE(thalweg::find_faults(used, triangles_over_sites(t)).empty());
  }

  Minimized expect_honest(Method method, unsigned k) const {
    SCOPED_TRACE(std::string(support::method_name(method)) + " at order " + std::to_string(k));
    MinimizeOptions options;
    options.order = k;
    options.method = method;
    options.threads = 2;
    // Only the invariants of what is found in time are asked for; few sites take no time.
    options.time_limit = rows_.size() <= kFew ? 0 : 0.02;
    const auto result = thalweg::minimize_pits(points_, options);
    if (!expect_verdict(result)) return {};
    const Minimized& m = *result;
    expect_sound(m.triangulation);
    EXPECT_EQ(m.sites, rows_.size());
    EXPECT_EQ(m.merged.size(), points_.size() - rows_.size());
    EXPECT_EQ(m.face_orders.size(), m.triangulation.face_count());
    for (std::uint32_t f = 0; f < m.triangulation.face_count(); ++f) {
      const auto [a, b, c] = m.triangulation.corners(FaceId(f));
      EXPECT_EQ(m.face_orders[f], support::sites_in_circle(places_, rows_, a.index(), b.index(), c.index()));
      EXPECT_LE(m.face_orders[f], k);
    }
    std::vector<double> z;
    for (const thalweg::Point3& p : points_) z.push_back(p.z);
    EXPECT_EQ(thalweg::find_pits(m.triangulation, z).count(), m.pits);
    EXPECT_LE(m.pits.total, m.delaunay_pits.total);
    EXPECT_LE(m.lower_bound, m.pits.total);
    EXPECT_EQ(m.certified, m.lower_bound == m.pits.total);
    EXPECT_EQ(m.remaining.size(), m.pits.total);
    return *result;
  }

  const std::vector<thalweg::Point3>& points_;
  const std::vector<Point2> places_;
  const Rows rows_;
};

TEST_P(Corpus, SaysWhyItIsThere) {
  EXPECT_FALSE(GetParam().why.empty());
  for (const thalweg::Point3& p : points_) EXPECT_TRUE(std::isfinite(p.x + 0 * p.y + 0 * p.z));
}

TEST_P(Corpus, Delaunay) {
  const auto t = thalweg::delaunay(places_);
  if (!expect_verdict(t)) return;
  EXPECT_EQ(support::fault_of(places_, *t), "");
  expect_sound(*t);
  const std::vector<Point2> reversed(places_.rbegin(), places_.rend());
  const auto again = thalweg::delaunay(reversed);
  ASSERT_TRUE(again);
  EXPECT_EQ(support::triangle_set(places_, *t), support::triangle_set(reversed, *again));
}

TEST_P(Corpus, MissingTriangleIsFound) {
  const auto t = thalweg::delaunay(places_);
  if (!expect_verdict(t)) return;
  auto triangles = triangles_over_sites(*t);
  triangles.pop_back();
  EXPECT_FALSE(thalweg::find_faults(used_places(*t), triangles).empty());
  triangles.push_back({0, 0, 1});
  EXPECT_FALSE(thalweg::find_faults(used_places(*t), triangles).empty());
}

TEST_P(Corpus, CountersAgreeWithLookingAtEverySite) {
  const auto t = thalweg::delaunay(places_);
  if (!expect_verdict(t)) return;
  const unsigned k = std::min<unsigned>(5, static_cast<unsigned>(rows_.size()));
  const auto diagram = thalweg::order_k_voronoi(places_, k);
  ASSERT_TRUE(diagram);
  const thalweg::DelaunayGraph graph(places_, *t);
  thalweg::CircleCounter crawl(graph);
  thalweg::VoronoiCounter located(*diagram);
  const std::size_t step = 1 + rows_.size() / 12;
  for (std::size_t i = 0; i < rows_.size(); i += step) {
    for (std::size_t j = 0; j < rows_.size(); j += step) {
      for (std::size_t l = 0; l < rows_.size(); l += step) {
        const std::uint32_t a = rows_[i], b = rows_[j], c = rows_[l];
        if (thalweg::orient2d(places_[a], places_[b], places_[c]) <= 0) continue;
        const unsigned count = std::min(k, support::sites_in_circle(places_, rows_, a, b, c));
        EXPECT_EQ(crawl.count_in_circle(VertexId(a), VertexId(b), VertexId(c), k - 1), count);
        EXPECT_EQ(located.count_in_circle(VertexId(a), VertexId(b), VertexId(c), k - 1), count);
      }
    }
  }
}

TEST_P(Corpus, UsefulPairsAreThoseOfTheDefinition) {
  const auto t = thalweg::delaunay(places_);
  if (!expect_verdict(t)) return;
  constexpr unsigned k = 3;
  const thalweg::DelaunayGraph graph(places_, *t);
  std::vector<thalweg::UsefulPair> expected;
  for (const std::uint32_t u : rows_) {
    for (const std::uint32_t v : rows_) {
      if (u >= v) continue;
      const auto order = support::useful_order_of(places_, rows_, u, v);
      if (order && *order <= k) expected.push_back({VertexId(u), VertexId(v), *order});
    }
  }
  EXPECT_EQ(thalweg::useful_pairs(graph, k), expected);
}

TEST_P(Corpus, OrderKVoronoiFindsTheNearest) {
  for (const unsigned k : {1u, 2u, 4u}) {
    const auto diagram = thalweg::order_k_voronoi(places_, k);
    ASSERT_EQ(static_cast<bool>(diagram), k <= rows_.size()) << k;
    if (!diagram) continue;
    std::vector<Point2> sites;
    for (const std::uint32_t row : rows_) sites.push_back(places_[row]);
    for (std::size_t i = 0; i < sites.size(); ++i) {
      const Point2 p = sites[i], r = sites[(7 * i + 1) % sites.size()];
      for (const Point2 q : {p, Point2{p.x / 2 + r.x / 2, p.y / 2 + r.y / 2}, Point2{r.y, -p.x}}) {
        std::vector<VertexId> expected;
        for (const std::uint32_t site : oracle::k_nearest(sites, q, k)) expected.emplace_back(rows_[site]);
        EXPECT_EQ(diagram->nearest(q), expected);
      }
    }
  }
}

TEST_P(Corpus, EveryMethodKeepsItsPromises) {
  for (const unsigned k : {0u, 1u, 4u}) {
    expect_honest(Method::delaunay, k);
    const Minimized flip = expect_honest(Method::flip, k), hull = expect_honest(Method::hull, k);
    const Minimized best = expect_honest(Method::best, k), exact = expect_honest(Method::exact, k);
    EXPECT_LE(best.pits.total, std::min(flip.pits.total, hull.pits.total));
    EXPECT_LE(exact.pits.total, best.pits.total);
  }
}

TEST_P(Corpus, ExactIsTheFewestOfAllTriangulations) {
  const bool whole = std::all_of(places_.begin(), places_.end(), [](Point2 p) {
    return p.x == std::floor(p.x) && p.y == std::floor(p.y) && std::abs(p.x) < 1e6 && std::abs(p.y) < 1e6;
  });
  if (!whole || rows_.size() > kFew || rows_.size() < points_.size() || rows_.size() < 3) return;
  const auto sites = oracle::sites_of(std::span<const thalweg::Point3>(points_));
  const std::vector<std::size_t> fewest = oracle::fewest_pits(sites);
  for (unsigned k = 0; k < fewest.size(); ++k) {
    const Minimized exact = expect_honest(Method::exact, k);
    EXPECT_TRUE(exact.certified);
    EXPECT_EQ(exact.pits.total, fewest[k]) << k;
  }
}

TEST_P(Corpus, SweepIsTheSameAsRuns) {
  const auto sweep = thalweg::sweep_pits(points_, 0, 4);
  if (!expect_verdict(sweep)) return;
  for (const thalweg::SweepRow& row : sweep->rows) {
    EXPECT_EQ(row.flip, expect_honest(Method::flip, row.order).pits.total);
    EXPECT_EQ(row.hull, expect_honest(Method::hull, row.order).pits.total);
    EXPECT_EQ(row.best, expect_honest(Method::best, row.order).pits.total);
  }
}

INSTANTIATE_TEST_SUITE_P(Degenerate, Corpus, testing::ValuesIn(cases()),
                         [](const auto& instance) { return instance.param.name; });

}  // namespace
