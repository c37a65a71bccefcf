/// Checks the segments of a hard instance and finds the scale at which its shields are integer points.
///
/// All arithmetic is of 64-bit integers: coordinates are at most 2^29, so differences at most 2^30, products
/// 2^60, a cross product or a squared length 2^61, a length 2^30.5 and the product of two lengths 2^61.
#include "terrain/shields.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>

namespace thalweg::detail {
namespace {

constexpr std::int64_t kMostInput = std::int64_t{1} << 29;

LatticePoint operator-(LatticePoint a, LatticePoint b) noexcept {
  return {a.x - b.x, a.y - b.y};
}
std::int64_t cross(LatticePoint u, LatticePoint v) noexcept {
  return u.x * v.y - u.y * v.x;
}
std::int64_t dot(LatticePoint u, LatticePoint v) noexcept {
  return u.x * v.x + u.y * v.y;
}

/// The least integer that is at least |u|. Requires: u is not 0.
std::int64_t length_up(LatticePoint u) noexcept {
  const std::int64_t square = dot(u, u);
  auto root = static_cast<std::int64_t>(std::sqrt(static_cast<double>(square)));
  while (root * root >= square) --root;
  while (root * root < square) ++root;
  return root;
}

/// The largest integer that is at most |u|.
std::int64_t length_down(LatticePoint u) noexcept {
  const std::int64_t up = length_up(u);
  return up * up == dot(u, u) ? up : up - 1;
}

Error refusal(std::string message, std::vector<std::uint32_t> rows) {
  return {ErrorCode::invalid_argument, std::move(message), std::move(rows)};
}

std::string place_name(LatticePoint p) {
  return "(" + std::to_string(p.x) + ", " + std::to_string(p.y) + ")";
}

std::optional<Error> fault_of_coordinates(std::span<const LatticeSegment> segments) {
  for (std::uint32_t i = 0; i < segments.size(); ++i) {
    for (const std::int64_t c : {segments[i].a.x, segments[i].a.y, segments[i].b.x, segments[i].b.y}) {
      if (c < -kMostInput || c > kMostInput) {
        return refusal(segment_name(i) + " has the coordinate " + std::to_string(c) +
                           ": give whole numbers of at most 2^29 in magnitude",
                       {i});
      }
    }
    if (segments[i].a == segments[i].b) {
      return refusal(segment_name(i) + " is a point: give it two ends", {i});
    }
  }
  return std::nullopt;
}

std::optional<Error> fault_of_ends(std::span<const LatticePoint> ends) {
  std::vector<std::uint32_t> sorted(ends.size());
  std::iota(sorted.begin(), sorted.end(), 0u);
  const auto key = [&](std::uint32_t e) { return std::pair(ends[e].x, ends[e].y); };
  std::sort(sorted.begin(), sorted.end(), [&](auto a, auto b) { return key(a) < key(b); });
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (ends[sorted[i - 1]] != ends[sorted[i]]) continue;
    const auto [first, second] = std::minmax({sorted[i - 1] / 2, sorted[i] / 2});
    return refusal(segment_name(first) + " and " + segment_name(second) + " share the end " +
                       place_name(ends[sorted[i]]) + ": make all ends distinct, e.g. extend one slightly",
                   {first, second});
  }
  return std::nullopt;
}

/// Raises m so that p + (q - p) / m, for any q with |q - p| <= reach, is not on the segment ab. Nothing if p
/// is. The distance from p to ab is that to a or b, which (1) takes care of, or |cross| / |ab| inside.
bool keep_off(LatticePoint p, std::int64_t reach, LatticePoint a, LatticePoint b, std::int64_t& m) noexcept {
  const LatticePoint along = b - a;
  const std::int64_t shadow = dot(p - a, along);
  if (shadow < 0 || shadow > dot(along, along)) return true;
  const std::int64_t area = std::abs(cross(along, p - a));
  if (area == 0) return false;
  m = std::max(m, reach * length_up(along) / area + 1);
  return true;
}

/// The scale m of (1) and (2), which exceeds 2^53 in hopeless cases. Errors: an end on another segment.
Result<std::int64_t> find_scale(std::span<const LatticePoint> ends) {
  LatticePoint low = ends[0], high = ends[0];
  for (const LatticePoint p : ends) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const std::int64_t reach = length_up(high - low);
  std::int64_t nearest = reach;
  std::int64_t m = 2;
  for (std::uint32_t p = 0; p < ends.size(); ++p) {
    for (std::uint32_t a = 0; a < ends.size(); a += 2) {
      if (p == a || p == a + 1) continue;
      nearest = std::min({nearest, length_down(ends[a] - ends[p]), length_down(ends[a + 1] - ends[p])});
      if (keep_off(ends[p], reach, ends[a], ends[a + 1], m)) continue;
      return refusal("the end " + place_name(ends[p]) + " of " + segment_name(p / 2) + " lies on " +
                         segment_name(a / 2) + ": extend it to cross, or shorten it to stay clear",
                     {p / 2, a / 2});
    }
    nearest = std::min(nearest, length_down(ends[p ^ 1] - ends[p]));
  }
  return std::max(m, 3 * reach / nearest + 1);
}

/// The upper half plane with the positive x axis, then the lower with the negative one.
bool in_upper_half(LatticePoint u) noexcept {
  return u.y > 0 || (u.y == 0 && u.x > 0);
}

/// By direction, those of one direction by distance.
bool comes_before(LatticePoint u, LatticePoint v) noexcept {
  if (in_upper_half(u) != in_upper_half(v)) return in_upper_half(u);
  const std::int64_t turn = cross(u, v);
  return turn != 0 ? turn > 0 : dot(u, u) < dot(v, v);
}

bool same_direction(LatticePoint u, LatticePoint v) noexcept {
  return cross(u, v) == 0 && dot(u, v) > 0;
}

/// The shields next to `from`: one for the nearest end of every direction, unless that is the partner. An end
/// further out in a direction has the nearer one between.
void add_shields(std::span<const LatticePoint> ends, std::uint32_t from, std::vector<Shield>& shields) {
  std::vector<std::uint32_t> others;
  for (std::uint32_t e = 0; e < ends.size(); ++e) {
    if (e != from) others.push_back(e);
  }
  const auto way = [&](std::uint32_t e) { return ends[e] - ends[from]; };
  std::sort(others.begin(), others.end(), [&](auto a, auto b) { return comes_before(way(a), way(b)); });
  const std::size_t first = shields.size();
  for (std::size_t i = 0; i < others.size(); ++i) {
    if (i > 0 && same_direction(way(others[i - 1]), way(others[i]))) continue;
    if (!partners(from, others[i])) shields.push_back({from, others[i]});
  }
  std::sort(shields.begin() + static_cast<std::ptrdiff_t>(first), shields.end(),
            [](const Shield& a, const Shield& b) { return a.to < b.to; });
}

bool all_on_a_line(std::span<const LatticePoint> ends) {
  return std::ranges::all_of(ends,
                             [&](LatticePoint p) { return cross(ends[1] - ends[0], p - ends[0]) == 0; });
}

/// Whether all of m p + (q - p) is at most 2^53 in magnitude.
bool fits(std::span<const LatticePoint> ends, std::int64_t m) {
  std::int64_t largest = 1;
  for (const LatticePoint p : ends) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  return m <= (kMostExact - 2 * largest) / largest;
}

}  // namespace

