/// Whatever a caller can get wrong is answered with a status.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"

static const double kXyz[] = {0, 0, 1, 9, 0, 2, 9, 9, 3, 0, 9, 4, 4, 5, 0};
static const double kXy[] = {0, 0, 9, 0, 9, 9, 0, 9, 4, 5};

static thalweg_error e;

/// One call of each function with null or nothing wherever it can be given.
static void null_everywhere(void) {
  thalweg_mesh* mesh;
  thalweg_pits* pits;
  thalweg_terrain* terrain;
  thalweg_sites* sites;
  thalweg_pairs* pairs;
  thalweg_voronoi* voronoi;
  thalweg_faults* faults;
  thalweg_summary summary = {.struct_size = sizeof summary};
  int sign;
  CHECK_STATUS(THALWEG_USAGE, thalweg_orient2d(NULL, kXy, kXy, &sign, &e), e);
  CHECK_STATUS(THALWEG_USAGE, thalweg_orient2d(kXy, kXy, kXy, NULL, &e), e);
  CHECK_STATUS(THALWEG_USAGE, thalweg_incircle(kXy, kXy, kXy, NULL, &sign, &e), e);
  CHECK_STATUS(THALWEG_USAGE, thalweg_compare_distance(kXy, NULL, kXy, &sign, &e), e);
  CHECK_STATUS(THALWEG_USAGE, thalweg_delaunay(NULL, 5, 1, &mesh, &e), e);
  CHECK_STATUS(THALWEG_USAGE, thalweg_delaunay(kXy, 5, 1, NULL, &e), e);
  CHECK_STATUS(THALWEG_USAGE, thalweg_mesh_from_triangles(NULL, 1, 3, &mesh, &e), e);
  CHECK_STATUS(THALWEG_USAGE, thalweg_mesh_triangles(NULL, NULL, 0, &e), e);
  CHECK_STATUS(THALWEG_USAGE, thalweg_mesh_neighbors(NULL, NULL, 0, &e), e);
  CHECK_STATUS(THALWEG_USAGE, thalweg_mesh_pits(NULL, NULL, 0, &pits, &e), e);
  CHECK_STATUS(THALWEG_USAGE, thalweg_pits_get(NULL, NULL, 0, NULL, 0, NULL, 0, &e), e);
  CHECK_STATUS(THALWEG_USAGE, thalweg_build(NULL, 5, NULL, &terrain, &e), e);
  CHECK_STATUS(THALWEG_USAGE, thalweg_build(kXyz, 5, NULL, NULL, &e), e);
  CHECK_STATUS(THALWEG_USAGE, thalweg_terrain_summary(NULL, &summary, &e), e);
  CHECK_STATUS(THALWEG_USAGE, thalweg_terrain_orders(NULL, NULL, 0, &e), e);
  CHECK_STATUS(THALWEG_USAGE, thalweg_terrain_remaining(NULL, NULL, 0, &e), e);
  CHECK_STATUS(THALWEG_USAGE, thalweg_terrain_removed(NULL, NULL, 0, &e), e);
  CHECK_STATUS(THALWEG_USAGE, thalweg_terrain_merged(NULL, NULL, 0, &e), e);
  CHECK_STATUS(THALWEG_USAGE, thalweg_terrain_means(NULL, NULL, 0, &e), e);
  CHECK_STATUS(THALWEG_USAGE, thalweg_terrain_trail(NULL, NULL, 0, &e), e);
  CHECK_STATUS(THALWEG_USAGE, thalweg_sweep(kXyz, 5, 0, 1, NULL, NULL, 2, &e), e);
  CHECK_STATUS(THALWEG_USAGE, thalweg_validate(NULL, 5, NULL, 0, &faults, &e), e);
  CHECK(faults == NULL);
  CHECK_STATUS(THALWEG_USAGE, thalweg_validate(kXy, 5, NULL, 1, NULL, &e), e);
  CHECK_STATUS(THALWEG_USAGE, thalweg_sites_new(NULL, 5, 1, &sites, &e), e);
  CHECK_STATUS(THALWEG_USAGE, thalweg_sites_new(kXy, 5, 1, NULL, &e), e);
  CHECK_STATUS(THALWEG_USAGE, thalweg_sites_triangle_orders(NULL, NULL, 0, 0, 1, NULL, 0, &e), e);
  CHECK_STATUS(THALWEG_USAGE, thalweg_sites_useful_order(NULL, 0, 1, 0, NULL, &e), e);
  CHECK_STATUS(THALWEG_USAGE, thalweg_sites_useful_pairs(NULL, 1, 1, &pairs, &e), e);
  CHECK_STATUS(THALWEG_USAGE, thalweg_pairs_get(NULL, NULL, 0, &e), e);
  CHECK_STATUS(THALWEG_USAGE, thalweg_voronoi_new(NULL, 5, 1, 1, &voronoi, &e), e);
  CHECK_STATUS(THALWEG_USAGE, thalweg_voronoi_new(kXy, 5, 1, 1, NULL, &e), e);
  CHECK_STATUS(THALWEG_USAGE, thalweg_voronoi_nearest(NULL, kXy, 5, 1, NULL, 0, &e), e);
  CHECK_STATUS(THALWEG_USAGE, thalweg_voronoi_locate(NULL, kXy, 5, 1, NULL, 0, &e), e);
  CHECK_STATUS(THALWEG_USAGE, thalweg_voronoi_cell_sites(NULL, 0, NULL, 0, &e), e);
  CHECK_STATUS(THALWEG_USAGE, thalweg_voronoi_polygon(NULL, 0, NULL, NULL, 0, NULL, &e), e);
  CHECK(thalweg_mesh_vertex_count(NULL) == 0 && thalweg_mesh_triangle_count(NULL) == 0);
  CHECK(thalweg_pits_count(NULL).total == 0 && thalweg_pits_vertex_count(NULL) == 0);
  CHECK(thalweg_terrain_mesh(NULL) == NULL && thalweg_sites_mesh(NULL) == NULL);
  CHECK(thalweg_faults_count(NULL) == 0 && thalweg_faults_kind(NULL, 0) == -1);
  CHECK(thalweg_faults_occurrences(NULL, 0) == 0 && thalweg_faults_example(NULL, 0, 0) == NULL);
  CHECK(thalweg_pairs_count(NULL) == 0 && thalweg_voronoi_order(NULL) == 0);
  CHECK(thalweg_voronoi_site_count(NULL) == 0 && thalweg_voronoi_cell_count(NULL) == 0);
  CHECK(thalweg_voronoi_memory_bytes(NULL) == 0 && thalweg_cancel_requested(NULL) == 0);
  thalweg_cancel_request(NULL);
  thalweg_cancel_reset(NULL);
  thalweg_cancel_free(NULL);
  thalweg_mesh_free(NULL);
  thalweg_pits_free(NULL);
  thalweg_terrain_free(NULL);
  thalweg_faults_free(NULL);
  thalweg_sites_free(NULL);
  thalweg_pairs_free(NULL);
  thalweg_voronoi_free(NULL);
}

