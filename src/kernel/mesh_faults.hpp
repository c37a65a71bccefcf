/// What the two halves of the mesh checker share: the log of faults, and the mesh once its obvious faults are
/// gone.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "thalweg/point.hpp"
#include "thalweg/validate.hpp"

namespace thalweg::detail {

using Corners = std::array<std::uint32_t, 3>;

/// Counts faults by kind and keeps the first few of each.
class FaultLog {
 public:
  static constexpr std::uint64_t kMostCounted = 1000000;
  static constexpr std::size_t kMostExamples = 5;
  static constexpr std::size_t kKinds = static_cast<std::size_t>(FaultKind::hole) + 1;

  /// Counts one fault; `text` makes its example and is called only if that is kept.
  template <class Text>
  void add(FaultKind kind, Text&& text) {
    Fault& fault = faults_[static_cast<std::size_t>(kind)];
    if (fault.count < kMostCounted) ++fault.count;
    if (fault.examples.size() < kMostExamples) fault.examples.push_back(text());
  }
  bool full(FaultKind kind) const noexcept {
    return faults_[static_cast<std::size_t>(kind)].count >= kMostCounted;
  }
  bool empty() const noexcept;
  /// The kinds that occurred, in the order of FaultKind.
  std::vector<Fault> take() &&;

 private:
  std::array<Fault, kKinds> faults_;
};

/// A directed edge between two places.
struct Edge {
  std::uint32_t from;
  std::uint32_t to;
};

/// The triangles that have an area, each once and turned counter-clockwise. A place is the first of the
/// vertices with the same (x, y).
struct CleanMesh {
  std::span<const Point2> points;
  std::span<const Corners> given;    ///< the caller's triangles, for examples
  std::vector<Corners> corners;      ///< places, counter-clockwise
  std::vector<std::uint32_t> names;  ///< index in `given` of each
  std::vector<Edge> border;  ///< edges with more triangles on the left than on the right, each pair once
  std::vector<Edge> edges;   ///< every pair of joined places once
  std::vector<std::uint32_t> hull_next;  ///< by place: the next on the hull, counter-clockwise; kNoPlace

  static constexpr std::uint32_t kNoPlace = 0xffffffffu;
};

/// "triangle 17 (4, 8, 2)".
std::string triangle_text(std::span<const Corners> given, std::uint32_t triangle);

/// Logs every crossing, overlap and hole of a mesh. Always logs something if some point of the hull off all
/// edges is not covered exactly once. After so many steps of comparing two boxes, by default some seconds, a
/// sweep stops; then what is logged is a part of the faults.
void search_faults(const CleanMesh& mesh, FaultLog& log, std::uint64_t most_steps = std::uint64_t{1} << 31);

}  // namespace thalweg::detail