std::string segment_name(std::uint32_t segment) {
  return "segment " + std::to_string(segment) + " (from 0)";
}

LatticePoint ShieldPlan::place(const Shield& shield) const noexcept {
  const LatticePoint p = ends[shield.from];
  const LatticePoint way = ends[shield.to] - p;
  return {scale * p.x + way.x, scale * p.y + way.y};
}

Result<ShieldPlan> plan_shields(std::span<const LatticeSegment> segments, std::uint32_t most) {
  if (segments.size() < 2 || segments.size() > most) {
    return refusal(std::to_string(segments.size()) + " segments: give from 2 to " + std::to_string(most), {});
  }
  if (auto fault = fault_of_coordinates(segments)) return *fault;
  ShieldPlan plan;
  for (const LatticeSegment& s : segments) {
    plan.ends.push_back(s.a);
    plan.ends.push_back(s.b);
  }
  if (auto fault = fault_of_ends(plan.ends)) return *fault;
  if (all_on_a_line(plan.ends)) {
    return Error{ErrorCode::all_collinear, "all segments lie on one line: there is no triangle"};
  }
  const Result<std::int64_t> scale = find_scale(plan.ends);
  if (!scale) return scale.error();
  if (!fits(plan.ends, *scale)) {
    return refusal("coordinates would have to be scaled by " + std::to_string(*scale) +
                       " and would not fit into 2^53: give smaller ones, or ends further from each other and "
                       "from other segments",
                   {});
  }
  plan.scale = *scale;
  for (std::uint32_t e = 0; e < plan.ends.size(); ++e) add_shields(plan.ends, e, plan.shields);
  return plan;
}

}  // namespace thalweg::detail
