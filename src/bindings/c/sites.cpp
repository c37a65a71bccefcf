/// Orders of triangles and pairs, for C.
#include <algorithm>
#include <memory>
#include <numeric>

#include "bindings/c/arrays.hpp"
#include "bindings/c/handles.hpp"
#include "kernel/parallel.hpp"
#include "thalweg/delaunay.hpp"
#include "thalweg/predicates.hpp"

namespace thalweg::bindings {
namespace {

/// For each row the first at its place, which is the one that the Delaunay triangulation takes.
std::vector<std::uint32_t> first_at_place(std::span<const Point2> xy) {
  std::vector<std::uint32_t> rows(xy.size());
  std::iota(rows.begin(), rows.end(), 0u);
  std::ranges::sort(rows, [&](std::uint32_t a, std::uint32_t b) {
    if (xy[a].x != xy[b].x) return xy[a].x < xy[b].x;
    if (xy[a].y != xy[b].y) return xy[a].y < xy[b].y;
    return a < b;
  });
  std::vector<std::uint32_t> first(xy.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const bool same = i > 0 && xy[rows[i]] == xy[rows[i - 1]];
    first[rows[i]] = same ? first[rows[i - 1]] : rows[i];
  }
  return first;
}

bool any_isolated(const Triangulation& mesh) noexcept {
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.isolated(VertexId(v))) return true;
  }
  return false;
}

VertexId site_of(const thalweg_sites& sites, std::uint32_t row) noexcept {
  return VertexId(sites.site_of.empty() ? row : sites.site_of[row]);
}

Triangle triangle_of(const thalweg_sites& sites, const std::uint32_t* ids) noexcept {
  return {site_of(sites, ids[0]), site_of(sites, ids[1]), site_of(sites, ids[2])};
}

/// Ids in range and every triangle counter-clockwise: what counting requires.
std::optional<Error> check_triangles(const thalweg_sites& sites, const std::uint32_t* ids, std::size_t m) {
  for (std::size_t i = 0; i < 3 * m; ++i) {
    if (ids[i] >= sites.xy.size()) {
      return usage("triangle " + std::to_string(i / 3) + " names point " + std::to_string(ids[i]) +
                   " of only " + std::to_string(sites.xy.size()));
    }
  }
  Error error{ErrorCode::invalid_mesh, "", {}};
  for (std::size_t t = 0; t < m && error.rows.size() < THALWEG_ERROR_ROWS; ++t) {
    const std::uint32_t* corner = ids + 3 * t;
    if (orient2d(sites.xy[corner[0]], sites.xy[corner[1]], sites.xy[corner[2]]) > 0) continue;
    error.rows.push_back(static_cast<std::uint32_t>(t));
  }
  if (error.rows.empty()) return std::nullopt;
  error.message = "triangle " + std::to_string(error.rows[0]) + " is not counter-clockwise";
  return error;
}

/// Requires: checked triangles.
void count_orders(const thalweg_sites& sites, const std::uint32_t* ids, std::size_t m, unsigned limit,
                  unsigned threads, std::uint32_t* orders) {
  constexpr std::size_t kChunk = 4096;
  detail::parallel_chunks(m, kChunk, threads, [&] {
    return [&, counter = CircleCounter(*sites.graph)](std::size_t begin, std::size_t end) mutable {
      for (std::size_t t = begin; t < end; ++t) {
        const Triangle corners = triangle_of(sites, ids + 3 * t);
        orders[t] = counter.count_in_circle(corners[0], corners[1], corners[2], limit);
      }
    };
  });
}

/// No count is larger than the number of points, and limit + 1 has to be a number.
unsigned effective_limit(const thalweg_sites& sites, std::uint32_t limit) noexcept {
  return static_cast<unsigned>(std::min<std::size_t>(limit, sites.xy.size()));
}

}  // namespace
}  // namespace thalweg::bindings

using namespace thalweg;
using namespace thalweg::bindings;

