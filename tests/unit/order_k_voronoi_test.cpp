/// The order-k Voronoi diagram: sizes, small and degenerate sets, many queries, polygons, errors.
#include "thalweg/order_k_voronoi.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "oracle/exact_predicates.hpp"
#include "oracle/voronoi.hpp"
#include "support/cloud.hpp"
#include "support/random.hpp"
#include "thalweg/circle_count.hpp"
#include "thalweg/delaunay.hpp"
#include "thalweg/predicates.hpp"
#include "thalweg/voronoi_counter.hpp"

namespace {

using support::Random;
using thalweg::CellId;
using thalweg::ErrorCode;
using thalweg::OrderKVoronoi;
using thalweg::Point2;
using thalweg::VertexId;
using thalweg::VoronoiHalfedgeId;
using thalweg::VoronoiVertexId;

OrderKVoronoi diagram_of(const std::vector<Point2>& points, unsigned k, unsigned threads = 1) {
  auto result = thalweg::order_k_voronoi(points, k, {.threads = threads});
  EXPECT_TRUE(static_cast<bool>(result));
  return std::move(*result);
}

/// An integer point of [0, n)^2.
Point2 random_point(Random& random, int n) {
  return {random.whole(0, n - 1), random.whole(0, n - 1)};
}

std::vector<Point2> random_points(std::size_t count, int size, std::uint64_t seed) {
  Random random(seed);
  std::set<std::pair<double, double>> distinct;
  std::vector<Point2> points;
  while (points.size() < count) {
    const Point2 p = random_point(random, size);
    if (distinct.emplace(p.x, p.y).second) points.push_back(p);
  }
  return points;
}

std::vector<Point2> grid(int width, int height) {
  std::vector<Point2> points;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) points.push_back({static_cast<double>(x), static_cast<double>(y)});
  }
  return points;
}

std::uint32_t unbounded_cells(const OrderKVoronoi& diagram) {
  std::uint32_t count = 0;
  for (std::uint32_t c = 0; c < diagram.cell_count(); ++c) count += diagram.unbounded(CellId(c));
  return count;
}

std::vector<std::uint32_t> rows(const std::vector<VertexId>& sites) {
  std::vector<std::uint32_t> result;
  for (const VertexId v : sites) result.push_back(v.index());
  return result;
}

/// Nearest by scanning all points: integer coordinates and queries, below 2^25.
std::vector<std::uint32_t> scan(const std::vector<Point2>& points, Point2 q, std::size_t k) {
  std::vector<std::tuple<double, double, double, std::uint32_t>> keys;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const double x = points[i].x - q.x, y = points[i].y - q.y;
    keys.emplace_back(x * x + y * y, points[i].x, points[i].y, i);
  }
  std::partial_sort(keys.begin(), keys.begin() + static_cast<std::ptrdiff_t>(k), keys.end());
  std::vector<std::uint32_t> result;
  for (std::size_t i = 0; i < k; ++i) result.push_back(std::get<3>(keys[i]));
  return result;
}

/// Lee's formula: 2 k n - k^2 - n + 1 - the unbounded cells of all lower orders.
std::int64_t lee(std::int64_t n, std::int64_t k, std::int64_t unbounded_below) {
  return 2 * k * n - k * k - n + 1 - unbounded_below;
}

/// Refused before any of them is read.
TEST(OrderKVoronoi, RefusesMoreSitesThanIdsCanNumber) {
  const Point2 only{0, 0};
  const auto diagram = order_k_voronoi(std::span(&only, VertexId::kInvalid), 1);
  ASSERT_FALSE(diagram);
  EXPECT_EQ(diagram.error().code, ErrorCode::too_many_points);
}

