/// Counting in circles and useful orders over hostile points: both counters and the definition agree on every
/// triangle, and the search for useful pairs finds those that the definition finds. The first byte is the
/// order.
#include <vector>

#include "fuzz_input.hpp"
#include "support/brute.hpp"
#include "thalweg/circle_count.hpp"
#include "thalweg/delaunay.hpp"
#include "thalweg/order_k_voronoi.hpp"
#include "thalweg/useful_order.hpp"
#include "thalweg/voronoi_counter.hpp"

namespace {

using thalweg::Point2;
using thalweg::VertexId;

void check_counters(const std::vector<Point2>& points, const support::Rows& rows,
                    const thalweg::DelaunayGraph& graph, unsigned limit) {
  const auto depth = std::min<std::size_t>(limit + 1, rows.size());
  const auto diagram = thalweg::order_k_voronoi(points, static_cast<unsigned>(depth));
  fuzz::check(static_cast<bool>(diagram), "there is a diagram", points);
  thalweg::CircleCounter crawl(graph);
  thalweg::VoronoiCounter located(*diagram);
  for (const std::uint32_t a : rows) {
    for (const std::uint32_t b : rows) {
      for (const std::uint32_t c : rows) {
        if (a > b || a > c || thalweg::orient2d(points[a], points[b], points[c]) <= 0) continue;
        const VertexId u(a), v(b), w(c);
        const unsigned count = std::min(limit + 1, support::sites_in_circle(points, rows, a, b, c));
        fuzz::check(crawl.count_in_circle(u, v, w, limit) == count, "the crawl counts right", points);
        fuzz::check(located.count_in_circle(u, v, w, limit) == count, "location counts right", points);
      }
    }
  }
}

void check_useful_pairs(const std::vector<Point2>& points, const support::Rows& rows,
                        const thalweg::DelaunayGraph& graph, unsigned limit) {
  thalweg::CircleCounter counter(graph);
  std::vector<thalweg::UsefulPair> expected;
  for (const std::uint32_t u : rows) {
    for (const std::uint32_t v : rows) {
      if (u >= v) continue;
      const auto order = support::useful_order_of(points, rows, u, v);
      const auto found = thalweg::useful_order(graph, counter, VertexId(u), VertexId(v), limit);
      fuzz::check(found.has_value() == order.has_value(), "a pair has an order or not", points);
      if (order) fuzz::check(*found == std::min(*order, limit + 1), "the order is the definition's", points);
      if (order && *order <= limit) expected.push_back({VertexId(u), VertexId(v), *order});
    }
  }
  fuzz::check(thalweg::useful_pairs(graph, limit) == expected, "all useful pairs, no others", points);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Input input(data, size);
  const unsigned limit = input.byte() % 8;
  const std::vector<Point2> points = fuzz::take_points(input, 10);
  const auto delaunay = thalweg::delaunay(points);
  if (!delaunay) return 0;
  const support::Rows rows = support::distinct_rows(points);
  const thalweg::DelaunayGraph graph(points, *delaunay);
  check_counters(points, rows, graph, limit);
  check_useful_pairs(points, rows, graph, limit);
  return 0;
}
