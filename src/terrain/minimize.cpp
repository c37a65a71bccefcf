/// The one way through the house: points, sites, Delaunay, heuristic, report.
#include "thalweg/minimize.hpp"

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>

#include "kernel/assert.hpp"
#include "kernel/delaunay_sites.hpp"
#include "kernel/parallel.hpp"
#include "terrain/assign.hpp"
#include "terrain/best.hpp"
#include "terrain/changes.hpp"
#include "terrain/exact.hpp"
#include "terrain/exits.hpp"
#include "terrain/flip.hpp"
#include "terrain/hull.hpp"
#include "terrain/merge.hpp"
#include "terrain/reasons.hpp"
#include "terrain/surface.hpp"

namespace thalweg {
namespace {

using detail::MergedSites;
using detail::Outcome;
using detail::Surface;
using detail::Watch;

constexpr unsigned kMostRows = 1'000'000;

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

Error cancelled() {
  return {ErrorCode::cancelled, "cancelled by the caller", {}};
}

Watch watch_of(const MinimizeOptions& options) {
  return {options.progress, options.cancel, detail::resolve_threads(options.threads), options.keep_trail, {}};
}

/// The same watch, that also stops after so many seconds from now; 0 = never.
Watch limited(Watch watch, double seconds) {
  if (seconds > 0) {
    using Clock = std::chrono::steady_clock;
    // A limit beyond a century is none; the clock could not count to it either.
    constexpr double kCentury = 100 * 365.25 * 86400;
    if (seconds < kCentury) {
      watch.deadline =
          Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
    }
  }
  return watch;
}

/// The canonical Delaunay triangulation of merged sites; an error names the caller's rows.
Result<Triangulation> triangulate(const MergedSites& sites, const Watch& watch) {
  auto delaunay = detail::delaunay_of_sites(sites.xy, sites.keys, watch.threads);
  if (delaunay) return delaunay;
  Error error = std::move(delaunay).error();
  for (std::uint32_t& row : error.rows) row = sites.row[row];
  return error;
}

/// The order that matters: no circle through three sites holds more than all the others.
unsigned effective_order(const Surface& surface, unsigned k) {
  return static_cast<unsigned>(std::min<std::size_t>(k, surface.sites().size() - 3));
}

Outcome run_method(const Surface& surface, std::span<const detail::Exit> exits, const detail::Plan& plan,
                   unsigned k, Method method, const Watch& watch) {
  switch (method) {
    case Method::flip:
      return detail::flip_pits(surface, k, watch);
    case Method::hull:
      return detail::insert_hulls(surface, exits, k, watch);
    case Method::best:
    case Method::exact:
      return detail::best_pits(surface, exits, plan, k, watch);
    case Method::delaunay:
      break;
  }
  Outcome outcome;
  outcome.triangulation = Triangulation::revision_of(surface.delaunay());
  outcome.pits = surface.pits().size();
  return outcome;
}

/// The pits of the Delaunay triangulation of which the result has nothing left.
std::vector<RemovedPit> removed_pits(const Surface& surface, const Pits& after) {
  std::vector<std::uint8_t> remains(surface.pits().size(), 0);
  for (std::uint32_t i = 0; i < after.size(); ++i) {
    for (const VertexId v : after[i]) {
      if (surface.pit_of(v) != Surface::kNoPit) remains[surface.pit_of(v)] = 1;
    }
  }
  std::vector<RemovedPit> removed;
  for (std::uint32_t i = 0; i < surface.pits().size(); ++i) {
    if (remains[i] != 0) continue;
    const auto pit = surface.pits()[i];
    removed.push_back(
        {surface.lowest(pit), static_cast<std::uint32_t>(pit.size()), surface.pits().boundary(i)});
  }
  return removed;
}

/// Everything that is reported about the result, with the vertex ids of the surface. Takes its face orders
/// from the outcome.
void describe(const Surface& surface, Outcome& outcome, std::span<const detail::Exit> exits, unsigned k,
              Method method, const Watch& watch, Minimized& result) {
  const Triangulation& t = outcome.triangulation;
  Pits after;
  std::vector<FaceId> changed;
  detail::EdgeChanges edges;
  detail::parallel_both(
      watch.threads, [&] { after = find_pits(t, surface.z()); },
      [&] {
        changed = detail::changed_faces(surface, t);
        edges = detail::edge_changes(surface, t, changed);
      });
  THALWEG_ASSERT(after.size() == outcome.pits);
  result.delaunay_pits = surface.pits().count();
  result.pits = after.count();

  watch.report("explaining", 0);
  detail::Explained explained = detail::explain_pits(surface, after, exits, k, method, watch);
  result.remaining = std::move(explained.pits);
  result.order_searched = explained.order_searched;
  result.removed = removed_pits(surface, after);

  result.circle_counts = outcome.circle_counts;
  result.face_orders = outcome.face_orders.empty()
                           ? detail::orders_after(surface, t, changed, k, watch.threads, result.circle_counts)
                           : std::move(outcome.face_orders);
  result.edges_changed = edges.changed;
  result.non_delaunay_edges = edges.non_delaunay;
  const detail::SmallestAngles angles = detail::smallest_angles(surface, t, watch.threads);
  result.min_angle_before_deg = angles.before_deg;
  result.min_angle_after_deg = angles.after_deg;
  result.flips = outcome.flips;
  result.insertions = outcome.insertions;
}

/// From the ids of the surface to the caller's.
void rename(std::span<const std::uint32_t> row, Minimized& result) {
  const auto to_row = [&](VertexId& v) {
    if (v.valid()) v = VertexId(row[v.index()]);
  };
  for (RemainingPit& pit : result.remaining) to_row(pit.vertex);
  for (RemovedPit& pit : result.removed) to_row(pit.vertex);
  const auto by_vertex = [](const auto& a, const auto& b) { return a.vertex < b.vertex; };
  std::sort(result.remaining.begin(), result.remaining.end(), by_vertex);
  std::sort(result.removed.begin(), result.removed.end(), by_vertex);
  for (TrailStep& step : result.trail) {
    for (VertexId* v : {&step.u, &step.v, &step.old_u, &step.old_v, &step.pit}) to_row(*v);
  }
}

/// Best and bound at one order of a sweep.
SweepRow sweep_row(const Surface& surface, std::span<const detail::Exit> all_exits, unsigned k,
                   const Watch& watch) {
  const auto exits = detail::exits_up_to(all_exits, k);
  const detail::Plan plan = detail::make_plan(surface, exits, k, watch);
  SweepRow row;
  row.best = detail::best_pits(surface, exits, plan, k, watch).pits;
  row.lower_bound = plan.bound;
  row.certified = row.best == row.lower_bound;
  return row;
}

}  // namespace

Result<Minimized> minimize_pits(std::span<const Point3> points, const MinimizeOptions& options) {
  const Watch watch = watch_of(options);
  const detail::TeamScope team(watch.threads);
  auto start = std::chrono::steady_clock::now();
  watch.report("triangulating", 0);
  auto merged = detail::merge_sites(points, options.duplicates, watch.threads);
  if (!merged) return std::move(merged).error();
  MergedSites sites = *std::move(merged);
  auto delaunay = triangulate(sites, watch);
  if (!delaunay) return std::move(delaunay).error();
  sites.keys = detail::Array<std::uint32_t>();

  Minimized result;
  result.sites = static_cast<std::uint32_t>(sites.xy.size());
  result.merged = std::move(sites.merged);
  result.mean_elevations = std::move(sites.mean_elevations);
  result.seconds_delaunay = seconds_since(start);
  if (watch.stopped()) return cancelled();

  start = std::chrono::steady_clock::now();
  Surface surface(std::move(sites.xy), std::move(sites.z), *std::move(delaunay), watch.threads);
  const unsigned k = effective_order(surface, options.order);
  if (options.counter == Counter::voronoi) {
    // Circles of up to k sites are told apart by the k + 1 nearest.
    watch.report("building the Voronoi diagram", 0);
    if (auto error = surface.count_by_voronoi(k + 1, watch.threads)) return *std::move(error);
  }
  watch.report("searching exits", 0);
  const std::vector<detail::Exit> exits = detail::find_exits(surface, k, watch.threads, options.cancel);
  if (watch.stopped()) return cancelled();
  watch.report("choosing exits", 0);
  const detail::Plan plan = detail::make_plan(surface, exits, k, watch);
  if (watch.stopped()) return cancelled();
  watch.report("removing pits", 0);
  Outcome outcome = run_method(surface, exits, plan, k, options.method, watch);
  if (watch.stopped()) return cancelled();
  result.lower_bound = plan.bound;
  if (options.method == Method::exact) {
    watch.report("searching for less", 0);
    detail::ExactOutcome exact =
        detail::exact_pits(surface, plan, std::move(outcome), k, limited(watch, options.time_limit));
    outcome = std::move(exact.outcome);
    result.lower_bound = exact.bound;
    if (watch.stopped()) return cancelled();
  }
  describe(surface, outcome, exits, k, options.method, watch, result);
  result.certified = result.pits.total == result.lower_bound;
  if (watch.stopped()) return cancelled();

  result.trail = std::move(outcome.trail);
  rename(sites.row, result);
  result.triangulation = std::move(surface)
                             .release(std::move(outcome.triangulation))
                             .renamed(sites.row, static_cast<std::uint32_t>(points.size()), watch.threads);
  result.seconds_minimize = seconds_since(start);
  return result;
}

Result<Sweep> sweep_pits(std::span<const Point3> points, unsigned first, unsigned last,
                         const MinimizeOptions& options) {
  if (first > last || last - first >= kMostRows) {
    return Error{ErrorCode::invalid_argument,
                 "a sweep needs a first order that is not larger than the last, and at most " +
                     std::to_string(kMostRows) + " orders",
                 {}};
  }
  const Watch watch = watch_of(options);
  const detail::TeamScope team(watch.threads);
  auto merged = detail::merge_sites(points, options.duplicates, watch.threads);
  if (!merged) return std::move(merged).error();
  MergedSites sites = *std::move(merged);
  auto delaunay = triangulate(sites, watch);
  if (!delaunay) return std::move(delaunay).error();

  const Surface surface(std::move(sites.xy), std::move(sites.z), *std::move(delaunay), watch.threads);
  const unsigned most = effective_order(surface, last);
  const std::vector<detail::Exit> exits = detail::find_exits(surface, most, watch.threads, options.cancel);
  std::vector<std::uint32_t> hull_pits, flip_pits;
  static_cast<void>(detail::insert_hulls(surface, exits, most, watch, &hull_pits));
  static_cast<void>(detail::flip_pits(surface, most, watch, &flip_pits));

  Sweep sweep;
  sweep.sites = static_cast<std::uint32_t>(surface.sites().size());
  for (unsigned k = first; k <= last && !watch.stopped(); ++k) {
    if (!sweep.rows.empty() && sweep.rows.back().order >= most) {
      sweep.rows.push_back(sweep.rows.back());
    } else {
      sweep.rows.push_back(sweep_row(surface, exits, std::min(k, most), watch));
      sweep.rows.back().flip = flip_pits[std::min(k, most)];
      sweep.rows.back().hull = hull_pits[std::min(k, most)];
    }
    sweep.rows.back().order = k;
    watch.report("sweeping", static_cast<double>(k - first + 1) / (last - first + 1));
    if (k == last) break;  // before ++k could overflow
  }
  if (watch.stopped()) return cancelled();
  return sweep;
}

}  // namespace thalweg