TEST(OrderKVoronoi, HasAsManyCellsAsLeeSays) {
  // First the formula itself, on small sets by testing every circle: a cell is unbounded if a line cuts it
  // off.
  const auto few = random_points(9, 1000, 5);
  const auto sites = oracle::sites_of(few);
  std::int64_t unbounded = 0;
  for (unsigned k = 1; k < few.size(); ++k) {
    const oracle::Voronoi expected = oracle::voronoi(sites, k);
    EXPECT_EQ(static_cast<std::int64_t>(expected.cells.size()), lee(9, k, unbounded)) << k;
    // Half-planes with k - 1 sites inside: as many rays as unbounded cells.
    for (std::size_t a = 0; a < sites.size(); ++a) {
      for (std::size_t b = 0; b < sites.size(); ++b) {
        const auto left = std::count_if(sites.begin(), sites.end(), [&](const oracle::Site& s) {
          return oracle::turn(sites[a], sites[b], s) > 0;
        });
        unbounded += a != b && left == static_cast<std::int64_t>(k) - 1;
      }
    }
  }
  const auto many = random_points(500, 1 << 24, 7);
  unbounded = 0;
  for (unsigned k = 1; k < 14; ++k) {
    const OrderKVoronoi diagram = diagram_of(many, k);
    EXPECT_EQ(static_cast<std::int64_t>(diagram.cell_count()), lee(500, k, unbounded)) << k;
    unbounded += unbounded_cells(diagram);
  }
}

TEST(OrderKVoronoi, OfOrderOneIsTheDualOfDelaunay) {
  for (const auto& points : {grid(7, 5), random_points(100, 30, 3)}) {
    const auto mesh = thalweg::delaunay(points);
    const OrderKVoronoi diagram = diagram_of(points, 1);
    std::set<std::pair<VertexId, VertexId>> joined;
    for (std::uint32_t h = 0; h < mesh->halfedge_count(); ++h) {
      const thalweg::HalfedgeId edge(h);
      joined.insert(std::minmax(mesh->origin(edge), mesh->dest(edge)));
    }
    const auto edges = diagram.delaunay_edges();
    EXPECT_TRUE(std::equal(edges.begin(), edges.end(), joined.begin(), joined.end()));
    EXPECT_EQ(diagram.cell_count(), points.size());
  }
}

TEST(OrderKVoronoi, OfFewSites) {
  EXPECT_EQ(rows(diagram_of({{3, 4}}, 1).nearest({-1e300, 7})), std::vector<std::uint32_t>{0});

  const OrderKVoronoi two = diagram_of({{0, 0}, {2, 0}}, 1);
  EXPECT_EQ(two.cell_count(), 2u);
  EXPECT_EQ(two.halfedge_count(), 6u);
  EXPECT_TRUE(two.unbounded(CellId(0)) && two.unbounded(CellId(1)));
  EXPECT_EQ(rows(two.nearest({1, 5})), std::vector<std::uint32_t>{0});  // as near as (2, 0), which is larger
  EXPECT_EQ(rows(two.nearest({std::nextafter(1, 2), 5})), std::vector<std::uint32_t>{1});

  const OrderKVoronoi whole = diagram_of({{0, 0}, {2, 0}, {0, 1}}, 3);
  EXPECT_EQ(whole.cell_count(), 1u);
  EXPECT_EQ(whole.vertex_count(), 0u);
  EXPECT_FALSE(whole.halfedge(CellId(0)).valid());
  EXPECT_TRUE(whole.unbounded(CellId(0)));
  EXPECT_EQ(rows(whole.nearest({9, 0})), (std::vector<std::uint32_t>{1, 0, 2}));

  const OrderKVoronoi three = diagram_of({{0, 0}, {2, 0}, {0, 1}}, 2);
  EXPECT_EQ(three.cell_count(), 3u);
  EXPECT_EQ(three.vertex_count(), 4u);  // the circle of all three, and three rays
}

TEST(OrderKVoronoi, TakesTheFirstOfEqualRows) {
  const std::vector<Point2> points = {{5, 5}, {0, 0}, {5, 5}, {-0.0, 0}, {9, 1}, {5, 5}, {2, 7}};
  const OrderKVoronoi diagram = diagram_of(points, 2);
  EXPECT_EQ(diagram.site_count(), 4u);
  EXPECT_EQ(rows(diagram.nearest({4, 4})), (std::vector<std::uint32_t>{0, 6}));
  EXPECT_EQ(rows(diagram.nearest({0, 0})), (std::vector<std::uint32_t>{1, 0}));
}

