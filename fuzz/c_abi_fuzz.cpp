/// The C ABI with hostile points, options and capacities: a status that the header knows, a message if and
/// only if it failed, nothing written past a capacity, and results that `thalweg_validate` accepts. The first
/// four bytes are method, order, policy and counter, sense or nonsense.
#include <cstring>
#include <vector>

#include "fuzz_input.hpp"
#include "support/brute.hpp"
#include "thalweg/thalweg.h"

namespace {

using thalweg::Point2;
using Numbers = std::vector<double>;

constexpr std::uint32_t kMark = 0xabababab;

struct Call {
  thalweg_error error{};
  std::vector<Point2> places;

  /// The status, after looking at what came with it.
  thalweg_status operator()(thalweg_status status) const {
    const bool known = status == THALWEG_OK || status == THALWEG_USAGE || status == THALWEG_BAD_INPUT ||
                       status == THALWEG_VERIFICATION;
    fuzz::check(known, "the status is one of those that can be", places);
    fuzz::check(error.status == status, "the error tells the status", places);
    fuzz::check(std::memchr(error.message, 0, sizeof error.message) != nullptr, "the message ends", places);
    fuzz::check((status == THALWEG_OK) == (error.message[0] == 0), "a message, if it failed", places);
    for (std::uint32_t i = 0; i < std::min<std::uint32_t>(error.row_count, THALWEG_ERROR_ROWS); ++i) {
      fuzz::check(error.rows[i] < places.size(), "rows to blame exist", places);
    }
    return status;
  }
};

/// The triangles, after asking for them with too little room.
std::vector<std::uint32_t> triangles_of(Call& call, const thalweg_mesh* mesh) {
  std::vector<std::uint32_t> out(3 * thalweg_mesh_triangle_count(mesh) + 1, kMark);
  const std::size_t size = out.size() - 1;
  const auto short_status = thalweg_mesh_triangles(mesh, out.data(), size - 1, &call.error);
  fuzz::check(call(short_status) == THALWEG_USAGE, "too little room is refused", call.places);
  const auto status = thalweg_mesh_triangles(mesh, out.data(), size, &call.error);
  fuzz::check(call(status) == THALWEG_OK && out.back() == kMark, "just enough room is enough", call.places);
  out.pop_back();
  return out;
}

void check_mesh(Call& call, const Numbers& xy, const thalweg_mesh* mesh, bool distinct) {
  const std::size_t n = xy.size() / 2;
  fuzz::check(thalweg_mesh_vertex_count(mesh) == n, "a vertex a point", call.places);
  const std::vector<std::uint32_t> triangles = triangles_of(call, mesh);
  thalweg_mesh* again = nullptr;
  const auto made =
      thalweg_mesh_from_triangles(triangles.data(), triangles.size() / 3, n, &again, &call.error);
  fuzz::check(call(made) == THALWEG_OK, "what was given out can be handed in", call.places);
  thalweg_mesh_free(again);
  thalweg_faults* faults = nullptr;
  const auto valid =
      thalweg_validate(xy.data(), n, triangles.data(), triangles.size() / 3, &faults, &call.error);
  fuzz::check((call(valid) == THALWEG_OK) == distinct, "a triangulation of all points", call.places);
  thalweg_faults_free(faults);
}

void check_build(Call& call, const Numbers& xyz, const Numbers& xy, const thalweg_build_options& options,
                 bool legal, bool distinct) {
  thalweg_terrain* terrain = nullptr;
  const auto status = thalweg_build(xyz.data(), xyz.size() / 3, &options, &terrain, &call.error);
  fuzz::check((call(status) == THALWEG_OK) == (terrain != nullptr), "a terrain, if it was built",
              call.places);
  const bool sensible = options.method >= 0 && options.method <= THALWEG_METHOD_EXACT &&
                        options.duplicates >= 0 && options.duplicates <= THALWEG_DUPLICATES_ERROR &&
                        options.counter >= 0 && options.counter <= THALWEG_COUNTER_VORONOI;
  const bool refused = options.duplicates == THALWEG_DUPLICATES_ERROR && !distinct;
  fuzz::check((terrain != nullptr) == (sensible && legal && !refused), "built exactly if it makes sense",
              call.places);
  if (terrain == nullptr) return;
  check_mesh(call, xy, thalweg_terrain_mesh(terrain), distinct);
  thalweg_summary summary{};
  summary.struct_size = sizeof summary;
  fuzz::check(call(thalweg_terrain_summary(terrain, &summary, &call.error)) == THALWEG_OK, "a summary",
              call.places);
  fuzz::check(summary.max_order <= options.order && summary.lower_bound <= summary.pits.total &&
                  summary.pits.total <= summary.delaunay_pits.total,
              "the summary keeps the laws", call.places);
  std::vector<std::uint32_t> orders(summary.triangle_count + std::size_t{1}, kMark);
  fuzz::check(
      call(thalweg_terrain_orders(terrain, orders.data(), orders.size() - 1, &call.error)) == THALWEG_OK &&
          orders.back() == kMark,
      "an order a triangle", call.places);
  thalweg_terrain_free(terrain);
}

void check_voronoi(Call& call, const Numbers& xy, std::uint32_t k) {
  thalweg_voronoi* voronoi = nullptr;
  const std::size_t n = xy.size() / 2;
  const auto status = thalweg_voronoi_new(xy.data(), n, k, 1, &voronoi, &call.error);
  fuzz::check((call(status) == THALWEG_OK) == (voronoi != nullptr), "a diagram, if it was made", call.places);
  if (voronoi == nullptr) return;
  std::vector<std::uint32_t> nearest(n * k + 1, kMark);
  const auto found = thalweg_voronoi_nearest(voronoi, xy.data(), n, 1, nearest.data(), n * k, &call.error);
  fuzz::check(call(found) == THALWEG_OK && nearest.back() == kMark, "k for each place", call.places);
  for (std::size_t i = 0; i < n; ++i) {
    fuzz::check(call.places[nearest[i * k]] == call.places[i], "nearest to a site is the site", call.places);
  }
  thalweg_voronoi_free(voronoi);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Input input(data, size);
  thalweg_build_options options;
  thalweg_build_options_init(&options, sizeof options);
  options.method = input.byte() % 6;
  options.order = input.byte() % 8;
  options.duplicates = input.byte() % 7;
  options.counter = input.byte() % 3;
  options.threads = 1;
  options.keep_trail = 1;
  const std::vector<thalweg::Point3> points = fuzz::take_terrain(input, 16);
  Call call;
  call.error.struct_size = sizeof call.error;
  Numbers xy, xyz;
  bool finite = true;
  for (const thalweg::Point3& p : points) {
    xy.insert(xy.end(), {p.x, p.y});
    xyz.insert(xyz.end(), {p.x, p.y, p.z});
    call.places.push_back({p.x, p.y});
    finite = finite && std::isfinite(p.z);
  }
  const bool places_finite = fuzz::all_finite(call.places);
  const support::Rows rows = places_finite ? support::distinct_rows(call.places) : support::Rows();
  const bool distinct = rows.size() == points.size();
  const bool legal = places_finite && !support::all_collinear(call.places, rows);
  thalweg_mesh* mesh = nullptr;
  const auto status = thalweg_delaunay(xy.data(), points.size(), 1, &mesh, &call.error);
  fuzz::check((call(status) == THALWEG_OK) == legal, "triangulated exactly if it can be", call.places);
  if (mesh != nullptr) check_mesh(call, xy, mesh, distinct);
  thalweg_mesh_free(mesh);
  check_build(call, xyz, xy, options, legal && finite, distinct);
  check_voronoi(call, xy, options.order);
  return 0;
}
