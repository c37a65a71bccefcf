#include "io/report_payload.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <numeric>

#include "io/report_residual.hpp"

namespace thalweg::io {
namespace {

class Packer {
 public:
  explicit Packer(std::vector<std::uint8_t>& out) : out_(out) {}

  void unsigned_number(std::uint64_t value) {
    for (; value >= 0x80; value >>= 7) out_.push_back(static_cast<std::uint8_t>(value | 0x80));
    out_.push_back(static_cast<std::uint8_t>(value));
  }
  /// 0, -1, 1, -2, ... as 0, 1, 2, 3, ...
  void signed_number(std::int64_t value) {
    unsigned_number(static_cast<std::uint64_t>(value) << 1 ^ static_cast<std::uint64_t>(value >> 63));
  }
  void difference(std::uint32_t value, std::uint32_t less) {
    signed_number(std::int64_t{value} - std::int64_t{less});
  }
  /// All lowest bytes, then all second ones, ...
  template <std::unsigned_integral T>
  void planes(std::span<const T> values, unsigned bytes) {
    for (unsigned shift = 0; shift < 8 * bytes; shift += 8) {
      for (const T value : values) out_.push_back(static_cast<std::uint8_t>(value >> shift));
    }
  }

 private:
  std::vector<std::uint8_t>& out_;
};

/// The place of a cell of a 2^16 by 2^16 grid on the Hilbert curve through it.
std::uint64_t hilbert(std::uint32_t x, std::uint32_t y) {
  std::uint64_t place = 0;
  for (std::uint32_t side = 1u << 15; side > 0; side /= 2) {
    const std::uint32_t right = (x & side) != 0 ? 1 : 0, up = (y & side) != 0 ? 1 : 0;
    place = place << 2 | (3 * right ^ up);
    if (up == 0) {
      if (right == 1) {
        x = ~x;
        y = ~y;
      }
      std::swap(x, y);
    }
  }
  return place;
}

std::uint32_t cell(float value, float least, float most) {
  if (!(most > least)) return 0;
  return static_cast<std::uint32_t>((value - least) / (most - least) * 65535.0f);
}

/// Positions along the curve: order[i] is the vertex that comes i-th.
std::vector<std::uint32_t> along_curve(std::span<const float> x, std::span<const float> y) {
  std::vector<std::uint32_t> order(x.size());
  std::iota(order.begin(), order.end(), 0u);
  if (order.empty()) return order;
  const auto [x_low, x_high] = std::ranges::minmax(x);
  const auto [y_low, y_high] = std::ranges::minmax(y);
  std::vector<std::uint64_t> key(x.size());
  for (std::size_t i = 0; i < key.size(); ++i) {
    key[i] = hilbert(cell(x[i], x_low, x_high), cell(y[i], y_low, y_high));
  }
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return key[a] != key[b] ? key[a] < key[b] : a < b; });
  return order;
}

template <class Coordinate>
std::vector<float> to_floats(std::span<const Point3> points, FloatFrame& frame, Coordinate coordinate) {
  double low = 0, high = 0;
  if (!points.empty()) low = high = coordinate(points[0]);
  for (const Point3& p : points) {
    low = std::min(low, coordinate(p));
    high = std::max(high, coordinate(p));
  }
  frame = FloatFrame::around(low, high);
  std::vector<float> result;
  result.reserve(points.size());
  for (const Point3& p : points) result.push_back(frame(coordinate(p)));
  return result;
}

/// What the floats left out, if it is to be in the page; says so in `axis`.
template <class Coordinate>
void pack_residuals(Packer& out, const Report& report, std::span<const std::uint32_t> order, PackedAxis& axis,
                    Coordinate coordinate) {
  std::vector<double> exact, near;
  exact.reserve(order.size());
  near.reserve(order.size());
  for (const std::uint32_t v : order) {
    exact.push_back(coordinate(report.points[v]));
    near.push_back(axis.frame.value(axis.frame(exact.back())));
  }
  const Residuals residuals = find_residuals(exact, near);
  if (residuals.bytes > 0 && order.size() > kMostExactVertices) return;
  axis.steps = residuals.steps;
  axis.residual_bytes = residuals.bytes;
  out.planes(std::span<const std::uint64_t>(residuals.values), residuals.bytes);
}

