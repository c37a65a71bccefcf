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
    twice_area += p.x * q.y - p.y * q.x;
    length += std::hypot(q.x - p.x, q.y - p.y);
  }
  return twice_area > 16 * DBL_EPSILON * length;
}

}  // namespace

// In coordinates relative to the box, [-1, 1]: a cell of a set of sites far from zero keeps its digits.
std::vector<Point2> OrderKVoronoi::polygon(CellId c, const Box& box) const {
  const Point2 centre{box.low.x / 2 + box.high.x / 2, box.low.y / 2 + box.high.y / 2};
  const Point2 half{box.high.x / 2 - box.low.x / 2, box.high.y / 2 - box.low.y / 2};
  const double unit = half.x > half.y ? half.x : half.y;
  if (!(half.x > 0 && half.y > 0)) return {};
  const Point2 reach{half.x / unit, half.y / unit};
  const auto relative = [&](VertexId site) {
    return Point2{(point(site).x - centre.x) / unit, (point(site).y - centre.y) / unit};
  };
  std::vector<Point2> result = {
      {-reach.x, -reach.y}, {reach.x, -reach.y}, {reach.x, reach.y}, {-reach.x, reach.y}};
  for_each_halfedge(c, [&](VoronoiHalfedgeId h) {
    if (at_infinity(h)) return;
    const Point2 lost = relative(loss(h)), gained = relative(gain(h));
    const double nx = gained.x - lost.x, ny = gained.y - lost.y;
    const double limit = nx * ((gained.x + lost.x) / 2) + ny * ((gained.y + lost.y) / 2);
    result = clip(result, nx, ny, limit);
  });
  if (!has_area(result)) return {};
  for (Point2& p : result) p = {centre.x + p.x * unit, centre.y + p.y * unit};
  return result;
}

}  // namespace thalweg
