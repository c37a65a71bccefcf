/// Meshes and pits for C.
#include <algorithm>
#include <memory>

#include "bindings/c/arrays.hpp"
#include "bindings/c/handles.hpp"
#include "thalweg/delaunay.hpp"

namespace thalweg::bindings {
namespace {

/// Requires: VertexId::kInvalid and a twin that is missing are THALWEG_NONE.
static_assert(VertexId::kInvalid == THALWEG_NONE);

Result<Triangulation> link(std::span<const std::uint32_t> ids, std::size_t n) {
  std::vector<Triangle> triangles(ids.size() / 3);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    triangles[t] = {VertexId(ids[3 * t]), VertexId(ids[3 * t + 1]), VertexId(ids[3 * t + 2])};
  }
  std::optional<Triangulation> mesh = Triangulation::from_triangles(triangles, static_cast<std::uint32_t>(n));
  if (!mesh) return Error{ErrorCode::invalid_mesh, "the triangles do not form a triangulation", {}};
  return *std::move(mesh);
}

void write_neighbors(const Triangulation& mesh, std::uint32_t* out) {
  for (std::uint32_t h = 0; h < mesh.halfedge_count(); ++h) {
    // Opposite to a corner is the edge that follows the one leaving it.
    const HalfedgeId across = mesh.twin(Triangulation::next(HalfedgeId(h)));
    out[h] = across.valid() ? Triangulation::face(across).index() : THALWEG_NONE;
  }
}

void write_pits(const Pits& pits, std::uint32_t* starts, std::uint32_t* vertices, std::uint8_t* boundary) {
  std::uint32_t end = 0;
  for (std::uint32_t i = 0; i < pits.size(); ++i) {
    starts[i] = end;
    boundary[i] = pits.boundary(i) ? 1 : 0;
    for (const VertexId v : pits[i]) vertices[end++] = v.index();
  }
  starts[pits.size()] = end;
}

std::size_t vertices_of(const Pits& pits) noexcept {
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < pits.size(); ++i) count += pits[i].size();
  return count;
}

}  // namespace
}  // namespace thalweg::bindings

using namespace thalweg;
using namespace thalweg::bindings;

thalweg_status thalweg_delaunay(const double* xy, size_t n, uint32_t threads, thalweg_mesh** mesh,
                                thalweg_error* error) {
  return guarded(error, [&]() -> std::optional<Error> {
    if (auto wrong = prepare(mesh, "the mesh")) return wrong;
    if (auto wrong = check_input(xy, n, "xy")) return wrong;
    if (auto wrong = check_count(n, "points")) return wrong;
    auto made = std::make_unique<thalweg_mesh>();
    Result<Triangulation> delaunay = thalweg::delaunay(points2(xy, n), {.threads = threads_for(threads)});
    if (!delaunay) return std::move(delaunay).error();
    made->triangulation = *std::move(delaunay);
    *mesh = made.release();
    return std::nullopt;
  });
}

thalweg_status thalweg_mesh_from_triangles(const uint32_t* triangles, size_t m, size_t n, thalweg_mesh** mesh,
                                           thalweg_error* error) {
  return guarded(error, [&]() -> std::optional<Error> {
    if (auto wrong = prepare(mesh, "the mesh")) return wrong;
    if (auto wrong = check_input(triangles, m, "triangles")) return wrong;
    if (auto wrong = check_count(n, "vertices")) return wrong;
    if (m >= VertexId::kInvalid / 3) return check_count(VertexId::kInvalid, "half-edges and more");
    auto made = std::make_unique<thalweg_mesh>();
    Result<Triangulation> linked = link({triangles, 3 * m}, n);
    if (!linked) return std::move(linked).error();
    made->triangulation = *std::move(linked);
    *mesh = made.release();
    return std::nullopt;
  });
}

size_t thalweg_mesh_vertex_count(const thalweg_mesh* mesh) {
  return is_handle(mesh) ? mesh->triangulation.vertex_count() : 0;
}

size_t thalweg_mesh_triangle_count(const thalweg_mesh* mesh) {
  return is_handle(mesh) ? mesh->triangulation.face_count() : 0;
}

thalweg_status thalweg_mesh_triangles(const thalweg_mesh* mesh, uint32_t* triangles, size_t capacity,
                                      thalweg_error* error) {
  return guarded(error, [&]() -> std::optional<Error> {
    if (auto wrong = check_handle(mesh, "mesh")) return wrong;
    const std::span<const std::uint32_t> origins = mesh->triangulation.origins();
    if (auto wrong = check_room(triangles, capacity, origins.size(), "triangles")) return wrong;
    std::ranges::copy(origins, triangles);
    return std::nullopt;
  });
}

thalweg_status thalweg_mesh_neighbors(const thalweg_mesh* mesh, uint32_t* neighbors, size_t capacity,
                                      thalweg_error* error) {
  return guarded(error, [&]() -> std::optional<Error> {
    if (auto wrong = check_handle(mesh, "mesh")) return wrong;
    const Triangulation& t = mesh->triangulation;
    if (auto wrong = check_room(neighbors, capacity, t.halfedge_count(), "neighbors")) return wrong;
    write_neighbors(t, neighbors);
    return std::nullopt;
  });
}

void thalweg_mesh_free(thalweg_mesh* mesh) {
  if (is_handle(mesh) && !mesh->borrowed) free_handle(mesh);
}

thalweg_status thalweg_mesh_pits(const thalweg_mesh* mesh, const double* z, size_t n, thalweg_pits** pits,
                                 thalweg_error* error) {
  return guarded(error, [&]() -> std::optional<Error> {
    if (auto wrong = prepare(pits, "the pits")) return wrong;
    if (auto wrong = check_handle(mesh, "mesh")) return wrong;
    if (n != mesh->triangulation.vertex_count()) {
      return usage(std::to_string(n) + " elevations for " +
                   std::to_string(mesh->triangulation.vertex_count()) + " vertices");
    }
    if (auto wrong = check_input(z, n, "z")) return wrong;
    if (auto wrong = check_finite(z, n, 1, "elevation")) return wrong;
    auto made = std::make_unique<thalweg_pits>();
    made->pits = find_pits(mesh->triangulation, {z, n});
    *pits = made.release();
    return std::nullopt;
  });
}

thalweg_pit_count thalweg_pits_count(const thalweg_pits* pits) {
  if (!is_handle(pits)) return {};
  const PitCount count = pits->pits.count();
  return {count.total, count.interior, count.boundary};
}

size_t thalweg_pits_vertex_count(const thalweg_pits* pits) {
  return is_handle(pits) ? vertices_of(pits->pits) : 0;
}

thalweg_status thalweg_pits_get(const thalweg_pits* pits, uint32_t* starts, size_t starts_capacity,
                                uint32_t* vertices, size_t vertices_capacity, uint8_t* boundary,
                                size_t boundary_capacity, thalweg_error* error) {
  return guarded(error, [&]() -> std::optional<Error> {
    if (auto wrong = check_handle(pits, "pits")) return wrong;
    const Pits& all = pits->pits;
    if (auto wrong = check_room(starts, starts_capacity, std::size_t{all.size()} + 1, "starts")) return wrong;
    if (auto wrong = check_room(vertices, vertices_capacity, vertices_of(all), "vertices")) return wrong;
    if (auto wrong = check_room(boundary, boundary_capacity, all.size(), "boundary")) return wrong;
    write_pits(all, starts, vertices, boundary);
    return std::nullopt;
  });
}

void thalweg_pits_free(thalweg_pits* pits) {
  free_handle(pits);
}
