/// The main job for C.
#include <algorithm>
#include <memory>

#include "bindings/c/arrays.hpp"
#include "bindings/c/handles.hpp"
#include "bindings/c/options.hpp"
#include "bindings/c/structs.hpp"

namespace thalweg::bindings {
namespace {

static_assert(THALWEG_REASON_UNREMOVABLE == static_cast<int>(PitReason::unremovable));
static_assert(THALWEG_REASON_CONFLICT == static_cast<int>(PitReason::conflict));
static_assert(THALWEG_REASON_KEPT == static_cast<int>(PitReason::kept));
static_assert(THALWEG_STEP_FLIP == static_cast<int>(TrailStep::Kind::flip));
static_assert(THALWEG_STEP_INSERTION == static_cast<int>(TrailStep::Kind::insertion));

// The last member of the first version.
constexpr std::size_t kSummarySize = offsetof(thalweg_summary, seconds_minimize) + sizeof(double);
static_assert(kSummarySize == sizeof(thalweg_summary), "no padding at the end, see guard.cpp");

thalweg_pit_count to_c(const PitCount& count) noexcept {
  return {count.total, count.interior, count.boundary};
}

thalweg_remaining_pit to_c(const RemainingPit& pit) noexcept {
  return {pit.vertex.index(), pit.vertices, pit.boundary ? 1u : 0u, static_cast<int32_t>(pit.reason),
          pit.order_needed.value_or(THALWEG_NONE)};
}

thalweg_removed_pit to_c(const RemovedPit& pit) noexcept {
  return {pit.vertex.index(), pit.vertices, pit.boundary ? 1u : 0u};
}

thalweg_merged_row to_c(const std::pair<std::uint32_t, std::uint32_t>& merged) noexcept {
  return {merged.first, merged.second};
}

thalweg_mean_elevation to_c(const std::pair<std::uint32_t, double>& mean) noexcept {
  return {mean.second, mean.first, 0};
}

thalweg_trail_step to_c(const TrailStep& step) noexcept {
  return {static_cast<int32_t>(step.kind),
          step.order,
          step.u.index(),
          step.v.index(),
          step.old_u.index(),
          step.old_v.index(),
          step.pit.index()};
}

thalweg_sweep_row to_c(const SweepRow& row) noexcept {
  return {row.order, row.flip, row.hull, row.best, row.lower_bound, row.certified ? 1u : 0u};
}

thalweg_summary summarize(const thalweg_terrain& terrain) noexcept {
  const Minimized& report = terrain.report;
  thalweg_summary s = {};
  s.vertex_count = terrain.mesh.triangulation.vertex_count();
  s.site_count = report.sites;
  s.triangle_count = terrain.mesh.triangulation.face_count();
  for (const std::uint32_t order : report.face_orders) s.max_order = std::max(s.max_order, order);
  s.delaunay_pits = to_c(report.delaunay_pits);
  s.pits = to_c(report.pits);
  s.lower_bound = report.lower_bound;
  s.certified = report.certified ? 1 : 0;
  s.order_searched = report.order_searched;
  s.remaining_count = static_cast<uint32_t>(report.remaining.size());
  s.removed_count = static_cast<uint32_t>(report.removed.size());
  s.merged_count = static_cast<uint32_t>(report.merged.size());
  s.mean_count = static_cast<uint32_t>(report.mean_elevations.size());
  s.edges_changed = report.edges_changed;
  s.non_delaunay_edges = report.non_delaunay_edges;
  s.trail_count = report.trail.size();
  s.flips = report.flips;
  s.insertions = report.insertions;
  s.circle_counts = report.circle_counts;
  s.min_angle_before_deg = report.min_angle_before_deg;
  s.min_angle_after_deg = report.min_angle_after_deg;
  s.seconds_delaunay = report.seconds_delaunay;
  s.seconds_minimize = report.seconds_minimize;
  return s;
}

/// Writes one of the report's lists.
template <class Item, class List>
thalweg_status write_list(const thalweg_terrain* terrain, List Minimized::*list, Item* out,
                          std::size_t capacity, const char* name, thalweg_error* error) noexcept {
  return guarded(error, [&]() -> std::optional<Error> {
    if (auto wrong = check_handle(terrain, "terrain")) return wrong;
    const List& items = terrain->report.*list;
    if (auto wrong = check_room(out, capacity, items.size(), name)) return wrong;
    std::ranges::transform(items, out, [](const auto& item) { return to_c(item); });
    return std::nullopt;
  });
}

}  // namespace
}  // namespace thalweg::bindings

using namespace thalweg;
using namespace thalweg::bindings;

