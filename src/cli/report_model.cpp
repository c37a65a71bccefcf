#include "cli/report_model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "cli/interrupt.hpp"
#include "cli/mesh_measures.hpp"
#include "cli/names.hpp"
#include "cli/summary.hpp"
#include "cli/thin_report.hpp"
#include "io/sha256.hpp"
#include "thalweg/circle_count.hpp"
#include "thalweg/delaunay.hpp"
#include "thalweg/drainage.hpp"
#include "thalweg/pits.hpp"
#include "thalweg/validate.hpp"

namespace thalweg::cli {
namespace {

/// One of the two terrains, measured.
struct Terrain {
  Triangulation mesh;
  Pits pits;
  Drainage water;
  std::vector<double> spill;  // of each pit
};

Terrain measured(Triangulation mesh, std::span<const Point3> points) {
  std::vector<double> z;
  z.reserve(points.size());
  for (const Point3& p : points) z.push_back(p.z);
  Terrain terrain;
  terrain.mesh = std::move(mesh);
  terrain.pits = find_pits(terrain.mesh, z);
  terrain.water = drain(terrain.mesh, points);
  terrain.spill = spill_levels(terrain.mesh, points, terrain.pits);
  return terrain;
}

/// For each sink its level; nothing else is looked up.
std::vector<double> spill_by_sink(const Terrain& terrain) {
  std::vector<double> level(terrain.mesh.vertex_count(), 0);
  for (std::uint32_t i = 0; i < terrain.pits.size(); ++i) {
    level[terrain.water.sink[terrain.pits[i][0].index()].index()] = terrain.spill[i];
  }
  return level;
}

std::vector<io::IndexTriangle> triangles_of(const Triangulation& mesh) {
  std::vector<io::IndexTriangle> triangles;
  triangles.reserve(mesh.face_count());
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    const Triangle t = mesh.corners(FaceId(f));
    io::IndexTriangle made = {t[0].index(), t[1].index(), t[2].index()};
    std::rotate(made.begin(), std::min_element(made.begin(), made.end()), made.end());
    triangles.push_back(made);
  }
  return triangles;
}

/// Splits the triangles into those of both meshes and those of one alone.
void compare(const Triangulation& before, const Triangulation& after, std::span<const std::uint32_t> orders,
             io::Report& report) {
  std::vector<io::IndexTriangle> old = triangles_of(before);
  const std::vector<io::IndexTriangle> now = triangles_of(after);
  std::sort(old.begin(), old.end());
  std::vector<std::uint32_t> by_triangle(now.size());
  std::iota(by_triangle.begin(), by_triangle.end(), 0u);
  std::sort(by_triangle.begin(), by_triangle.end(),
            [&](std::uint32_t a, std::uint32_t b) { return now[a] < now[b]; });
  auto other = old.begin();
  for (const std::uint32_t i : by_triangle) {
    for (; other != old.end() && *other < now[i]; ++other) report.before.push_back(*other);
    if (other != old.end() && *other == now[i]) {
      report.common.push_back(now[i]);
      ++other;
    } else {
      report.after.push_back(now[i]);
      report.after_order.push_back(orders[i]);
    }
  }
  report.before.insert(report.before.end(), other, old.end());
}

io::ReportWater water_of(const Drainage& drainage) {
  return {drainage.basins, drainage.longest_from.index(), drainage.longest_edges, drainage.longest_length};
}

std::vector<std::uint32_t> indices(std::span<const VertexId> vertices) {
  std::vector<std::uint32_t> result;
  result.reserve(vertices.size());
  for (const VertexId v : vertices) result.push_back(v.index());
  return result;
}

/// The edges of `after` that `before` does not have.
std::uint64_t count_changed(const Triangulation& before, const Triangulation& after) {
  std::uint64_t changed = 0;
  for (std::uint32_t i = 0; i < after.halfedge_count(); ++i) {
    const HalfedgeId h(i), twin = after.twin(h);
    if (twin.valid() && h < twin && !before.joined(after.origin(h), after.dest(h))) ++changed;
  }
  return changed;
}

/// All that follows from the two meshes alone; pits must have been listed.
void fill_in(io::Report& report, const Terrain& before, const Terrain& after,
             std::span<const std::uint32_t> orders) {
  report.vertices = report.points.size();
  report.triangles = after.mesh.face_count();
  report.names.resize(report.points.size());
  std::iota(report.names.begin(), report.names.end(), 0u);
  compare(before.mesh, after.mesh, orders, report);
  report.downstream = {indices(before.water.downstream), indices(after.water.downstream)};
  report.water = {water_of(before.water), water_of(after.water)};
  report.pits = {before.pits.count(), after.pits.count()};
  report.order_histogram = order_histogram(orders);
  const std::vector<double> old_level = spill_by_sink(before), new_level = spill_by_sink(after);
  for (io::ReportPit& pit : report.removed) pit.spill_level = old_level[pit.vertex];
  for (io::ReportPit& pit : report.remaining) pit.spill_level = new_level[pit.vertex];
}

/// The sites as the input has them: its rows but those merged into others.
std::vector<Point3> input_sites(std::span<const Point3> rows, const Minimized& result) {
  std::vector<std::uint8_t> gone(rows.size(), 0);
  for (const auto& [row, kept] : result.merged) gone[row] = 1;
  std::vector<Point3> sites;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    if (gone[row] == 0) sites.push_back(rows[row]);
  }
  return sites;
}

