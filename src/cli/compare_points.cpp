/// Whether the vertices of a mesh are the points of a file.
#include "cli/compare_points.hpp"

#include <algorithm>
#include <bit>
#include <numeric>

#include "io/number.hpp"

namespace thalweg::cli {
namespace {

constexpr std::size_t kMostExamples = 5;

std::string to_text(double value) {
  std::string text(io::kNumberSize, ' ');
  text.resize(static_cast<std::size_t>(io::put_number(text.data(), value) - text.data()));
  return text;
}

std::string to_text(const Point3& p) {
  std::string text("(");
  return text.append(to_text(p.x))
      .append(", ")
      .append(to_text(p.y))
      .append(", ")
      .append(to_text(p.z))
      .append(")");
}

bool same_place(const Point3& a, const Point3& b) noexcept {
  return a.x == b.x && a.y == b.y;
}

bool place_before(const Point3& a, const Point3& b) noexcept {
  return a.x != b.x ? a.x < b.x : a.y < b.y;
}

bool same_bits(const Point3& a, const Point3& b) noexcept {
  const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
  return bits(a.x) == bits(b.x) && bits(a.y) == bits(b.y) && bits(a.z) == bits(b.z);
}

/// Indices of points by place, equal places by index.
std::vector<std::uint32_t> by_place(std::span<const Point3> points) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) {
    if (place_before(points[a], points[b])) return true;
    if (place_before(points[b], points[a])) return false;
    return a < b;
  });
  return order;
}

/// Two lists of points, walked place by place.
class Comparison {
 public:
  Comparison(std::span<const Point3> vertices, std::span<const Point3> rows)
      : vertices_(vertices), rows_(rows), vertex_order_(by_place(vertices)), row_order_(by_place(rows)) {}

  PointDifferences run() {
    std::size_t v = 0;
    std::size_t r = 0;
    while (v < vertex_order_.size() || r < row_order_.size()) {
      const Point3& place = next_place(v, r);
      const std::size_t v_end = end_of(vertices_, vertex_order_, v, place);
      const std::size_t r_end = end_of(rows_, row_order_, r, place);
      compare_place(std::span(vertex_order_).subspan(v, v_end - v),
                    std::span(row_order_).subspan(r, r_end - r));
      v = v_end;
      r = r_end;
    }
    return std::move(differences_);
  }

 private:
  const Point3& next_place(std::size_t v, std::size_t r) const {
    if (v == vertex_order_.size()) return rows_[row_order_[r]];
    if (r == row_order_.size()) return vertices_[vertex_order_[v]];
    const Point3& vertex = vertices_[vertex_order_[v]];
    const Point3& row = rows_[row_order_[r]];
    return place_before(row, vertex) ? row : vertex;
  }

  static std::size_t end_of(std::span<const Point3> points, std::span<const std::uint32_t> order,
                            std::size_t i, const Point3& place) {
    while (i < order.size() && same_place(points[order[i]], place)) ++i;
    return i;
  }

  void compare_place(std::span<const std::uint32_t> vertices, std::span<const std::uint32_t> rows) {
    if (!rows.empty()) ++differences_.sites;
    if (vertices.empty()) {
      ++differences_.missing;
      example("no vertex at row " + std::to_string(rows.front()) + " " + to_text(rows_[rows.front()]));
      return;
    }
    const std::size_t legal = rows.empty() ? 0 : 1;
    for (std::size_t i = legal; i < vertices.size(); ++i) {
      ++differences_.foreign;
      example("vertex " + std::to_string(vertices[i]) + " " + to_text(vertices_[vertices[i]]) +
              (legal == 0 ? " is at no point of the file" : " is the second at its place"));
    }
    if (legal == 0) return;
    const Point3& vertex = vertices_[vertices.front()];
    if (std::ranges::any_of(rows, [&](std::uint32_t row) { return same_bits(rows_[row], vertex); })) return;
    ++differences_.changed;
    example("vertex " + std::to_string(vertices.front()) + " " + to_text(vertex) + " was row " +
            std::to_string(rows.front()) + " " + to_text(rows_[rows.front()]));
  }

  void example(std::string text) {
    if (differences_.examples.size() < kMostExamples) differences_.examples.push_back(std::move(text));
  }

  std::span<const Point3> vertices_;
  std::span<const Point3> rows_;
  std::vector<std::uint32_t> vertex_order_;
  std::vector<std::uint32_t> row_order_;
  PointDifferences differences_;
};

}  // namespace

PointDifferences compare_points(std::span<const Point3> vertices, std::span<const Point3> rows) {
  return Comparison(vertices, rows).run();
}

}  // namespace thalweg::cli