TEST(OrderKVoronoi, RefusesWhatIsNoDiagram) {
  const auto code = [](const std::vector<Point2>& points, unsigned k) {
    const auto result = thalweg::order_k_voronoi(points, k);
    return result ? std::string("none") : std::to_string(static_cast<int>(result.error().code));
  };
  const auto expected = [](ErrorCode error) { return std::to_string(static_cast<int>(error)); };
  EXPECT_EQ(code({}, 1), expected(ErrorCode::too_few_points));
  EXPECT_EQ(code({{0, 0}, {1, 1}}, 0), expected(ErrorCode::invalid_argument));
  EXPECT_EQ(code({{0, 0}, {1, 1}, {0, 0}}, 3), expected(ErrorCode::too_few_points));
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(code({{0, 0}, {nan, 1}}, 1), expected(ErrorCode::not_finite));
  const auto result = thalweg::order_k_voronoi(std::vector<Point2>{{0, 0}, {1, infinity}, {nan, 0}}, 1);
  EXPECT_EQ(result.error().rows, (std::vector<std::uint32_t>{1, 2}));
}

TEST(OrderKVoronoi, AnswersAHundredThousandQueriesAsAScanDoes) {
  constexpr int kSize = 1 << 12;
  const auto points = random_points(150, kSize, 11);
  const OrderKVoronoi diagram = diagram_of(points, 5);
  Random random(13);
  int wrong = 0;
  for (int i = 0; i < 100000; ++i) {
    const Point2 a = points[random.below(150)], b = points[random.below(150)];
    Point2 q = random_point(random, kSize);
    if (i % 4 == 1) q = {(a.x + b.x) / 2, (a.y + b.y) / 2};  // on an edge of some order
    if (i % 4 == 2) q = {(a.x + b.x) / 2 + (b.y - a.y), (a.y + b.y) / 2 - (b.x - a.x)};  // likewise
    if (i % 4 == 3) q = {(q.x - kSize / 2) * 2048, (q.y - kSize / 2) * 2048};            // far outside
    wrong += rows(diagram.nearest(q)) != scan(points, q, 5);
  }
  EXPECT_EQ(wrong, 0);
}

TEST(OrderKVoronoi, AnswersExtremeQueriesExactly) {
  const auto points = random_points(40, 50, 17);
  const OrderKVoronoi diagram = diagram_of(points, 4);
  std::vector<Point2> queries;
  for (const double far : {1e17, 1e150, 1e300, std::numeric_limits<double>::max()}) {
    for (const Point2 p : {Point2{1, 0}, Point2{0, -1}, Point2{-1, 1}, Point2{0.3, 0.7}, Point2{1e-9, -1}}) {
      queries.push_back({p.x * far, p.y * far});
    }
  }
  queries.push_back({25, std::numeric_limits<double>::denorm_min()});
  // The centres of circles, rounded, and an ulp beside.
  for (std::uint32_t v = 0; v < diagram.vertex_count(); ++v) {
    if (diagram.at_infinity(VoronoiVertexId(v))) continue;
    const auto circle = diagram.circle(VoronoiVertexId(v));
    const Point2 a = diagram.point(circle[0]), b = diagram.point(circle[1]), c = diagram.point(circle[2]);
    const double bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
    const double b2 = bx * bx + by * by, c2 = cx * cx + cy * cy, area = 2 * (bx * cy - by * cx);
    const Point2 q = {a.x + (cy * b2 - by * c2) / area, a.y + (bx * c2 - cx * b2) / area};
    queries.push_back(q);
    queries.push_back({std::nextafter(q.x, 1e9), q.y});
  }
  for (const Point2 q : queries) {
    EXPECT_EQ(rows(diagram.nearest(q)), oracle::k_nearest(points, q, 4)) << q.x << ' ' << q.y;
  }
}

/// Degenerate sets, with as many cocircular or collinear sites as make cells of very many sides.
struct NamedSet {
  std::string name;
  std::vector<Point2> points;
};