/// The sites as the triangles have them.
std::vector<Point3> output_sites(const io::Report& report) {
  std::vector<std::uint8_t> used(report.points.size(), 0);
  for (const auto* triangles : {&report.common, &report.after}) {
    for (const io::IndexTriangle& t : *triangles) {
      for (const std::uint32_t v : t) used[v] = 1;
    }
  }
  std::vector<Point3> sites;
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (used[v] != 0) sites.push_back(report.points[v]);
  }
  return sites;
}

io::Report begun(const ReportSource& source, std::vector<Point3> points) {
  io::Report report;
  report.file = source.file;
  report.crs = source.crs;
  report.method = source.method;
  report.order = source.order;
  report.points = std::move(points);
  return report;
}

}  // namespace

io::Report report_of_build(const ReportSource& source, std::span<const Point3> rows,
                           const VertexMap& vertices, const Minimized& result) {
  io::Report report = begun(source, vertices.points);
  report.rows = rows.size();
  report.merged = result.merged.size();
  report.lower_bound = result.lower_bound;
  report.certified = result.certified;
  report.order_searched = result.order_searched;
  report.edges_changed = result.edges_changed;
  report.non_delaunay_edges = result.non_delaunay_edges;
  report.min_angle_deg = {result.min_angle_before_deg, result.min_angle_after_deg};
  const auto vertex = [&](VertexId row) { return vertices.vertex_of_row[row.index()]; };
  for (const RemovedPit& pit : result.removed) {
    report.removed.push_back(
        {.vertex = vertex(pit.vertex), .vertices = pit.vertices, .boundary = pit.boundary});
  }
  for (const RemainingPit& pit : result.remaining) {
    report.remaining.push_back({.vertex = vertex(pit.vertex),
                                .vertices = pit.vertices,
                                .boundary = pit.boundary,
                                .reason = std::string(name_of(pit.reason)),
                                .order_needed = pit.order_needed});
  }
  // Sites that were triangulated once are so again: they are distinct and finite.
  Triangulation delaunay = *thalweg::delaunay(places_of(report.points), {.threads = source.threads});
  std::vector<Triangle> triangles;
  triangles.reserve(result.triangulation.face_count());
  for (std::uint32_t f = 0; f < result.triangulation.face_count(); ++f) {
    const Triangle t = result.triangulation.corners(FaceId(f));
    triangles.push_back({VertexId(vertex(t[0])), VertexId(vertex(t[1])), VertexId(vertex(t[2]))});
  }
  const auto count = static_cast<std::uint32_t>(report.points.size());
  const Terrain before = measured(std::move(delaunay), report.points);
  const Terrain after = measured(*Triangulation::from_triangles(triangles, count), report.points);
  fill_in(report, before, after, result.face_orders);
  report.hash_in = io::hash_of_sites(input_sites(rows, result));
  report.hash_out = io::hash_of_sites(output_sites(report));
  thin_report(report);
  return report;
}

