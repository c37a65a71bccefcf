/// Predicates, meshes, pits, orders, pairs and Voronoi diagrams through the C ABI.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"

static const double kSquare[] = {0, 0, 1, 0, 1, 1, 0, 1};

static void predicates_are_exact(void) {
  thalweg_error e = fresh_error();
  int sign = 7;
  const double a[] = {0, 0}, b[] = {1, 0}, c[] = {0, 1}, d[] = {1, 1}, tiny[] = {0, 5e-324};
  CHECK_STATUS(THALWEG_OK, thalweg_orient2d(a, b, c, &sign, &e), e);
  CHECK(sign == 1);
  CHECK_STATUS(THALWEG_OK, thalweg_orient2d(a, b, tiny, &sign, NULL), e);
  CHECK(sign == 1);
  CHECK_STATUS(THALWEG_OK, thalweg_orient2d(a, a, c, &sign, &e), e);
  CHECK(sign == 0);
  CHECK_STATUS(THALWEG_OK, thalweg_incircle(a, b, c, d, &sign, &e), e);
  CHECK(sign == 0);
  CHECK_STATUS(THALWEG_OK, thalweg_incircle(a, c, b, tiny, &sign, &e), e);
  CHECK(sign == -1);  // inside, but seen from the other side
  CHECK_STATUS(THALWEG_OK, thalweg_compare_distance(a, tiny, b, &sign, &e), e);
  CHECK(sign == -1);
}

static void delaunay_of_a_square(void) {
  thalweg_error e = fresh_error();
  thalweg_mesh* mesh;
  CHECK_STATUS(THALWEG_OK, thalweg_delaunay(kSquare, 4, 1, &mesh, &e), e);
  CHECK(thalweg_mesh_vertex_count(mesh) == 4 && thalweg_mesh_triangle_count(mesh) == 2);
  uint32_t triangles[6], neighbors[6], hull = 0;
  CHECK_STATUS(THALWEG_OK, thalweg_mesh_triangles(mesh, triangles, 6, &e), e);
  CHECK_STATUS(THALWEG_OK, thalweg_mesh_neighbors(mesh, neighbors, 6, &e), e);
  for (int i = 0; i < 6; ++i) hull += neighbors[i] == THALWEG_NONE;
  CHECK(hull == 4);
  thalweg_mesh* again;
  CHECK_STATUS(THALWEG_OK, thalweg_mesh_from_triangles(triangles, 2, 4, &again, &e), e);
  uint32_t same[6];
  CHECK_STATUS(THALWEG_OK, thalweg_mesh_triangles(again, same, 6, &e), e);
  CHECK(memcmp(triangles, same, sizeof same) == 0);
  thalweg_mesh_free(mesh);
  thalweg_mesh_free(again);
}

static void pits_of_a_lake(void) {
  thalweg_error e = fresh_error();
  // A lake of two vertices amid a rim; the far corner is lower and a pit of its own.
  const double xy[] = {0, 0, 4, 0, 4, 4, 0, 4, 1.5, 2, 2.5, 2};
  const double z[] = {5, 5, 0, 5, 1, 1};
  thalweg_mesh* mesh;
  CHECK_STATUS(THALWEG_OK, thalweg_delaunay(xy, 6, 1, &mesh, &e), e);
  thalweg_pits* pits;
  CHECK_STATUS(THALWEG_OK, thalweg_mesh_pits(mesh, z, 6, &pits, &e), e);
  const thalweg_pit_count count = thalweg_pits_count(pits);
  CHECK(count.total == 1 && count.boundary == 1);  // the lake drains over the edge to the corner
  thalweg_pits_free(pits);
  const double walled[] = {5, 5, 5, 5, 1, 1};
  CHECK_STATUS(THALWEG_OK, thalweg_mesh_pits(mesh, walled, 6, &pits, &e), e);
  uint32_t starts[2], vertices[2];
  uint8_t boundary[1];
  CHECK(thalweg_pits_vertex_count(pits) == 2);
  CHECK_STATUS(THALWEG_OK, thalweg_pits_get(pits, starts, 2, vertices, 2, boundary, 1, &e), e);
  CHECK(starts[0] == 0 && starts[1] == 2 && vertices[0] == 4 && vertices[1] == 5 && boundary[0] == 0);
  thalweg_pits_free(pits);
  thalweg_mesh_free(mesh);
}