std::vector<NamedSet> degenerate_sets() {
  std::vector<NamedSet> sets;
  const auto add = [&sets](const char* name, std::vector<Point2> points) {
    sets.push_back({name, std::move(points)});
  };
  add("grid", grid(16, 11));
  add("ring", support::integer_circle(5 * 13 * 17 * 29));
  add("hub", sets.back().points);
  sets.back().points.push_back({1, 0});
  sets.back().points.push_back({0, 3});
  add("ring and two far sites that see a side of it each", sets[1].points);
  sets.back().points.push_back({200000, 1000});
  sets.back().points.push_back({-50000, 300000});
  add("line", std::vector<Point2>());
  for (int i = 0; i < 90; ++i) sets.back().points.push_back({2.0 * ((i * 37) % 90), 1.0 * ((i * 37) % 90)});
  add("line and one", sets.back().points);
  sets.back().points.push_back({80, 60});
  add("line and both sides", sets.back().points);
  sets.back().points.push_back({90, 20});
  add("two lines", std::vector<Point2>());
  for (int i = 0; i < 60; ++i) sets.back().points.push_back({1.0 * (i / 2), 3.0 * (i % 2)});
  return sets;
}

TEST(OrderKVoronoi, OfDegenerateSets) {
  for (const NamedSet& set : degenerate_sets()) {
    const auto& points = set.points;
    const auto& name = set.name;
    Random random(19);
    std::vector<unsigned> orders = {1, 2, 3, 7, static_cast<unsigned>(points.size()) - 1};
    if (points.size() > 200) orders.pop_back();
    for (const unsigned k : orders) {
      const OrderKVoronoi diagram = diagram_of(points, k);
      for (int i = 0; i < 400; ++i) {
        const auto any = [&] { return points[random.below(static_cast<std::uint32_t>(points.size()))]; };
        const Point2 a = any(), b = any();
        const Point2 q = i % 3 == 0 ? a : Point2{(a.x + b.x) / 2, (a.y + b.y) / 2};
        ASSERT_EQ(rows(diagram.nearest(q)), scan(points, q, k))
            << name << ' ' << k << ' ' << q.x << ' ' << q.y;
      }
      ASSERT_EQ(rows(diagram.nearest({0, 0})), scan(points, {0, 0}, k)) << name << ' ' << k;
    }
  }
}

TEST(OrderKVoronoi, OfDegenerateSetsDoesNotDependOnThreads) {
  for (const auto& [name, points] : degenerate_sets()) {
    for (const unsigned k : {2u, 5u}) {
      const OrderKVoronoi one = diagram_of(points, k, 1), several = diagram_of(points, k, 3);
      ASSERT_EQ(one.halfedge_count(), several.halfedge_count()) << name;
      for (std::uint32_t h = 0; h < one.halfedge_count(); ++h) {
        ASSERT_EQ(one.twin(VoronoiHalfedgeId(h)), several.twin(VoronoiHalfedgeId(h))) << name;
      }
    }
  }
}

TEST(OrderKVoronoi, OfManySitesDoesNotDependOnThreads) {
  const auto points = random_points(6000, 1 << 20, 23);
  const OrderKVoronoi one = diagram_of(points, 4, 1), two = diagram_of(points, 4, 2);
  ASSERT_EQ(one.cell_count(), two.cell_count());
  for (std::uint32_t c = 0; c < one.cell_count(); ++c) {
    ASSERT_TRUE(std::ranges::equal(one.sites(CellId(c)), two.sites(CellId(c))));
  }
}

TEST(OrderKVoronoi, SaysHowMuchItHolds) {
  for (const unsigned k : {1u, 4u}) {
    const OrderKVoronoi diagram = diagram_of(random_points(2000, 1 << 20, 47), k);
    // The index takes 44 bytes a site.
    const std::size_t of_sites = 2000 * (sizeof(Point2) + 4 + 4 + 44);
    const std::size_t least = of_sites + diagram.halfedge_count() * std::size_t{20} +
                              diagram.vertex_count() * std::size_t{4} +
                              diagram.cell_count() * (std::size_t{k} + 1) * 4;
    EXPECT_GE(diagram.memory_bytes(), least) << k;
    EXPECT_LE(diagram.memory_bytes(), least + least / 8) << k;
  }
}

/// Around (0, 0), from one angle to another, nearly on a circle; so that (0, 0) has all of them for
/// neighbours.
std::vector<Point2> hub(int spokes, double from, double to) {
  Random random(41);
  std::vector<Point2> points = {{0, 0}};
  for (int i = 0; i < spokes; ++i) {
    const double angle = from + (to - from) * (i + random.unit() / 4) / spokes;
    const double radius = 1e6 * (1 + random.unit() / 1024);
    points.push_back({std::floor(radius * std::cos(angle)), std::floor(radius * std::sin(angle))});
  }
  return points;
}