namespace {

/// Pits of `after` and Delaunay pits that have nothing left, with what is known of them from `known`.
void list_pits(io::Report& report, const Terrain& before, const Terrain& after, const Minimized& known) {
  std::vector<const RemainingPit*> by_vertex(report.points.size(), nullptr);
  for (const RemainingPit& pit : known.remaining) by_vertex[pit.vertex.index()] = &pit;
  std::vector<std::uint8_t> still(report.points.size(), 0);
  for (std::uint32_t i = 0; i < after.pits.size(); ++i) {
    for (const VertexId v : after.pits[i]) still[v.index()] = 1;
    io::ReportPit pit;
    pit.vertex = after.water.sink[after.pits[i][0].index()].index();
    pit.vertices = static_cast<std::uint32_t>(after.pits[i].size());
    pit.boundary = after.pits.boundary(i);
    if (by_vertex[pit.vertex] != nullptr) pit.order_needed = by_vertex[pit.vertex]->order_needed;
    const bool removable = pit.order_needed && *pit.order_needed <= report.order;
    const bool unknown = by_vertex[pit.vertex] == nullptr;
    pit.reason = name_of(removable || unknown ? PitReason::kept : PitReason::unremovable);
    report.remaining.push_back(std::move(pit));
  }
  for (std::uint32_t i = 0; i < before.pits.size(); ++i) {
    const auto members = before.pits[i];
    if (std::ranges::any_of(members, [&](VertexId v) { return still[v.index()] != 0; })) continue;
    report.removed.push_back({.vertex = before.water.sink[members[0].index()].index(),
                              .vertices = static_cast<std::uint32_t>(members.size()),
                              .boundary = before.pits.boundary(i)});
  }
  const auto earlier = [](const io::ReportPit& a, const io::ReportPit& b) { return a.vertex < b.vertex; };
  std::ranges::sort(report.remaining, earlier);
  std::ranges::sort(report.removed, earlier);
}

Result<Triangulation> sound_mesh(const io::MeshFile& file, std::span<const Point2> places) {
  const std::vector<Fault> faults = find_faults(places, file.triangles);
  if (!faults.empty()) {
    return Error{ErrorCode::invalid_mesh, std::string("not a triangulation of its vertices: ") +
                                              fault_name(faults[0].kind) + " (thalweg check says more)"};
  }
  std::vector<Triangle> triangles;
  triangles.reserve(file.triangles.size());
  for (const io::IndexTriangle& t : file.triangles) {
    triangles.push_back({VertexId(t[0]), VertexId(t[1]), VertexId(t[2])});
  }
  auto mesh = Triangulation::from_triangles(triangles, static_cast<std::uint32_t>(places.size()));
  if (!mesh) return Error{ErrorCode::invalid_mesh, "the triangles do not form a triangulation"};
  return *std::move(mesh);
}

}  // namespace

Result<io::Report> report_of_mesh(const ReportSource& source, const io::MeshFile& file) {
  const std::vector<Point2> places = places_of(file.points);
  Result<Triangulation> mesh = sound_mesh(file, places);
  if (!mesh) return mesh.error();
  Result<Triangulation> delaunay = thalweg::delaunay(places, {.threads = source.threads});
  if (!delaunay) return delaunay.error();
  const DelaunayGraph graph(places, *delaunay);
  const std::vector<std::uint32_t> orders =
      face_orders(graph, *mesh, static_cast<std::uint32_t>(places.size()), source.threads);

  io::Report report = begun(source, file.points);
  report.order = *std::ranges::max_element(orders);
  MinimizeOptions options;
  options.order = report.order;
  options.method = Method::delaunay;
  options.threads = source.threads;
  options.cancel = &interrupted();
  const Result<Minimized> known = minimize_pits(file.points, options);
  if (!known) return known.error();
  report.lower_bound = known->lower_bound;
  report.order_searched = known->order_searched;
  report.edges_changed = count_changed(*delaunay, *mesh);
  report.non_delaunay_edges = count_non_delaunay(*mesh, places);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  report.min_angle_deg = {known->min_angle_before_deg, nan};
  const Terrain before = measured(*std::move(delaunay), report.points);
  const Terrain after = measured(*std::move(mesh), report.points);
  list_pits(report, before, after, *known);
  fill_in(report, before, after, orders);
  report.certified = report.pits[1].total == report.lower_bound;
  report.hash_out = io::hash_of_sites(output_sites(report));
  thin_report(report);
  return report;
}

}  // namespace thalweg::cli
