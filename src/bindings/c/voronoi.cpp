/// The order-k Voronoi diagram for C.
#include <algorithm>
#include <memory>

#include "bindings/c/arrays.hpp"
#include "bindings/c/handles.hpp"
#include "kernel/parallel.hpp"

namespace thalweg::bindings {
namespace {

/// Calls answer(place, number) for each of q places after checking what both kinds of queries are given;
/// they write `width` elements a place.
template <class Answer>
std::optional<Error> for_each_place(const thalweg_voronoi* voronoi, const double* places, std::size_t q,
                                    std::uint32_t threads, const std::uint32_t* out, std::size_t capacity,
                                    std::size_t width, Answer&& answer) {
  if (auto wrong = check_input(places, q, "places")) return wrong;
  if (auto wrong = check_count(q, "places")) return wrong;
  if (auto wrong = check_room(out, capacity, q * width, "the output")) return wrong;
  if (auto wrong = check_finite(places, q, 2, "place")) return wrong;
  constexpr std::size_t kChunk = 1024;
  const std::span<const Point2> all = points2(places, q);
  detail::parallel_chunks(q, kChunk, threads_for(threads), [&] {
    return [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) answer(voronoi->diagram, all[i], i);
    };
  });
  return std::nullopt;
}

std::optional<Error> check_cell(const thalweg_voronoi* voronoi, std::uint32_t cell) {
  if (auto wrong = check_handle(voronoi, "voronoi")) return wrong;
  if (cell < voronoi->diagram.cell_count()) return std::nullopt;
  return usage("there are only " + std::to_string(voronoi->diagram.cell_count()) + " cells");
}

}  // namespace
}  // namespace thalweg::bindings

using namespace thalweg;
using namespace thalweg::bindings;

thalweg_status thalweg_voronoi_new(const double* xy, size_t n, uint32_t k, uint32_t threads,
                                   thalweg_voronoi** voronoi, thalweg_error* error) {
  return guarded(error, [&]() -> std::optional<Error> {
    if (auto wrong = prepare(voronoi, "the diagram")) return wrong;
    if (auto wrong = check_input(xy, n, "xy")) return wrong;
    if (auto wrong = check_count(n, "points")) return wrong;
    Result<OrderKVoronoi> diagram = order_k_voronoi(points2(xy, n), k, {.threads = threads_for(threads)});
    if (!diagram) return std::move(diagram).error();
    *voronoi = new thalweg_voronoi{thalweg_voronoi::kTag, *std::move(diagram)};
    return std::nullopt;
  });
}

uint32_t thalweg_voronoi_order(const thalweg_voronoi* voronoi) {
  return is_handle(voronoi) ? voronoi->diagram.order() : 0;
}

size_t thalweg_voronoi_site_count(const thalweg_voronoi* voronoi) {
  return is_handle(voronoi) ? voronoi->diagram.site_count() : 0;
}

size_t thalweg_voronoi_cell_count(const thalweg_voronoi* voronoi) {
  return is_handle(voronoi) ? voronoi->diagram.cell_count() : 0;
}

size_t thalweg_voronoi_memory_bytes(const thalweg_voronoi* voronoi) {
  return is_handle(voronoi) ? voronoi->diagram.memory_bytes() : 0;
}

thalweg_status thalweg_voronoi_nearest(const thalweg_voronoi* voronoi, const double* places, size_t q,
                                       uint32_t threads, uint32_t* nearest, size_t capacity,
                                       thalweg_error* error) {
  return guarded(error, [&]() -> std::optional<Error> {
    if (auto wrong = check_handle(voronoi, "voronoi")) return wrong;
    const std::size_t k = voronoi->diagram.order();
    const auto answer = [&](const OrderKVoronoi& diagram, Point2 place, std::size_t i) {
      std::ranges::transform(diagram.nearest(place), nearest + i * k, &VertexId::index);
    };
    return for_each_place(voronoi, places, q, threads, nearest, capacity, k, answer);
  });
}

thalweg_status thalweg_voronoi_locate(const thalweg_voronoi* voronoi, const double* places, size_t q,
                                      uint32_t threads, uint32_t* cells, size_t capacity,
                                      thalweg_error* error) {
  return guarded(error, [&]() -> std::optional<Error> {
    if (auto wrong = check_handle(voronoi, "voronoi")) return wrong;
    const auto answer = [&](const OrderKVoronoi& diagram, Point2 place, std::size_t i) {
      cells[i] = diagram.locate(place).index();
    };
    return for_each_place(voronoi, places, q, threads, cells, capacity, 1, answer);
  });
}

thalweg_status thalweg_voronoi_cell_sites(const thalweg_voronoi* voronoi, uint32_t cell, uint32_t* sites,
                                          size_t capacity, thalweg_error* error) {
  return guarded(error, [&]() -> std::optional<Error> {
    if (auto wrong = check_cell(voronoi, cell)) return wrong;
    if (auto wrong = check_room(sites, capacity, voronoi->diagram.order(), "sites")) return wrong;
    std::ranges::transform(voronoi->diagram.sites(CellId(cell)), sites, &VertexId::index);
    return std::nullopt;
  });
}

thalweg_status thalweg_voronoi_polygon(const thalweg_voronoi* voronoi, uint32_t cell, const double* box,
                                       double* polygon, size_t capacity, size_t* corners,
                                       thalweg_error* error) {
  return guarded(error, [&]() -> std::optional<Error> {
    if (corners == nullptr) return usage("the place for the number of corners is null");
    *corners = 0;
    if (auto wrong = check_cell(voronoi, cell)) return wrong;
    if (auto wrong = check_input(box, 4, "box")) return wrong;
    if (auto wrong = check_finite(box, 1, 4, "box")) return wrong;
    if (!(box[0] < box[2] && box[1] < box[3])) return usage("the box is low x, low y, high x, high y");
    const std::vector<Point2> shape =
        voronoi->diagram.polygon(CellId(cell), {{box[0], box[1]}, {box[2], box[3]}});
    *corners = shape.size();
    if (auto wrong = check_room(polygon, capacity, 2 * shape.size(), "polygon")) return wrong;
    for (std::size_t i = 0; i < shape.size(); ++i) {
      polygon[2 * i] = shape[i].x;
      polygon[2 * i + 1] = shape[i].y;
    }
    return std::nullopt;
  });
}

void thalweg_voronoi_free(thalweg_voronoi* voronoi) {
  free_handle(voronoi);
}