/// The number of sites inside the circle of a vertex, or in the half-plane of one at infinity, by definition.
std::ptrdiff_t count_inside(const std::vector<Point2>& points, const thalweg::Triangle& circle) {
  const Point2 a = points[circle[0].index()], b = points[circle[1].index()];
  return std::count_if(points.begin(), points.end(), [&](Point2 p) {
    if (!circle[2].valid()) return oracle::orient2d(a, b, p) > 0;
    return oracle::incircle(a, b, points[circle[2].index()], p) > 0;
  });
}

TEST(OrderKVoronoi, CirclesHoldAsManySitesAsTheySay) {
  // The cell of a hub is one large hole; of the half hub it is unbounded.
  const std::vector<std::vector<Point2>> sets = {random_points(120, 1 << 20, 43), hub(70, 0, 6.28),
                                                 hub(70, 0.2, 2.9), hub(45, -3, 0.1)};
  for (const auto& points : sets) {
    for (const unsigned k : {1u, 2u, 3u, 5u}) {
      const OrderKVoronoi diagram = diagram_of(points, k);
      for (std::uint32_t i = 0; i < diagram.vertex_count(); ++i) {
        const VoronoiVertexId v(i);
        ASSERT_EQ(count_inside(points, diagram.circle(v)), diagram.inside(v)) << points.size() << ' ' << k;
      }
    }
  }
}

TEST(OrderKVoronoi, OfTheSecondOrderDividesTheCellOfAHub) {
  const auto points = hub(70, 0, 6.28);
  const OrderKVoronoi diagram = diagram_of(points, 2);
  std::set<VertexId> beside_hub;
  for (std::uint32_t c = 0; c < diagram.cell_count(); ++c) {
    const auto pair = diagram.sites(CellId(c));
    if (pair[0] == VertexId(0)) beside_hub.insert(pair[1]);
  }
  EXPECT_EQ(beside_hub.size(), 70u);
}

double area(const std::vector<Point2>& polygon) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2 p = polygon[i], q = polygon[(i + 1) % polygon.size()];
    sum += (p.x * q.y - p.y * q.x) / 2;
  }
  return sum;
}

TEST(OrderKVoronoi, PolygonsTileTheBox) {
  const thalweg::Box box{{-3, -2}, {13, 9}};
  for (const auto& points : {random_points(60, 11, 29), grid(9, 8), {{0, 0}, {1, 1}, {5, 5}, {7, 7}}}) {
    for (const unsigned k : {1u, 2u, 3u, 4u}) {
      const OrderKVoronoi diagram = diagram_of(points, k);
      double total = 0;
      for (std::uint32_t c = 0; c < diagram.cell_count(); ++c) {
        const auto polygon = diagram.polygon(CellId(c), box);
        const double size = area(polygon);
        total += size;
        for (const Point2 p : polygon) {
          EXPECT_TRUE(std::fabs(p.x - 5) <= 8 + 1e-12 && std::fabs(p.y - 3.5) <= 5.5 + 1e-12);
        }
        if (size < 1e-6) continue;
        Point2 middle{0, 0};
        for (const Point2 p : polygon) {
          const auto count = static_cast<double>(polygon.size());
          middle = {middle.x + p.x / count, middle.y + p.y / count};
        }
        EXPECT_EQ(diagram.locate(middle), CellId(c));
      }
      EXPECT_NEAR(total, 16 * 11, 1e-9);
    }
  }
}

TEST(OrderKVoronoi, PolygonsShareTheirCorners) {
  const OrderKVoronoi diagram = diagram_of(random_points(40, 1000, 37), 3);
  const thalweg::Box box{{-1e7, -1e7}, {1e7, 1e7}};
  std::set<std::pair<double, double>> corners;
  std::size_t finite = 0;
  for (std::uint32_t c = 0; c < diagram.cell_count(); ++c) {
    if (diagram.unbounded(CellId(c))) continue;
    for (const Point2 p : diagram.polygon(CellId(c), box)) corners.emplace(p.x, p.y);
  }
  for (std::uint32_t v = 0; v < diagram.vertex_count(); ++v)
    finite += !diagram.at_infinity(VoronoiVertexId(v));
  EXPECT_LE(corners.size(), finite);
}