static void every_fault_is_named(void) {
  thalweg_error e = fresh_error();
  const uint32_t good[] = {0, 1, 2, 0, 2, 3}, hole[] = {0, 1, 2}, out[] = {0, 1, 2, 0, 2, 9};
  const uint32_t clockwise[] = {0, 2, 1, 0, 2, 3};
  thalweg_faults* faults;
  CHECK_STATUS(THALWEG_OK, thalweg_validate(kSquare, 4, good, 2, &faults, &e), e);
  CHECK(faults != NULL && thalweg_faults_count(faults) == 0 && thalweg_faults_kind(faults, 0) == -1);
  thalweg_faults_free(faults);
  CHECK_STATUS(THALWEG_VERIFICATION, thalweg_validate(kSquare, 4, out, 2, &faults, &e), e);
  CHECK(thalweg_faults_kind(faults, 0) == THALWEG_FAULT_INDEX_OUT_OF_RANGE);
  CHECK(thalweg_faults_occurrences(faults, 0) == 1 && thalweg_faults_example(faults, 0, 0) != NULL);
  CHECK(thalweg_faults_example(faults, 0, 99) == NULL && thalweg_faults_example(faults, 99, 0) == NULL);
  CHECK(e.code == THALWEG_ERROR_INVALID_MESH && strstr(e.message, "index out of range") != NULL);
  thalweg_faults_free(faults);
  CHECK_STATUS(THALWEG_VERIFICATION, thalweg_validate(kSquare, 4, hole, 1, NULL, &e), e);
  CHECK_STATUS(THALWEG_VERIFICATION, thalweg_validate(kSquare, 4, clockwise, 2, NULL, &e), e);
  CHECK_STATUS(THALWEG_VERIFICATION, thalweg_validate(kSquare, 4, NULL, 0, NULL, &e), e);
  // An empty mesh of nothing is whatever the library says, but no crash.
  thalweg_validate(NULL, 0, NULL, 0, &faults, &e);
  thalweg_faults_free(faults);
  for (int32_t kind = -1; kind <= THALWEG_FAULT_HOLE + 1; ++kind) CHECK(thalweg_fault_name(kind)[0] != '\0');
}

static void orders_count_sites_not_rows(void) {
  thalweg_error e = fresh_error();
  // Two rows at the middle, and every corner twice: one site each.
  const double xy[] = {0, 0, 4, 0, 0, 4, 1, 1, 1, 1, 0, 0, 4, 0, 0, 4};
  thalweg_sites* sites;
  CHECK_STATUS(THALWEG_OK, thalweg_sites_new(xy, 8, 1, &sites, &e), e);
  const uint32_t triangles[] = {0, 1, 2, 5, 6, 7, 3, 1, 2, 4, 6, 7};
  uint32_t orders[4];
  CHECK_STATUS(THALWEG_OK, thalweg_sites_triangle_orders(sites, triangles, 4, 9, 1, orders, 4, &e), e);
  CHECK(orders[0] == 1 && orders[1] == 1 && orders[2] == 0 && orders[3] == 0);
  CHECK_STATUS(THALWEG_OK, thalweg_sites_triangle_orders(sites, triangles, 4, 0, 1, orders, 4, &e), e);
  CHECK(orders[0] == 1);
  uint32_t order;
  CHECK_STATUS(THALWEG_OK, thalweg_sites_useful_order(sites, 0, 4, 9, &order, &e), e);
  CHECK(order == 0);
  CHECK_STATUS(THALWEG_USAGE, thalweg_sites_useful_order(sites, 3, 4, 9, &order, &e), e);
  CHECK_STATUS(THALWEG_USAGE, thalweg_sites_useful_order(sites, 0, 8, 9, &order, &e), e);
  const uint32_t clockwise[] = {0, 1, 2, 0, 2, 1, 0, 5, 1}, beyond[] = {0, 1, 8};
  CHECK_STATUS(THALWEG_VERIFICATION, thalweg_sites_triangle_orders(sites, clockwise, 3, 9, 1, orders, 4, &e),
               e);
  CHECK(e.row_count == 2 && e.rows[0] == 1 && e.rows[1] == 2);
  CHECK_STATUS(THALWEG_USAGE, thalweg_sites_triangle_orders(sites, beyond, 1, 9, 1, orders, 4, &e), e);
  thalweg_sites_free(sites);
}

