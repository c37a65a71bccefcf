/// Order-k Voronoi diagrams of hostile points: the right error, or a sound structure in which every location
/// agrees with sorting the sites. The first byte is the order less 1.
#include <algorithm>
#include <cmath>

#include "fuzz_input.hpp"
#include "thalweg/order_k_voronoi.hpp"
#include "thalweg/predicates.hpp"

namespace {

using thalweg::CellId;
using thalweg::OrderKVoronoi;
using thalweg::Point2;
using thalweg::VertexId;
using thalweg::VoronoiHalfedgeId;

bool is_finite(Point2 p) {
  return std::isfinite(p.x) && std::isfinite(p.y);
}

/// The first row at each place.
std::vector<VertexId> distinct_rows(const std::vector<Point2>& points) {
  std::vector<VertexId> rows;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (std::find(points.begin(), points.begin() + i, points[i]) == points.begin() + i) rows.emplace_back(i);
  }
  return rows;
}

void check_structure(const OrderKVoronoi& diagram, const std::vector<Point2>& points) {
  for (std::uint32_t i = 0; i < diagram.halfedge_count(); ++i) {
    const VoronoiHalfedgeId h(i);
    fuzz::check(diagram.twin(diagram.twin(h)) == h, "twins are mutual", points);
    fuzz::check(diagram.prev(diagram.next(h)) == h, "prev undoes next", points);
    fuzz::check(diagram.dest(h) == diagram.origin(diagram.next(h)), "half-edges of a cell are a cycle",
                points);
    if (diagram.at_infinity(h)) continue;
    const auto here = diagram.sites(diagram.face(h)), there = diagram.sites(diagram.across(h));
    std::vector<VertexId> left, right;
    std::set_difference(here.begin(), here.end(), there.begin(), there.end(), std::back_inserter(left));
    std::set_difference(there.begin(), there.end(), here.begin(), here.end(), std::back_inserter(right));
    fuzz::check(left == std::vector{diagram.loss(h)} && right == std::vector{diagram.gain(h)},
                "across an edge one site is lost and one gained", points);
  }
}

void check_location(const OrderKVoronoi& diagram, Point2 q, std::vector<VertexId> rows,
                    const std::vector<Point2>& points) {
  std::sort(rows.begin(), rows.end(), [&](VertexId a, VertexId b) {
    const Point2 p = points[a.index()], r = points[b.index()];
    const int sign = thalweg::compare_distance(q, p, r);
    if (sign != 0) return sign < 0;
    return p.x < r.x || (p.x == r.x && p.y < r.y);
  });
  rows.resize(diagram.order());
  fuzz::check(diagram.nearest(q) == rows, "the nearest sites, nearest first", points);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Input input(data, size);
  const unsigned k = input.byte() % 16 + 1u;
  const std::vector<Point2> points = fuzz::take_points(input, 24);
  const auto diagram = thalweg::order_k_voronoi(points, k);
  const bool legal = std::all_of(points.begin(), points.end(), is_finite);
  const std::vector<VertexId> rows = legal ? distinct_rows(points) : std::vector<VertexId>();
  fuzz::check(static_cast<bool>(diagram) == (legal && k <= rows.size()),
              "an error where one is due, only there", points);
  if (!diagram) return 0;
  check_structure(*diagram, points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point2 p = points[i], r = points[(i * 7 + 1) % points.size()];
    check_location(*diagram, p, rows, points);
    check_location(*diagram, {p.x / 2 + r.x / 2, p.y / 2 + r.y / 2}, rows, points);
    check_location(*diagram, {r.y, -p.x}, rows, points);
  }
  return 0;
}
