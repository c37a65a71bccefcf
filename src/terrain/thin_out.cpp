/// Vertex removal in rounds: in each, vertices of which no two are neighbours, so that their stars are those
/// of one and the same mesh.
#include "terrain/thin_out.hpp"

#include <algorithm>
#include <optional>

#include "kernel/predicates_inline.hpp"

namespace thalweg::detail {
namespace {

constexpr std::size_t kMostNeighbors = 12;  // a star of more costs more than it gains

class Thinner {
 public:
  Thinner(std::span<const Point2> places, std::vector<ThinTriangle>& triangles,
          std::span<const std::uint8_t> keep)
      : places_(places), triangles_(triangles), keep_(keep) {}

  /// Returns how many triangles have gone.
  std::size_t round(std::size_t most) {
    link();
    locked_.assign(places_.size(), 0);
    gone_.assign(triangles_.size(), 0);
    const std::size_t before = triangles_.size();
    std::size_t removed = 0;
    for (std::uint32_t v = 0; v < places_.size() && before - 2 * removed > most; ++v) {
      if (keep_[v] == 0 && locked_[v] == 0 && take_out(v)) ++removed;
    }
    std::size_t left = 0;
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
      if (i >= gone_.size() || gone_[i] == 0) triangles_[left++] = triangles_[i];
    }
    triangles_.resize(left);
    return before - left;
  }

 private:
  /// starts_[v] .. starts_[v + 1] in around_: the triangles of v.
  void link() {
    starts_.assign(places_.size() + 1, 0);
    for (const ThinTriangle& t : triangles_) {
      for (const std::uint32_t v : t) ++starts_[v + 1];
    }
    for (std::size_t v = 1; v < starts_.size(); ++v) starts_[v] += starts_[v - 1];
    around_.resize(3 * triangles_.size());
    std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
    for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
      for (const std::uint32_t v : triangles_[i]) around_[next[v]++] = i;
    }
  }

  std::span<const std::uint32_t> star(std::uint32_t v) const {
    return std::span(around_).subspan(starts_[v], starts_[v + 1] - starts_[v]);
  }

  bool take_out(std::uint32_t v) {
    if (star(v).empty() || star(v).size() > kMostNeighbors || !find_ring(v)) return false;
    fill_.clear();
    std::vector<std::uint32_t>& polygon = ring_;
    const std::vector<std::uint32_t> around = ring_;
    while (polygon.size() > 3) {
      const auto ear = best_ear(polygon);
      if (!ear) return false;
      fill_.push_back(corner(polygon, *ear));
      polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(*ear));
    }
    if (turn(corner(polygon, 1)) <= 0) return false;
    fill_.push_back({polygon[0], polygon[1], polygon[2]});
    for (const std::uint32_t i : star(v)) gone_[i] = 1;
    for (const std::uint32_t w : around) locked_[w] = 1;
    triangles_.insert(triangles_.end(), fill_.begin(), fill_.end());
    return true;
  }

  /// The vertices around v, counter-clockwise, into ring_; false if v is on the border.
  bool find_ring(std::uint32_t v) {
    ring_.clear();
    const auto edge_from = [&](std::uint32_t from) -> std::optional<std::uint32_t> {
      for (const std::uint32_t i : star(v)) {
        const ThinTriangle& t = triangles_[i];
        for (std::size_t c = 0; c < 3; ++c) {
          if (t[c] == v && t[(c + 1) % 3] == from) return t[(c + 2) % 3];
        }
      }
      return std::nullopt;
    };
    const ThinTriangle& first = triangles_[star(v)[0]];
    const std::size_t at = first[0] == v ? 0 : first[1] == v ? 1 : 2;
    std::uint32_t w = first[(at + 1) % 3];
    for (std::size_t i = 0; i < star(v).size(); ++i) {
      ring_.push_back(w);
      const auto next = edge_from(w);
      if (!next) return false;
      w = *next;
    }
    return w == ring_[0] && ring_.size() >= 3;
  }

  static ThinTriangle corner(const std::vector<std::uint32_t>& polygon, std::size_t at) {
    const std::size_t n = polygon.size();
    return {polygon[(at + n - 1) % n], polygon[at], polygon[(at + 1) % n]};
  }

  int turn(const ThinTriangle& t) const { return orient2d_sign(places_[t[0]], places_[t[1]], places_[t[2]]); }

  /// A corner to cut off: one whose circle is empty if there is any, else one whose triangle is.
  std::optional<std::size_t> best_ear(const std::vector<std::uint32_t>& polygon) const {
    std::optional<std::size_t> some;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const ThinTriangle t = corner(polygon, i);
      if (turn(t) <= 0) continue;
      bool triangle_empty = true, circle_empty = true;
      for (const std::uint32_t w : polygon) {
        if (w == t[0] || w == t[1] || w == t[2]) continue;
        const Point2 a = places_[t[0]], b = places_[t[1]], c = places_[t[2]], p = places_[w];
        circle_empty = circle_empty && incircle_sign(a, b, c, p) <= 0;
        triangle_empty = triangle_empty && (orient2d_sign(a, b, p) < 0 || orient2d_sign(b, c, p) < 0 ||
                                            orient2d_sign(c, a, p) < 0);
      }
      if (!triangle_empty) continue;
      if (circle_empty) return i;
      if (!some) some = i;
    }
    return some;
  }

  std::span<const Point2> places_;
  std::vector<ThinTriangle>& triangles_;
  std::span<const std::uint8_t> keep_;
  std::vector<std::uint32_t> starts_, around_;
  std::vector<std::uint8_t> locked_, gone_;
  std::vector<std::uint32_t> ring_;
  std::vector<ThinTriangle> fill_;
};

}  // namespace

std::vector<ThinTriangle> thin_out(std::span<const Point2> places, std::vector<ThinTriangle> triangles,
                                   std::span<const std::uint8_t> keep, std::size_t most) {
  Thinner thinner(places, triangles, keep);
  while (triangles.size() > most) {
    if (thinner.round(most) == 0) break;
  }
  return triangles;
}

}  // namespace thalweg::detail
