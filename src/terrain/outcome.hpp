/// What a heuristic hands on: a triangulation of the surface, and how it came about.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "thalweg/minimize.hpp"
#include "thalweg/triangulation.hpp"

namespace thalweg::detail {

struct Outcome {
  Triangulation triangulation;
  std::uint32_t pits = 0;
  std::vector<TrailStep> trail;  // vertex ids of the surface
  std::uint64_t flips = 0;
  std::uint64_t insertions = 0;
  std::uint64_t circle_counts = 0;
  std::vector<std::uint32_t> face_orders = {};  // of every face, if they were counted on the way; else empty

  /// Notes that an edge was inserted from `from` to `to`, and what pit that removed. Orders counted before
  /// are no longer those of all faces.
  void note_insertion(unsigned order, VertexId from, VertexId to, VertexId pit, bool keep_trail) {
    ++insertions;
    face_orders.clear();
    if (keep_trail)
      trail.push_back({TrailStep::Kind::insertion, order, from, to, VertexId(), VertexId(), pit});
  }
};

/// How a long computation is watched and stopped. A stage that finds `stopped()` true returns early; what it
/// returns is then of no meaning and thrown away by whoever asked for the stop.
struct Watch {
  std::function<void(const char* stage, double fraction)> progress;
  const std::atomic<bool>* cancel = nullptr;
  unsigned threads = 1;
  bool keep_trail = false;
  std::optional<std::chrono::steady_clock::time_point> deadline = {};

  bool stopped() const noexcept {
    return (cancel != nullptr && cancel->load(std::memory_order_relaxed)) ||
           (deadline && std::chrono::steady_clock::now() >= *deadline);
  }
  void report(const char* stage, double fraction) const {
    if (progress) progress(stage, fraction);
  }
};

}  // namespace thalweg::detail