/// Empty, one, two, all the same, all on a line, NaN, infinities, more than ids can number.
static void bad_points(void) {
  const double nan_xyz[] = {0, 0, 1, 1, 0, NAN, 0, 1, 2, 5, INFINITY, 1};
  const double line[] = {0, 0, 0, 1, 1, 0, 2, 2, 0, 3, 3, 0};
  double same[60];
  for (size_t i = 0; i < 60; ++i) same[i] = 3;
  thalweg_terrain* terrain;
  CHECK_STATUS(THALWEG_BAD_INPUT, thalweg_build(NULL, 0, NULL, &terrain, &e), e);
  CHECK(terrain == NULL && e.code == THALWEG_ERROR_TOO_FEW_POINTS);
  CHECK_STATUS(THALWEG_BAD_INPUT, thalweg_build(kXyz, 1, NULL, &terrain, &e), e);
  CHECK_STATUS(THALWEG_BAD_INPUT, thalweg_build(kXyz, 2, NULL, &terrain, &e), e);
  CHECK_STATUS(THALWEG_BAD_INPUT, thalweg_build(same, 20, NULL, &terrain, &e), e);
  CHECK(e.code == THALWEG_ERROR_TOO_FEW_POINTS);
  CHECK_STATUS(THALWEG_BAD_INPUT, thalweg_build(line, 4, NULL, &terrain, &e), e);
  CHECK(e.code == THALWEG_ERROR_ALL_COLLINEAR);
  CHECK_STATUS(THALWEG_BAD_INPUT, thalweg_build(nan_xyz, 4, NULL, &terrain, &e), e);
  CHECK(e.code == THALWEG_ERROR_NOT_FINITE && e.row_count == 2 && e.rows[0] == 1 && e.rows[1] == 3);
  CHECK_STATUS(THALWEG_BAD_INPUT, thalweg_build(kXyz, SIZE_MAX / 32, NULL, &terrain, &e), e);
  CHECK(e.code == THALWEG_ERROR_TOO_MANY_POINTS);

  const double nan_xy[] = {0, 0, 1, NAN, 0, 1};
  const double line_xy[] = {0, 0, 1, 1, 2, 2};
  thalweg_mesh* mesh;
  thalweg_sites* sites;
  thalweg_voronoi* voronoi;
  CHECK_STATUS(THALWEG_BAD_INPUT, thalweg_delaunay(NULL, 0, 1, &mesh, &e), e);
  CHECK_STATUS(THALWEG_BAD_INPUT, thalweg_delaunay(nan_xy, 3, 1, &mesh, &e), e);
  CHECK(e.row_count == 1 && e.rows[0] == 1);
  CHECK_STATUS(THALWEG_BAD_INPUT, thalweg_delaunay(line_xy, 3, 1, &mesh, &e), e);
  CHECK_STATUS(THALWEG_BAD_INPUT, thalweg_delaunay(kXy, SIZE_MAX / 16, 1, &mesh, &e), e);
  CHECK_STATUS(THALWEG_BAD_INPUT, thalweg_sites_new(line_xy, 3, 1, &sites, &e), e);
  CHECK_STATUS(THALWEG_BAD_INPUT, thalweg_sites_new(NULL, 0, 1, &sites, &e), e);
  CHECK_STATUS(THALWEG_BAD_INPUT, thalweg_voronoi_new(nan_xy, 3, 1, 1, &voronoi, &e), e);
  CHECK_STATUS(THALWEG_BAD_INPUT, thalweg_voronoi_new(NULL, 0, 1, 1, &voronoi, &e), e);
  CHECK_STATUS(THALWEG_BAD_INPUT, thalweg_voronoi_new(kXy, 5, 6, 1, &voronoi, &e), e);
  CHECK_STATUS(THALWEG_USAGE, thalweg_voronoi_new(kXy, 5, 0, 1, &voronoi, &e), e);
  CHECK_STATUS(THALWEG_BAD_INPUT, thalweg_validate(nan_xy, 3, NULL, 0, NULL, &e), e);
  int sign;
  CHECK_STATUS(THALWEG_BAD_INPUT, thalweg_orient2d(kXy, kXy, nan_xy + 2, &sign, &e), e);
}