thalweg_status thalweg_build(const double* xyz, size_t n, const thalweg_build_options* options,
                             thalweg_terrain** terrain, thalweg_error* error) {
  return guarded(error, [&]() -> std::optional<Error> {
    if (auto wrong = prepare(terrain, "the terrain")) return wrong;
    if (auto wrong = check_input(xyz, n, "xyz")) return wrong;
    if (auto wrong = check_count(n, "points")) return wrong;
    std::atomic<bool> stop = false;
    const Result<MinimizeOptions> wanted = read_options(options, stop);
    if (!wanted) return wanted.error();
    auto made = std::make_unique<thalweg_terrain>();
    Result<Minimized> minimized = minimize_pits(points3(xyz, n), *wanted);
    if (!minimized) return std::move(minimized).error();
    made->report = *std::move(minimized);
    made->mesh.triangulation = std::move(made->report.triangulation);
    made->mesh.borrowed = true;
    *terrain = made.release();
    return std::nullopt;
  });
}

thalweg_status thalweg_terrain_summary(const thalweg_terrain* terrain, thalweg_summary* summary,
                                       thalweg_error* error) {
  return guarded(error, [&]() -> std::optional<Error> {
    if (auto wrong = check_handle(terrain, "terrain")) return wrong;
    if (summary == nullptr) return usage("summary is null");
    if (!plausible_size(summary->struct_size, kSummarySize)) {
      return usage("summary->struct_size is " + std::to_string(summary->struct_size) +
                   ": set it to sizeof(thalweg_summary)");
    }
    give(summary, summarize(*terrain), summary->struct_size);
    return std::nullopt;
  });
}

const thalweg_mesh* thalweg_terrain_mesh(const thalweg_terrain* terrain) {
  return is_handle(terrain) ? &terrain->mesh : nullptr;
}

thalweg_status thalweg_terrain_orders(const thalweg_terrain* terrain, uint32_t* orders, size_t capacity,
                                      thalweg_error* error) {
  return guarded(error, [&]() -> std::optional<Error> {
    if (auto wrong = check_handle(terrain, "terrain")) return wrong;
    const std::vector<std::uint32_t>& all = terrain->report.face_orders;
    if (auto wrong = check_room(orders, capacity, all.size(), "orders")) return wrong;
    std::ranges::copy(all, orders);
    return std::nullopt;
  });
}

thalweg_status thalweg_terrain_remaining(const thalweg_terrain* terrain, thalweg_remaining_pit* pits,
                                         size_t capacity, thalweg_error* error) {
  return write_list(terrain, &Minimized::remaining, pits, capacity, "pits", error);
}

thalweg_status thalweg_terrain_removed(const thalweg_terrain* terrain, thalweg_removed_pit* pits,
                                       size_t capacity, thalweg_error* error) {
  return write_list(terrain, &Minimized::removed, pits, capacity, "pits", error);
}

thalweg_status thalweg_terrain_merged(const thalweg_terrain* terrain, thalweg_merged_row* rows,
                                      size_t capacity, thalweg_error* error) {
  return write_list(terrain, &Minimized::merged, rows, capacity, "rows", error);
}

thalweg_status thalweg_terrain_means(const thalweg_terrain* terrain, thalweg_mean_elevation* rows,
                                     size_t capacity, thalweg_error* error) {
  return write_list(terrain, &Minimized::mean_elevations, rows, capacity, "rows", error);
}

thalweg_status thalweg_terrain_trail(const thalweg_terrain* terrain, thalweg_trail_step* steps,
                                     size_t capacity, thalweg_error* error) {
  return write_list(terrain, &Minimized::trail, steps, capacity, "steps", error);
}

void thalweg_terrain_free(thalweg_terrain* terrain) {
  free_handle(terrain);
}

thalweg_status thalweg_sweep(const double* xyz, size_t n, uint32_t first, uint32_t last,
                             const thalweg_build_options* options, thalweg_sweep_row* rows, size_t capacity,
                             thalweg_error* error) {
  return guarded(error, [&]() -> std::optional<Error> {
    if (auto wrong = check_input(xyz, n, "xyz")) return wrong;
    if (auto wrong = check_count(n, "points")) return wrong;
    std::atomic<bool> stop = false;
    const Result<MinimizeOptions> wanted = read_options(options, stop);
    if (!wanted) return wanted.error();
    if (first <= last) {
      if (auto wrong = check_room(rows, capacity, std::size_t{last - first} + 1, "rows")) return wrong;
    }
    const Result<Sweep> sweep = sweep_pits(points3(xyz, n), first, last, *wanted);
    if (!sweep) return sweep.error();
    std::ranges::transform(sweep->rows, rows, [](const SweepRow& row) { return to_c(row); });
    return std::nullopt;
  });
}
