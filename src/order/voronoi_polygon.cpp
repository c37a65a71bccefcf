/// Cells of the order-k Voronoi diagram as polygons to draw.
#include <cfloat>
#include <cmath>

#include "thalweg/order_k_voronoi.hpp"

namespace thalweg {
namespace {

/// The part of a convex polygon where x nx + y ny <= limit.
std::vector<Point2> clip(const std::vector<Point2>& polygon, double nx, double ny, double limit) {
  std::vector<Point2> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2 p = polygon[i], q = polygon[i + 1 < polygon.size() ? i + 1 : 0];
    const double beyond_p = p.x * nx + p.y * ny - limit, beyond_q = q.x * nx + q.y * ny - limit;
    if (beyond_p <= 0) result.push_back(p);
    if ((beyond_p < 0 && beyond_q > 0) || (beyond_p > 0 && beyond_q < 0)) {
      const double t = beyond_p / (beyond_p - beyond_q);
      result.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
    }
  }
  return result;
}

/// Whether the polygon is wider than what rounding in coordinates up to 1 makes of a cell without area.
bool has_area(const std::vector<Point2>& polygon) {
  double twice_area = 0, length = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2 p = polygon[i], q = polygon[i + 1 < polygon.size() ? i + 1 : 0];
    // Seen from a corner: from (0, 0) what cancels would be far larger than a small cell.
    const Point2 o = polygon.front();
    twice_area += (p.x - o.x) * (q.y - o.y) - (p.y - o.y) * (q.x - o.x);
    length += std::hypot(q.x - p.x, q.y - p.y);
  }
  return twice_area > 16 * DBL_EPSILON * length;
}

/// Coordinates relative to a box, in [-1, 1] within it: a diagram far from zero keeps its digits.
struct Frame {
  explicit Frame(const Box& box)
      : centre{box.low.x / 2 + box.high.x / 2, box.low.y / 2 + box.high.y / 2},
        half{box.high.x / 2 - box.low.x / 2, box.high.y / 2 - box.low.y / 2},
        unit(half.x > half.y ? half.x : half.y),
        reach{half.x / unit, half.y / unit} {}

  bool empty() const { return !(half.x > 0 && half.y > 0); }
  Point2 inward(Point2 p) const { return {(p.x - centre.x) / unit, (p.y - centre.y) / unit}; }
  Point2 outward(Point2 p) const { return {centre.x + p.x * unit, centre.y + p.y * unit}; }
  bool holds(Point2 p) const { return std::fabs(p.x) <= reach.x && std::fabs(p.y) <= reach.y; }
  std::vector<Point2> corners() const {
    return {{-reach.x, -reach.y}, {reach.x, -reach.y}, {reach.x, reach.y}, {-reach.x, reach.y}};
  }

  Point2 centre, half;
  double unit;
  Point2 reach;
};

/// The rounded centre of the circle of v; NaN or infinite for a vertex at infinity.
Point2 rounded_centre(const OrderKVoronoi& diagram, VoronoiVertexId v, const Frame& frame) {
  if (diagram.at_infinity(v)) return {HUGE_VAL, HUGE_VAL};
  const Triangle circle = diagram.circle(v);
  const Point2 a = diagram.point(circle[0]), b = diagram.point(circle[1]), c = diagram.point(circle[2]);
  const double bx = (b.x - a.x) / frame.unit, by = (b.y - a.y) / frame.unit;
  const double cx = (c.x - a.x) / frame.unit, cy = (c.y - a.y) / frame.unit;
  const double b2 = bx * bx + by * by, c2 = cx * cx + cy * cy, area = 2 * (bx * cy - by * cx);
  const Point2 from = frame.inward(a);
  return {from.x + (cy * b2 - by * c2) / area, from.y + (bx * c2 - cx * b2) / area};
}

}  // namespace

// A cell within the box consists of its vertices, which are the same numbers for all cells around them; a
// cell that leaves it is cut out of the box, edge by edge.
std::vector<Point2> OrderKVoronoi::polygon(CellId c, const Box& box) const {
  const Frame frame(box);
  if (frame.empty()) return {};
  std::vector<Point2> result;
  bool within = halfedge(c).valid();
  for_each_halfedge(c, [&](VoronoiHalfedgeId h) {
    if (!within) return;
    result.push_back(rounded_centre(*this, origin(h), frame));
    within = frame.holds(result.back());
  });
  if (!within) {
    result = frame.corners();
    for_each_halfedge(c, [&](VoronoiHalfedgeId h) {
      if (at_infinity(h)) return;
      const Point2 lost = frame.inward(point(loss(h))), gained = frame.inward(point(gain(h)));
      const double nx = gained.x - lost.x, ny = gained.y - lost.y;
      result = clip(result, nx, ny, nx * ((gained.x + lost.x) / 2) + ny * ((gained.y + lost.y) / 2));
    });
  }
  if (!has_area(result)) return {};
  for (Point2& p : result) p = frame.outward(p);
  return result;
}

}  // namespace thalweg
