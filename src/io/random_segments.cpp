/// Random segments by rejection: an end that is nearly collinear with two others is drawn again. The
/// instances need coordinates the larger, the nearer to collinear the ends are.
#include "io/random_segments.hpp"

#include <string>

#include "io/random.hpp"

namespace thalweg::io {
namespace {

/// Twice the least area of a triangle of ends, for ends in a square of side 32 n: (side / 4n)^2. Each of the
/// 2n^2 pairs forbids a strip of about side^2 / 8n^2 on average, so that at least some two draws in three
/// succeed.
constexpr std::int64_t kLeastArea = 64;

/// Whether p makes a triangle of less than the least area with two of `ends`, or is one of them.
bool spoils_position(const std::vector<LatticePoint>& ends, LatticePoint p) {
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (ends[i] == p) return true;
    for (std::size_t j = 0; j < i; ++j) {
      const std::int64_t area = (ends[i].x - p.x) * (ends[j].y - p.y) - (ends[i].y - p.y) * (ends[j].x - p.x);
      if (-kLeastArea < area && area < kLeastArea) return true;
    }
  }
  return false;
}

}  // namespace

Result<std::vector<LatticeSegment>> random_segments(std::uint32_t count, std::uint64_t seed) {
  if (count > kMostRandomSegments) {
    return Error{ErrorCode::invalid_argument, std::to_string(count) + " random segments: ask for at most " +
                                                  std::to_string(kMostRandomSegments)};
  }
  Random random(seed);
  const std::uint64_t side = std::uint64_t{32} * count;
  std::vector<LatticePoint> ends;
  while (ends.size() < std::size_t{2} * count) {
    const auto x = static_cast<std::int64_t>(random.below(side));
    const auto y = static_cast<std::int64_t>(random.below(side));
    if (!spoils_position(ends, {x, y})) ends.push_back({x, y});
  }
  std::vector<LatticeSegment> segments;
  for (std::size_t i = 0; i < ends.size(); i += 2) segments.push_back({ends[i], ends[i + 1]});
  return segments;
}

}  // namespace thalweg::io