/// The middle one of nine squares whose sides are 2^-31 of the width of the box.
TEST(OrderKVoronoi, PolygonsMayBeTiny) {
  const double step = 0x1p-30;
  std::vector<Point2> points;
  for (const Point2 p : grid(3, 3)) points.push_back({0.5 + (p.x - 1) * step, 0.25 + (p.y - 1) * step});
  const OrderKVoronoi diagram = diagram_of(points, 1);
  std::set<std::pair<double, double>> corners, expected;
  for (const Point2 p : diagram.polygon(diagram.locate({0.5, 0.25}), {{-1, -1}, {1, 1}})) {
    corners.emplace(p.x, p.y);
  }
  for (const Point2 p : grid(2, 2)) {
    expected.emplace(0.5 + (p.x - 0.5) * step, 0.25 + (p.y - 0.5) * step);
  }
  EXPECT_EQ(corners, expected);
}

/// Where the border between two cells runs along a side or through corners of the box.
TEST(OrderKVoronoi, PolygonsHaveNoCornerTwice) {
  const auto corners = [](Point2 second, const thalweg::Box& box) {
    const OrderKVoronoi diagram = diagram_of({{0, 0}, second}, 1);
    return diagram.polygon(diagram.locate({0, 0}), box).size();
  };
  EXPECT_EQ(corners({2, 0}, {{-1, -1}, {1, 1}}), 4u);
  EXPECT_EQ(corners({-2, 0}, {{-1, -1}, {1, 1}}), 4u);
  EXPECT_EQ(corners({0, 2}, {{-1, -1}, {1, 1}}), 4u);
  EXPECT_EQ(corners({2, 2}, {{0, 0}, {2, 2}}), 3u);
  EXPECT_EQ(corners({2, -2}, {{0, -2}, {2, 0}}), 3u);
  EXPECT_EQ(corners({2, 0}, {{1, -1}, {3, 1}}), 0u);
  EXPECT_EQ(corners({6, 0}, {{0, 0}, {4, 2}}), 4u);
}

TEST(OrderKVoronoi, PolygonsMayBeEmpty) {
  const OrderKVoronoi diagram = diagram_of(grid(2, 2), 2);
  // Of four sites on one circle: four cells of pairs along sides, and a diagonal's, which has no area.
  std::size_t with_area = 0;
  for (std::uint32_t c = 0; c < diagram.cell_count(); ++c) {
    with_area += !diagram.polygon(CellId(c), {{-1, -1}, {2, 2}}).empty();
  }
  EXPECT_EQ(diagram.cell_count(), 5u);
  EXPECT_EQ(with_area, 4u);
  EXPECT_TRUE(diagram.polygon(CellId(0), {{1, 1}, {1, 2}}).empty());
}

TEST(VoronoiCounter, CountsAsTheGraphSearchOnGridsAndRings) {
  for (const NamedSet& set : degenerate_sets()) {
    const auto& points = set.points;
    const auto& name = set.name;
    if (name == "line") continue;
    const auto mesh = thalweg::delaunay(points);
    const thalweg::DelaunayGraph graph(points, *mesh);
    thalweg::CircleCounter crawl(graph);
    const OrderKVoronoi diagram = diagram_of(points, 6);
    thalweg::VoronoiCounter voronoi(diagram);
    Random random(31);
    for (int i = 0; i < 3000; ++i) {
      const auto any = [&] { return VertexId(random.below(static_cast<std::uint32_t>(points.size()))); };
      const VertexId u = any(), v = any(), w = any();
      if (thalweg::orient2d(points[u.index()], points[v.index()], points[w.index()]) <= 0) continue;
      for (const unsigned limit : {0u, 2u, 5u}) {
        ASSERT_EQ(voronoi.count_in_circle(u, v, w, limit), crawl.count_in_circle(u, v, w, limit)) << name;
      }
    }
    EXPECT_EQ(voronoi.calls(), crawl.calls());
  }
}

}  // namespace