static void misaligned_arrays(void) {
  _Alignas(double) char bytes[12 * sizeof(double)] = {0};
  thalweg_mesh* mesh;
  CHECK_STATUS(THALWEG_USAGE, thalweg_delaunay((const double*)(const void*)(bytes + 1), 4, 1, &mesh, &e), e);
}

/// Sizes that are too small, were never set, or are of a newer header.
static void struct_sizes(void) {
  thalweg_terrain* terrain = NULL;
  thalweg_build_options options;
  CHECK(thalweg_build_options_init(NULL, sizeof options) == THALWEG_USAGE);
  CHECK(thalweg_build_options_init(&options, sizeof options - 1) == THALWEG_USAGE);
  CHECK(thalweg_build_options_init(&options, SIZE_MAX) == THALWEG_USAGE);
  CHECK(thalweg_build_options_init(&options, sizeof options) == THALWEG_OK);
  const size_t wrong[] = {0, 1, sizeof options - 1, SIZE_MAX};
  for (size_t i = 0; i < sizeof wrong / sizeof *wrong; ++i) {
    options.struct_size = wrong[i];
    CHECK_STATUS(THALWEG_USAGE, thalweg_build(kXyz, 5, &options, &terrain, &e), e);
    thalweg_error small;
    small.struct_size = wrong[i] == sizeof options - 1 ? sizeof small - 1 : wrong[i];
    small.message[0] = 'x';
    CHECK(thalweg_build(kXyz, 5, NULL, &terrain, &small) == THALWEG_USAGE && small.message[0] == 'x');
  }

  struct {
    thalweg_build_options known;
    uint64_t unknown[2];
  } newer;
  CHECK(thalweg_build_options_init(&newer.known, sizeof newer) == THALWEG_OK);
  CHECK(newer.known.struct_size == sizeof newer && newer.unknown[0] == 0 && newer.unknown[1] == 0);
  CHECK_STATUS(THALWEG_OK, thalweg_build(kXyz, 5, &newer.known, &terrain, &e), e);
  thalweg_terrain* none;
  newer.unknown[1] = 1;
  CHECK_STATUS(THALWEG_USAGE, thalweg_build(kXyz, 5, &newer.known, &none, &e), e);
  CHECK(strstr(e.message, "newer") != NULL);

  struct {
    thalweg_summary known;
    uint64_t unknown;
  } summary = {.known.struct_size = sizeof summary, .unknown = 5};
  CHECK_STATUS(THALWEG_OK, thalweg_terrain_summary(terrain, &summary.known, &e), e);
  CHECK(summary.unknown == 0 && summary.known.vertex_count == 5);
  summary.known.struct_size = sizeof summary.known - 8;
  CHECK_STATUS(THALWEG_USAGE, thalweg_terrain_summary(terrain, &summary.known, &e), e);
  CHECK_STATUS(THALWEG_USAGE, thalweg_terrain_summary(terrain, NULL, &e), e);
  thalweg_terrain_free(terrain);
}

