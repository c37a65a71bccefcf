/// Memory that runs out at every possible moment is a status, and leaks nothing (the sanitizers would say
/// so).
#include "check.h"
#include "support/failing_new.h"

enum { kPoints = 60 };

static double xyz[3 * kPoints], xy[2 * kPoints];
static uint32_t threads;
static thalweg_error e;

static thalweg_status build(int32_t method, int32_t counter) {
  thalweg_build_options options;
  thalweg_build_options_init(&options, sizeof options);
  options.method = method;
  options.counter = counter;
  options.order = 3;
  options.threads = threads;
  options.keep_trail = 1;
  thalweg_terrain* terrain;
  const thalweg_status status = thalweg_build(xyz, kPoints, &options, &terrain, &e);
  CHECK((terrain != NULL) == (status == THALWEG_OK));
  thalweg_terrain_free(terrain);
  return status;
}

static thalweg_status flip(void) {
  return build(THALWEG_METHOD_FLIP, THALWEG_COUNTER_CRAWL);
}
static thalweg_status hull(void) {
  return build(THALWEG_METHOD_HULL, THALWEG_COUNTER_VORONOI);
}
static thalweg_status exact(void) {
  return build(THALWEG_METHOD_EXACT, THALWEG_COUNTER_CRAWL);
}

static thalweg_status sweep(void) {
  thalweg_sweep_row rows[3];
  return thalweg_sweep(xyz, kPoints, 1, 3, NULL, rows, 3, &e);
}

static thalweg_status pits(void) {
  thalweg_mesh* mesh;
  thalweg_pits* found = NULL;
  thalweg_status status = thalweg_delaunay(xy, kPoints, threads, &mesh, &e);
  const double z[kPoints] = {0};
  if (status == THALWEG_OK) status = thalweg_mesh_pits(mesh, z, kPoints, &found, &e);
  thalweg_pits_free(found);
  thalweg_mesh_free(mesh);
  return status;
}

static thalweg_status pairs(void) {
  thalweg_sites* sites;
  thalweg_pairs* found = NULL;
  uint32_t order;
  thalweg_status status = thalweg_sites_new(xy, kPoints, threads, &sites, &e);
  if (status == THALWEG_OK) status = thalweg_sites_useful_pairs(sites, 3, threads, &found, &e);
  if (status == THALWEG_OK) status = thalweg_sites_useful_order(sites, 0, 1, 3, &order, &e);
  thalweg_pairs_free(found);
  thalweg_sites_free(sites);
  return status;
}

static thalweg_status voronoi(void) {
  thalweg_voronoi* diagram;
  uint32_t nearest[3 * kPoints];
  thalweg_status status = thalweg_voronoi_new(xy, kPoints, 3, threads, &diagram, &e);
  if (status == THALWEG_OK) {
    status = thalweg_voronoi_nearest(diagram, xy, kPoints, threads, nearest, 3 * kPoints, &e);
  }
  thalweg_voronoi_free(diagram);
  return status;
}

static thalweg_status validate(void) {
  const uint32_t triangles[] = {0, 1, 2, 3, 4, 5, 0, 3, 6};
  thalweg_faults* faults;
  const thalweg_status status = thalweg_validate(xy, kPoints, triangles, 3, &faults, &e);
  CHECK((faults != NULL) == (status == THALWEG_VERIFICATION));
  thalweg_faults_free(faults);
  return status == THALWEG_VERIFICATION ? THALWEG_OK : status;
}

static void fails_at_every_allocation(const char* name, thalweg_status (*run)(void), long step) {
  long after = 0;
  for (;; after += step) {
    fail_allocations(after);
    const thalweg_status status = run();
    fail_allocations(-1);
    if (status == THALWEG_OK) break;
    if (status != THALWEG_OUT_OF_MEMORY) {
      ++check_failures;
      fprintf(stderr, "%s, allocation %ld: %s (%s)\n", name, after, thalweg_status_name(status), e.message);
      break;
    }
  }
  CHECK(after > 2);
}

int main(void) {
  fill_points(xyz, kPoints, 3, 1000, 51);
  fill_points(xy, kPoints, 2, 1000, 52);
  e = fresh_error();
  for (threads = 1; threads <= 2; ++threads) {
    fails_at_every_allocation("flip", flip, 1);
    fails_at_every_allocation("hull", hull, 3);
    fails_at_every_allocation("exact", exact, 1);
    fails_at_every_allocation("sweep", sweep, 1);
    fails_at_every_allocation("pits", pits, 1);
    fails_at_every_allocation("pairs", pairs, 1);
    fails_at_every_allocation("voronoi", voronoi, 1);
    fails_at_every_allocation("validate", validate, 1);
  }
  fail_allocations(0);
  CHECK(thalweg_cancel_new() == NULL);
  fail_allocations(-1);
  return check_result();
}