thalweg_status thalweg_sites_new(const double* xy, size_t n, uint32_t threads, thalweg_sites** sites,
                                 thalweg_error* error) {
  return guarded(error, [&]() -> std::optional<Error> {
    if (auto wrong = prepare(sites, "the sites")) return wrong;
    if (auto wrong = check_input(xy, n, "xy")) return wrong;
    if (auto wrong = check_count(n, "points")) return wrong;
    auto made = std::make_unique<thalweg_sites>();
    Result<Triangulation> delaunay = thalweg::delaunay(points2(xy, n), {.threads = threads_for(threads)});
    if (!delaunay) return std::move(delaunay).error();
    made->xy.assign(points2(xy, n).begin(), points2(xy, n).end());
    made->mesh.triangulation = *std::move(delaunay);
    made->mesh.borrowed = true;
    if (any_isolated(made->mesh.triangulation)) made->site_of = first_at_place(made->xy);
    made->graph.emplace(made->xy, made->mesh.triangulation);
    *sites = made.release();
    return std::nullopt;
  });
}

const thalweg_mesh* thalweg_sites_mesh(const thalweg_sites* sites) {
  return is_handle(sites) ? &sites->mesh : nullptr;
}

thalweg_status thalweg_sites_triangle_orders(const thalweg_sites* sites, const uint32_t* triangles, size_t m,
                                             uint32_t limit, uint32_t threads, uint32_t* orders,
                                             size_t capacity, thalweg_error* error) {
  return guarded(error, [&]() -> std::optional<Error> {
    if (auto wrong = check_handle(sites, "sites")) return wrong;
    if (auto wrong = check_count(m, "triangles")) return wrong;
    if (auto wrong = check_input(triangles, m, "triangles")) return wrong;
    if (auto wrong = check_room(orders, capacity, m, "orders")) return wrong;
    if (auto wrong = check_triangles(*sites, triangles, m)) return wrong;
    count_orders(*sites, triangles, m, effective_limit(*sites, limit), threads_for(threads), orders);
    return std::nullopt;
  });
}

thalweg_status thalweg_sites_useful_order(const thalweg_sites* sites, uint32_t u, uint32_t v, uint32_t limit,
                                          uint32_t* order, thalweg_error* error) {
  return guarded(error, [&]() -> std::optional<Error> {
    if (auto wrong = check_handle(sites, "sites")) return wrong;
    if (order == nullptr) return usage("the place for the order is null");
    if (u >= sites->xy.size() || v >= sites->xy.size()) return usage("u or v is no point");
    const VertexId from = site_of(*sites, u), to = site_of(*sites, v);
    if (from == to) return usage("u and v are at the same place");
    CircleCounter counter(*sites->graph);
    const std::optional<unsigned> least =
        useful_order(*sites->graph, counter, from, to, effective_limit(*sites, limit));
    *order = least ? *least : THALWEG_NONE;
    return std::nullopt;
  });
}

thalweg_status thalweg_sites_useful_pairs(const thalweg_sites* sites, uint32_t k, uint32_t threads,
                                          thalweg_pairs** pairs, thalweg_error* error) {
  return guarded(error, [&]() -> std::optional<Error> {
    if (auto wrong = prepare(pairs, "the pairs")) return wrong;
    if (auto wrong = check_handle(sites, "sites")) return wrong;
    auto made = std::make_unique<thalweg_pairs>();
    made->pairs = useful_pairs(*sites->graph, effective_limit(*sites, k), threads_for(threads));
    *pairs = made.release();
    return std::nullopt;
  });
}

size_t thalweg_pairs_count(const thalweg_pairs* pairs) {
  return is_handle(pairs) ? pairs->pairs.size() : 0;
}

thalweg_status thalweg_pairs_get(const thalweg_pairs* pairs, thalweg_pair* out, size_t capacity,
                                 thalweg_error* error) {
  return guarded(error, [&]() -> std::optional<Error> {
    if (auto wrong = check_handle(pairs, "pairs")) return wrong;
    if (auto wrong = check_room(out, capacity, pairs->pairs.size(), "out")) return wrong;
    std::ranges::transform(pairs->pairs, out, [](const UsefulPair& pair) {
      return thalweg_pair{pair.u.index(), pair.v.index(), pair.order};
    });
    return std::nullopt;
  });
}

void thalweg_pairs_free(thalweg_pairs* pairs) {
  free_handle(pairs);
}

void thalweg_sites_free(thalweg_sites* sites) {
  free_handle(sites);
}
