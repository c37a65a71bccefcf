/// Measuring reach: levels of inverted sites, in single precision, and the search along edges.
#include "order/reach.hpp"

#include <algorithm>
#include <bit>

namespace thalweg::detail {
namespace {

/// How many sites near p are met before the bounds are found from them, if there are so many. More make them
/// tighter and dearer: 6 k of them leave 15 % fewer sites than 4 k.
std::size_t near_count(const DelaunayGraph& graph, std::size_t k) {
  return std::min(4 * k + 16, graph.sites().size());
}

constexpr std::size_t kBlock = 16;

/// Cosines of multiples of 22.5 degrees.
constexpr std::array<float, 16> kCosines = {
    1,  0.92387953F,  0.70710678F,  0.38268343F,  0, -0.38268343F, -0.70710678F, -0.92387953F,
    -1, -0.92387953F, -0.70710678F, -0.38268343F, 0, 0.38268343F,  0.70710678F,  0.92387953F};

}  // namespace

void Reach::measure(const DelaunayGraph& graph, VertexId p, unsigned k) {
  nearness_.fill(0);
  expanded_ = 0;
  met_.clear();
  degree_ = graph.neighbors(p).size();
  // All neighbours of p in any case: `collect` leaves out what comes first.
  const std::size_t near = std::max(near_count(graph, k), degree_ + 1);
  if (near < k + std::size_t{2}) return;  // no circle can hold more than k
  at_p_ = graph.point(p);
  start(p, near);
  while (expanded_ < met_.size() && expand(graph, met_[expanded_], near)) ++expanded_;
  invert(graph);
  if (scale_ == 0) return;
  std::array<double, kSectors> levels;
  for (std::size_t i = 0; i < kSectors; ++i) levels[i] = level(i, k);
  for (std::size_t i = 0; i < kSectors; ++i) {
    // By how many sectors apart: the least angle is one sector less, and from a right angle on nothing is on
    // the same circle.
    double least = levels[i];
    for (std::size_t gap = 1; gap <= 4; ++gap) {
      const double cosine = kCosines[gap - 1];
      least = std::min(
          {least, levels[(i + gap) % kSectors] / cosine, levels[(i + kSectors - gap) % kSectors] / cosine});
    }
    nearness_[i] = least * scale_ * kSlack;
  }
}

bool Reach::collect(const DelaunayGraph& graph) {
  if (*std::min_element(nearness_.begin(), nearness_.end()) == 0) return false;
  reached_.clear();
  const std::size_t most = table_.size() / 2;
  for (std::size_t i = 1; i < met_.size(); ++i) {
    if (is_beyond(way_between(at_p_, graph.point(met_[i])))) continue;
    if (i > degree_) reached_.push_back(met_[i]);
    if (i >= expanded_ && !expand(graph, met_[i], most)) return false;
  }
  return true;
}

/// Makes room for so many sites near p, and for eight times as many later.
void Reach::start(VertexId p, std::size_t near) {
  table_.assign(std::bit_ceil(16 * near), VertexId());
  meet(p);
}

/// Meets the neighbours of v; false if there are too many, and then perhaps not all.
bool Reach::expand(const DelaunayGraph& graph, VertexId v, std::size_t most) {
  for (const VertexId w : graph.neighbors(v)) {
    if (met_.size() >= most) return false;
    meet(w);
  }
  return true;
}

void Reach::meet(VertexId v) {
  const std::size_t mask = table_.size() - 1;
  std::size_t place = (v.index() * std::size_t{0x9e3779b9u} >> 7) & mask;
  for (; table_[place].valid(); place = (place + 1) & mask) {
    if (table_[place] == v) return;
  }
  table_[place] = v;
  met_.push_back(v);
}

void Reach::invert(const DelaunayGraph& graph) {
  scale_ = 0;
  if (met_.size() < 2) return;
  const double unit = way_between(at_p_, graph.point(met_[1])).square;
  if (!(unit > 0x1p-400 && unit < 0x1p400)) return;
  scale_ = std::ldexp(1.0, -std::ilogb(unit) / 2);
  const std::size_t room = (met_.size() + kBlock - 1) / kBlock * kBlock;
  for (std::vector<float>* column : {&x_, &y_, &bound_, &value_}) column->assign(room, 0);
  for (std::size_t i = 1; i < met_.size(); ++i) {
    const Point2 at = graph.point(met_[i]);
    const double x = (at.x - at_p_.x) * scale_, y = (at.y - at_p_.y) * scale_;
    const double square = x * x + y * y;
    if (!(square > 0x1p-40 && square < 0x1p40)) continue;
    // A sum of two products of a coordinate and a cosine, each rounded to u = 2^-24, is wrong by 4 u of the
    // sum of sizes; taking the bound away rounds once more, and so do the steps to the bound.
    constexpr double kFloatBound = 16 * 0x1p-24;
    x_[i] = static_cast<float>(x / square);
    y_[i] = static_cast<float>(y / square);
    bound_[i] = static_cast<float>(kFloatBound * (std::fabs(x) + std::fabs(y)) / square);
  }
}

/// A level that more than k of the inverted sites come up to in all directions of a sector, 0 if none is
/// found: near the highest, by halving, which compilers turn into comparisons of four sites at a time.
float Reach::level(std::size_t sector, unsigned k) {
  constexpr float kFinest = 0x1p-12F;  // beyond 4096 times the distance of a neighbour there is no bound
  const std::size_t count = x_.size(), next = (sector + 1) % kSectors;
  const float dx = kCosines[sector], dy = kCosines[(sector + 12) % kSectors];
  const float ex = kCosines[next], ey = kCosines[(next + 12) % kSectors];
  for (std::size_t i = 0; i < count; ++i) {
    const float d = x_[i] * dx + y_[i] * dy, e = x_[i] * ex + y_[i] * ey;
    value_[i] = (d < e ? d : e) - bound_[i];
  }
  const auto come_up_to = [&](float level) {
    std::uint32_t above = 0;
    for (std::size_t i = 0; i < count; ++i) above += value_[i] >= level ? 1u : 0u;
    return above;
  };
  float low = 0, high = 1;
  while (come_up_to(high) > k) {
    low = high;
    high *= 2;
  }
  while (high - low > low / 32 && high > kFinest) {
    const float middle = (low + high) / 2;
    (come_up_to(middle) > k ? low : high) = middle;
  }
  return low;
}

}  // namespace thalweg::detail