static void option_values(void) {
  const struct {
    int32_t method, duplicates, counter;
    double time_limit;
  } wrong[] = {{-1, 0, 0, 0}, {5, 0, 0, 0},    {0, -1, 0, 0}, {0, 6, 0, 0},
               {0, 0, 2, 0},  {4, 0, 0, -1.0}, {4, 0, 0, NAN}};
  thalweg_terrain* terrain;
  thalweg_build_options options;
  for (size_t i = 0; i < sizeof wrong / sizeof *wrong; ++i) {
    CHECK(thalweg_build_options_init(&options, sizeof options) == THALWEG_OK);
    options.method = wrong[i].method;
    options.duplicates = wrong[i].duplicates;
    options.counter = wrong[i].counter;
    options.time_limit = wrong[i].time_limit;
    CHECK_STATUS(THALWEG_USAGE, thalweg_build(kXyz, 5, &options, &terrain, &e), e);
    CHECK(terrain == NULL && e.message[0] != '\0');
  }
  CHECK(thalweg_build_options_init(&options, sizeof options) == THALWEG_OK);
  options.order = UINT32_MAX;
  options.threads = UINT32_MAX;
  options.method = THALWEG_METHOD_EXACT;
  options.time_limit = INFINITY;
  CHECK_STATUS(THALWEG_OK, thalweg_build(kXyz, 5, &options, &terrain, &e), e);
  thalweg_terrain_free(terrain);
  thalweg_sites* sites;
  thalweg_pairs* pairs;
  CHECK_STATUS(THALWEG_OK, thalweg_sites_new(kXy, 5, UINT32_MAX, &sites, &e), e);
  CHECK_STATUS(THALWEG_OK, thalweg_sites_useful_pairs(sites, UINT32_MAX, UINT32_MAX, &pairs, &e), e);
  CHECK(thalweg_pairs_count(pairs) >= 8);
  thalweg_pairs_free(pairs);
  thalweg_sites_free(sites);
}