static void useful_pairs_agree_with_single_questions(void) {
  enum { n = 40, k = 2 };
  thalweg_error e = fresh_error();
  double xy[2 * n];
  fill_points(xy, n, 2, 9, 21);
  thalweg_sites* sites;
  CHECK_STATUS(THALWEG_OK, thalweg_sites_new(xy, n, 1, &sites, &e), e);
  thalweg_pairs* pairs;
  CHECK_STATUS(THALWEG_OK, thalweg_sites_useful_pairs(sites, k, 2, &pairs, &e), e);
  const size_t count = thalweg_pairs_count(pairs);
  thalweg_pair* all = malloc(count * sizeof *all);
  CHECK_STATUS(THALWEG_OK, thalweg_pairs_get(pairs, all, count, &e), e);
  size_t next = 0;
  for (uint32_t u = 0; u < n; ++u) {
    for (uint32_t v = u + 1; v < n; ++v) {
      uint32_t order;
      if (thalweg_sites_useful_order(sites, u, v, k, &order, &e) != THALWEG_OK) continue;  // same place
      int first = 1;  // of equal points the first stands for all
      for (uint32_t w = 0; w < v; ++w) {
        if (w < u && memcmp(xy + 2 * w, xy + 2 * u, 16) == 0) first = 0;
        if (memcmp(xy + 2 * w, xy + 2 * v, 16) == 0) first = 0;
      }
      if (!first || order > k) continue;
      CHECK(next < count && all[next].u == u && all[next].v == v && all[next].order == order);
      ++next;
    }
  }
  CHECK(next == count);
  free(all);
  thalweg_pairs_free(pairs);
  thalweg_sites_free(sites);
}

static void voronoi_finds_the_nearest(void) {
  enum { n = 60, k = 4, q = 50 };
  thalweg_error e = fresh_error();
  double xy[2 * n], places[2 * q];
  fill_points(xy, n, 2, 1000, 31);
  fill_points(places, q, 2, 1200, 32);
  thalweg_voronoi* voronoi;
  CHECK_STATUS(THALWEG_OK, thalweg_voronoi_new(xy, n, k, 0, &voronoi, &e), e);
  CHECK(thalweg_voronoi_order(voronoi) == k && thalweg_voronoi_site_count(voronoi) == n);
  CHECK(thalweg_voronoi_cell_count(voronoi) > n && thalweg_voronoi_memory_bytes(voronoi) > 0);
  uint32_t nearest[q * k], cells[q], sites[k];
  CHECK_STATUS(THALWEG_OK, thalweg_voronoi_nearest(voronoi, places, q, 2, nearest, q * k, &e), e);
  CHECK_STATUS(THALWEG_OK, thalweg_voronoi_locate(voronoi, places, q, 1, cells, q, &e), e);
  for (size_t i = 0; i < q; ++i) {
    const double* place = places + 2 * i;
    CHECK_STATUS(THALWEG_OK, thalweg_voronoi_cell_sites(voronoi, cells[i], sites, k, &e), e);
    const double* last = xy + 2 * nearest[i * k + k - 1];
    for (uint32_t s = 0; s < n; ++s) {
      int listed = 0, in_cell = 0, sign;
      for (size_t j = 0; j < k; ++j) {
        listed |= nearest[i * k + j] == s;
        in_cell |= sites[j] == s;
      }
      CHECK(listed == in_cell);
      CHECK_STATUS(THALWEG_OK, thalweg_compare_distance(place, xy + 2 * s, last, &sign, &e), e);
      CHECK(listed ? sign <= 0 : sign >= 0);
    }
  }
  const double box[] = {0, 0, 1200, 1200};
  size_t corners;
  const thalweg_status asked = thalweg_voronoi_polygon(voronoi, cells[0], box, NULL, 0, &corners, &e);
  CHECK(corners >= 3 && asked == THALWEG_USAGE);
  double* polygon = malloc(2 * corners * sizeof *polygon);
  CHECK_STATUS(THALWEG_OK,
               thalweg_voronoi_polygon(voronoi, cells[0], box, polygon, 2 * corners, &corners, &e), e);
  for (size_t i = 0; i < 2 * corners; ++i) CHECK(polygon[i] >= 0 && polygon[i] <= 1200);
  free(polygon);
  thalweg_voronoi_free(voronoi);
}

static void one_point_has_a_diagram(void) {
  thalweg_error e = fresh_error();
  thalweg_voronoi* voronoi;
  const double place[] = {3, 4};
  CHECK_STATUS(THALWEG_OK, thalweg_voronoi_new(place, 1, 1, 1, &voronoi, &e), e);
  uint32_t nearest = 9;
  CHECK_STATUS(THALWEG_OK, thalweg_voronoi_nearest(voronoi, place, 1, 1, &nearest, 1, &e), e);
  CHECK(nearest == 0);
  const double box[] = {0, 0, 1, 1};
  double polygon[8];
  size_t corners;
  CHECK_STATUS(THALWEG_OK, thalweg_voronoi_polygon(voronoi, 0, box, polygon, 8, &corners, &e), e);
  CHECK(corners == 4);
  thalweg_voronoi_free(voronoi);
}

int main(void) {
  predicates_are_exact();
  delaunay_of_a_square();
  pits_of_a_lake();
  every_fault_is_named();
  orders_count_sites_not_rows();
  useful_pairs_agree_with_single_questions();
  voronoi_finds_the_nearest();
  one_point_has_a_diagram();
  return check_result();
}