/// The triangles in the page's numbers, each with its smallest first, sorted; returns where each came from.
std::vector<std::uint32_t> pack_triangles(Packer& out, std::span<const IndexTriangle> triangles,
                                          std::span<const std::uint32_t> position) {
  std::vector<IndexTriangle> renamed;
  renamed.reserve(triangles.size());
  for (const IndexTriangle& t : triangles) {
    IndexTriangle made = {position[t[0]], position[t[1]], position[t[2]]};
    std::rotate(made.begin(), std::min_element(made.begin(), made.end()), made.end());
    renamed.push_back(made);
  }
  std::vector<std::uint32_t> order(triangles.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return renamed[a] < renamed[b]; });
  std::uint32_t last = 0;
  for (const std::uint32_t i : order) {
    const auto [a, b, c] = renamed[i];
    out.unsigned_number(a - last);
    out.unsigned_number(b - a);
    out.unsigned_number(c - a);
    last = a;
  }
  return order;
}

std::uint32_t renamed(std::uint32_t vertex, std::span<const std::uint32_t> position) {
  return vertex == kNoVertex ? kNoVertex : position[vertex];
}

/// Returns how many flows differ between before and after.
std::size_t pack_flows(Packer& out, const Report& report, std::span<const std::uint32_t> order,
                       std::span<const std::uint32_t> position) {
  const auto flow = [&](int which, std::uint32_t at) {
    return renamed(report.downstream[static_cast<std::size_t>(which)][order[at]], position);
  };
  const auto put = [&](std::uint32_t to, std::uint32_t from) {
    out.signed_number(to == kNoVertex ? 0 : std::int64_t{to} - std::int64_t{from});
  };
  const auto count = static_cast<std::uint32_t>(order.size());
  for (std::uint32_t i = 0; i < count; ++i) put(flow(0, i), i);
  std::size_t changed = 0;
  std::uint32_t last = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    if (flow(0, i) == flow(1, i)) continue;
    out.unsigned_number(i - last);
    put(flow(1, i), i);
    last = i;
    ++changed;
  }
  return changed;
}

}  // namespace

FloatFrame FloatFrame::around(double low, double high) noexcept {
  FloatFrame frame;
  frame.origin = 0.5 * low + 0.5 * high;
  const double half = 0.5 * high - 0.5 * low;
  constexpr double kMost = 0x1p100, kLeast = 0x1p-100;
  // Below 2^-1000 the unit itself would be no normal number.
  if (half > kMost || (half > 0 && half < kLeast))
    frame.unit = std::ldexp(1.0, std::max(std::ilogb(half), -1000));
  return frame;
}

float FloatFrame::operator()(double value) const noexcept {
  // Halves, because the difference of two doubles may be beyond all doubles.
  return static_cast<float>((0.5 * value - 0.5 * origin) / unit * 2);
}

double FloatFrame::value(float held) const noexcept {
  return origin + static_cast<double>(held) * unit;
}

Payload pack(const Report& report) {
  Payload payload;
  const auto x_of = [](const Point3& p) { return p.x; };
  const auto y_of = [](const Point3& p) { return p.y; };
  const auto z_of = [](const Point3& p) { return p.z; };
  const std::vector<float> x = to_floats(report.points, payload.x.frame, x_of);
  const std::vector<float> y = to_floats(report.points, payload.y.frame, y_of);
  const std::vector<float> z = to_floats(report.points, payload.z.frame, z_of);
  const std::vector<std::uint32_t> order = along_curve(x, y);
  payload.position.resize(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) payload.position[order[i]] = i;

  Packer out(payload.bytes);
  for (const auto* values : {&x, &y, &z}) {
    std::vector<std::uint32_t> sorted;
    sorted.reserve(order.size());
    for (const std::uint32_t v : order) sorted.push_back(std::bit_cast<std::uint32_t>((*values)[v]));
    out.planes(std::span<const std::uint32_t>(sorted), 4);
  }
  std::uint32_t last = 0;
  for (const std::uint32_t v : order) {
    out.difference(report.names[v], last);
    last = report.names[v];
  }
  pack_triangles(out, report.common, payload.position);
  pack_triangles(out, report.before, payload.position);
  for (const std::uint32_t i : pack_triangles(out, report.after, payload.position)) {
    out.unsigned_number(report.after_order[i]);
  }
  payload.changed_flows = pack_flows(out, report, order, payload.position);
  pack_residuals(out, report, order, payload.x, x_of);
  pack_residuals(out, report, order, payload.y, y_of);
  pack_residuals(out, report, order, payload.z, z_of);
  return payload;
}

std::string base64(std::span<const std::uint8_t> bytes) {
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t have = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t word = std::uint32_t{bytes[i]} << 16;
    if (have > 1) word |= std::uint32_t{bytes[i + 1]} << 8;
    if (have > 2) word |= bytes[i + 2];
    for (std::size_t digit = 0; digit < 4; ++digit) {
      text += digit <= have ? kDigits[word >> (18 - 6 * digit) & 63] : '=';
    }
  }
  return text;
}

}  // namespace thalweg::io