static void small_output_arrays(void) {
  thalweg_terrain* terrain;
  thalweg_sites* sites;
  thalweg_pits* pits;
  CHECK_STATUS(THALWEG_OK, thalweg_build(kXyz, 5, NULL, &terrain, &e), e);
  const thalweg_mesh* mesh = thalweg_terrain_mesh(terrain);
  uint32_t ids[12] = {77};
  CHECK_STATUS(THALWEG_USAGE, thalweg_mesh_triangles(mesh, ids, 11, &e), e);
  CHECK(ids[0] == 77 && strstr(e.message, "11") != NULL && strstr(e.message, "12") != NULL);
  CHECK_STATUS(THALWEG_USAGE, thalweg_mesh_neighbors(mesh, ids, 11, &e), e);
  CHECK_STATUS(THALWEG_USAGE, thalweg_mesh_triangles(mesh, NULL, 12, &e), e);
  CHECK_STATUS(THALWEG_USAGE, thalweg_terrain_orders(terrain, ids, 3, &e), e);
  CHECK_STATUS(THALWEG_USAGE, thalweg_terrain_remaining(terrain, NULL, 0, &e), e);
  CHECK_STATUS(THALWEG_OK, thalweg_terrain_trail(terrain, NULL, 0, &e), e);  // nothing is kept
  const double z[] = {1, 2, 3, 4, NAN};
  CHECK_STATUS(THALWEG_USAGE, thalweg_mesh_pits(mesh, z, 4, &pits, &e), e);
  CHECK_STATUS(THALWEG_BAD_INPUT, thalweg_mesh_pits(mesh, z, 5, &pits, &e), e);
  CHECK(pits == NULL && e.rows[0] == 4);
  CHECK_STATUS(THALWEG_OK, thalweg_sites_new(kXy, 5, 1, &sites, &e), e);
  const uint32_t triangle[] = {0, 1, 2};
  CHECK_STATUS(THALWEG_USAGE, thalweg_sites_triangle_orders(sites, triangle, 1, 1, 1, ids, 0, &e), e);
  CHECK_STATUS(THALWEG_OK, thalweg_sites_triangle_orders(sites, NULL, 0, 1, 1, NULL, 0, &e), e);
  thalweg_sites_free(sites);
  thalweg_terrain_free(terrain);
}

static void broken_meshes(void) {
  const uint32_t beyond[] = {0, 1, 3}, twice[] = {0, 1, 1}, edge[] = {0, 1, 2, 0, 1, 3};
  thalweg_mesh* mesh;
  CHECK_STATUS(THALWEG_VERIFICATION, thalweg_mesh_from_triangles(beyond, 1, 3, &mesh, &e), e);
  CHECK(mesh == NULL && e.code == THALWEG_ERROR_INVALID_MESH);
  CHECK_STATUS(THALWEG_VERIFICATION, thalweg_mesh_from_triangles(twice, 1, 3, &mesh, &e), e);
  CHECK_STATUS(THALWEG_VERIFICATION, thalweg_mesh_from_triangles(edge, 2, 4, &mesh, &e), e);
  CHECK_STATUS(THALWEG_BAD_INPUT, thalweg_mesh_from_triangles(beyond, 1, SIZE_MAX, &mesh, &e), e);
  CHECK_STATUS(THALWEG_BAD_INPUT, thalweg_mesh_from_triangles(beyond, SIZE_MAX / 16, 4, &mesh, &e), e);
  CHECK_STATUS(THALWEG_OK, thalweg_mesh_from_triangles(NULL, 0, 0, &mesh, &e), e);
  CHECK(thalweg_mesh_triangle_count(mesh) == 0);
  thalweg_pits* pits;
  CHECK_STATUS(THALWEG_OK, thalweg_mesh_pits(mesh, NULL, 0, &pits, &e), e);
  uint32_t starts = 9;
  CHECK_STATUS(THALWEG_OK, thalweg_pits_get(pits, &starts, 1, NULL, 0, NULL, 0, &e), e);
  CHECK(starts == 0);
  thalweg_pits_free(pits);
  thalweg_mesh_free(mesh);
}

/// Handles of another type, and meshes that are not the caller's to free.
static void wrong_handles(void) {
  thalweg_terrain* terrain;
  thalweg_sites* sites;
  thalweg_voronoi* voronoi;
  CHECK_STATUS(THALWEG_OK, thalweg_build(kXyz, 5, NULL, &terrain, &e), e);
  CHECK_STATUS(THALWEG_OK, thalweg_sites_new(kXy, 5, 1, &sites, &e), e);
  CHECK_STATUS(THALWEG_OK, thalweg_voronoi_new(kXy, 5, 2, 1, &voronoi, &e), e);
  thalweg_summary summary = {.struct_size = sizeof summary};
  CHECK_STATUS(THALWEG_USAGE,
               thalweg_terrain_summary((const thalweg_terrain*)(const void*)sites, &summary, &e), e);
  CHECK(strstr(e.message, "another type") != NULL);
  uint32_t ids[12];
  CHECK_STATUS(THALWEG_USAGE, thalweg_mesh_triangles((const thalweg_mesh*)(const void*)terrain, ids, 12, &e),
               e);
  CHECK(thalweg_voronoi_order((const thalweg_voronoi*)(const void*)terrain) == 0);
  thalweg_build_options options;
  CHECK(thalweg_build_options_init(&options, sizeof options) == THALWEG_OK);
  options.cancel = (thalweg_cancel*)(void*)sites;
  thalweg_terrain* other;
  CHECK_STATUS(THALWEG_USAGE, thalweg_build(kXyz, 5, &options, &other, &e), e);
  thalweg_pairs_free((thalweg_pairs*)(void*)terrain);
  thalweg_mesh_free((thalweg_mesh*)(void*)(uintptr_t)thalweg_terrain_mesh(terrain));
  thalweg_mesh_free((thalweg_mesh*)(void*)(uintptr_t)thalweg_sites_mesh(sites));
  CHECK(thalweg_mesh_triangle_count(thalweg_terrain_mesh(terrain)) == 4);
  CHECK_STATUS(THALWEG_USAGE, thalweg_voronoi_cell_sites(voronoi, UINT32_MAX, ids, 12, &e), e);
  const double empty_box[] = {1, 0, 0, 1}, nan_box[] = {0, 0, NAN, 1};
  size_t corners;
  CHECK_STATUS(THALWEG_USAGE, thalweg_voronoi_polygon(voronoi, 0, empty_box, NULL, 0, &corners, &e), e);
  CHECK_STATUS(THALWEG_BAD_INPUT, thalweg_voronoi_polygon(voronoi, 0, nan_box, NULL, 0, &corners, &e), e);
  const double nowhere[] = {1, 1, INFINITY, 0};
  CHECK_STATUS(THALWEG_BAD_INPUT, thalweg_voronoi_locate(voronoi, nowhere, 2, 1, ids, 2, &e), e);
  CHECK(e.row_count == 1 && e.rows[0] == 1);
  CHECK_STATUS(THALWEG_USAGE, thalweg_voronoi_nearest(voronoi, kXy, 5, 1, ids, 9, &e), e);
  thalweg_voronoi_free(voronoi);
  thalweg_sites_free(sites);
  thalweg_terrain_free(terrain);
}

static void names_of_everything(void) {
  CHECK(strcmp(thalweg_status_name(THALWEG_OK), "ok") == 0);
  CHECK(strcmp(thalweg_status_name(99), "unknown") == 0);
  CHECK(strcmp(thalweg_version(), THALWEG_EXPECTED_VERSION) == 0);
}

int main(void) {
  e = fresh_error();
  null_everywhere();
  bad_points();
  misaligned_arrays();
  struct_sizes();
  option_values();
  small_output_arrays();
  broken_meshes();
  wrong_handles();
  names_of_everything();
  return check_result();
}
