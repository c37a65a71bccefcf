/// The main job and its report through the C ABI.
#include <stdlib.h>
#include <string.h>

#include "check.h"

enum { kPoints = 400 };

typedef struct {
  double xyz[3 * kPoints];
  thalweg_error error;
  thalweg_build_options options;
} Fixture;

static Fixture set_up(uint32_t range, uint64_t seed) {
  Fixture f;
  fill_points(f.xyz, kPoints, 3, range, seed);
  f.error = fresh_error();
  CHECK(thalweg_build_options_init(&f.options, sizeof f.options) == THALWEG_OK);
  return f;
}

static thalweg_summary summary_of(const thalweg_terrain* terrain, thalweg_error* error) {
  thalweg_summary summary;
  memset(&summary, 0xff, sizeof summary);
  summary.struct_size = sizeof summary;
  CHECK_STATUS(THALWEG_OK, thalweg_terrain_summary(terrain, &summary, error), *error);
  return summary;
}

static void take_xy(const double* xyz, size_t n, double* xy) {
  for (size_t i = 0; i < n; ++i) memcpy(xy + 2 * i, xyz + 3 * i, 2 * sizeof(double));
}

/// The mesh is sound, its orders are right, its neighbours mutual, and its pits those of the summary.
static void check_terrain(Fixture* f, const thalweg_terrain* terrain) {
  static double xy[2 * kPoints], z[kPoints];
  static uint32_t triangles[6 * kPoints], neighbors[6 * kPoints], orders[2 * kPoints], counted[2 * kPoints];
  thalweg_error* e = &f->error;
  const thalweg_summary s = summary_of(terrain, e);
  const thalweg_mesh* mesh = thalweg_terrain_mesh(terrain);
  CHECK(thalweg_mesh_vertex_count(mesh) == kPoints && s.vertex_count == kPoints);
  CHECK(thalweg_mesh_triangle_count(mesh) == s.triangle_count);
  const size_t m = s.triangle_count;
  CHECK_STATUS(THALWEG_OK, thalweg_mesh_triangles(mesh, triangles, 6 * kPoints, e), *e);
  CHECK_STATUS(THALWEG_OK, thalweg_mesh_neighbors(mesh, neighbors, 6 * kPoints, e), *e);
  CHECK_STATUS(THALWEG_OK, thalweg_terrain_orders(terrain, orders, 2 * kPoints, e), *e);
  for (size_t i = 0; i < 3 * m; ++i) {
    if (neighbors[i] == THALWEG_NONE) continue;
    const uint32_t* back = neighbors + 3 * (size_t)neighbors[i];
    CHECK(back[0] == i / 3 || back[1] == i / 3 || back[2] == i / 3);
    for (int j = 0; j < 3; ++j) CHECK(triangles[3 * (size_t)neighbors[i] + (size_t)j] != triangles[i]);
  }

  take_xy(f->xyz, kPoints, xy);
  for (size_t i = 0; i < kPoints; ++i) z[i] = f->xyz[3 * i + 2];
  thalweg_sites* sites;
  CHECK_STATUS(THALWEG_OK, thalweg_sites_new(xy, kPoints, 1, &sites, e), *e);
  CHECK_STATUS(THALWEG_OK,
               thalweg_sites_triangle_orders(sites, triangles, m, UINT32_MAX, 2, counted, 2 * kPoints, e),
               *e);
  uint32_t most = 0;
  for (size_t t = 0; t < m; ++t) most = counted[t] > most ? counted[t] : most;
  CHECK(memcmp(orders, counted, m * sizeof *orders) == 0);
  CHECK(s.max_order == most && most <= f->options.order);
  thalweg_sites_free(sites);

  if (s.merged_count == 0) {
    CHECK_STATUS(THALWEG_OK, thalweg_validate(xy, kPoints, triangles, m, NULL, e), *e);
  }
  if (s.mean_count == 0) {
    thalweg_pits* pits;
    CHECK_STATUS(THALWEG_OK, thalweg_mesh_pits(mesh, z, kPoints, &pits, e), *e);
    const thalweg_pit_count count = thalweg_pits_count(pits);
    CHECK(count.total == s.pits.total && count.interior == s.pits.interior);
    thalweg_pits_free(pits);
  }
  CHECK(s.pits.total == s.pits.interior + s.pits.boundary);
  CHECK(s.remaining_count == s.pits.total);
  CHECK(s.lower_bound <= s.pits.total && s.pits.total <= s.delaunay_pits.total);
  CHECK(s.certified == (s.lower_bound == s.pits.total ? 1u : 0u));
}

static void every_method_gives_a_sound_terrain(void) {
  uint32_t pits[5];
  for (int32_t method = THALWEG_METHOD_DELAUNAY; method <= THALWEG_METHOD_EXACT; ++method) {
    Fixture f = set_up(100000, 7);
    f.options.method = method;
    f.options.order = method == THALWEG_METHOD_DELAUNAY ? 0 : 5;
    f.options.counter = method % 2;
    thalweg_terrain* terrain;
    CHECK_STATUS(THALWEG_OK, thalweg_build(f.xyz, kPoints, &f.options, &terrain, &f.error), f.error);
    check_terrain(&f, terrain);
    pits[method] = summary_of(terrain, &f.error).pits.total;
    thalweg_terrain_free(terrain);
  }
  CHECK(pits[THALWEG_METHOD_FLIP] < pits[THALWEG_METHOD_DELAUNAY]);
  CHECK(pits[THALWEG_METHOD_BEST] <= pits[THALWEG_METHOD_FLIP]);
  CHECK(pits[THALWEG_METHOD_BEST] <= pits[THALWEG_METHOD_HULL]);
  CHECK(pits[THALWEG_METHOD_EXACT] <= pits[THALWEG_METHOD_BEST]);
}

static void null_options_are_the_defaults(void) {
  Fixture f = set_up(100000, 8);
  thalweg_terrain *plain, *chosen;
  CHECK_STATUS(THALWEG_OK, thalweg_build(f.xyz, kPoints, NULL, &plain, NULL), f.error);
  CHECK_STATUS(THALWEG_OK, thalweg_build(f.xyz, kPoints, &f.options, &chosen, &f.error), f.error);
  CHECK(f.options.order == 8 && f.options.method == THALWEG_METHOD_BEST);
  const thalweg_summary a = summary_of(plain, &f.error), b = summary_of(chosen, &f.error);
  CHECK(memcmp(&a.pits, &b.pits, sizeof a.pits) == 0 && a.flips == b.flips && a.insertions == b.insertions);
  thalweg_terrain_free(plain);
  thalweg_terrain_free(chosen);
}

/// Twenty by twenty places for 400 points: most places are taken twice, many circles have four points.
static void duplicates_follow_the_policy(void) {
  for (int32_t policy = THALWEG_DUPLICATES_LOWEST; policy <= THALWEG_DUPLICATES_LAST; ++policy) {
    Fixture f = set_up(19, 9);
    f.options.duplicates = policy;
    thalweg_terrain* terrain;
    CHECK_STATUS(THALWEG_OK, thalweg_build(f.xyz, kPoints, &f.options, &terrain, &f.error), f.error);
    check_terrain(&f, terrain);
    const thalweg_summary s = summary_of(terrain, &f.error);
    CHECK(s.merged_count > 0 && s.site_count + s.merged_count == kPoints);
    CHECK((s.mean_count > 0) == (policy == THALWEG_DUPLICATES_MEAN));
    static thalweg_merged_row merged[kPoints];
    CHECK_STATUS(THALWEG_OK, thalweg_terrain_merged(terrain, merged, kPoints, &f.error), f.error);
    for (size_t i = 0; i < s.merged_count; ++i) {
      const double *gone = f.xyz + 3 * merged[i].row, *kept = f.xyz + 3 * merged[i].kept;
      CHECK(gone[0] == kept[0] && gone[1] == kept[1]);
      if (policy == THALWEG_DUPLICATES_LOWEST) CHECK(kept[2] <= gone[2]);
      if (policy == THALWEG_DUPLICATES_HIGHEST) CHECK(kept[2] >= gone[2]);
      if (policy == THALWEG_DUPLICATES_FIRST) CHECK(merged[i].kept < merged[i].row);
      if (policy == THALWEG_DUPLICATES_LAST) CHECK(merged[i].kept > merged[i].row);
    }
    static thalweg_mean_elevation means[kPoints];
    CHECK_STATUS(THALWEG_OK, thalweg_terrain_means(terrain, means, kPoints, &f.error), f.error);
    for (size_t i = 0; i < s.mean_count; ++i) CHECK(means[i].z >= 0 && means[i].z <= 19);
    thalweg_terrain_free(terrain);
  }
  Fixture f = set_up(19, 9);
  f.options.duplicates = THALWEG_DUPLICATES_ERROR;
  thalweg_terrain* terrain;
  CHECK_STATUS(THALWEG_BAD_INPUT, thalweg_build(f.xyz, kPoints, &f.options, &terrain, &f.error), f.error);
  CHECK(terrain == NULL && f.error.code == THALWEG_ERROR_DUPLICATE_POINTS && f.error.row_count >= 2);
  CHECK(f.error.status == THALWEG_BAD_INPUT && strstr(f.error.message, "same x and y") != NULL);
}

static void lists_of_the_report_are_consistent(void) {
  Fixture f = set_up(100000, 10);
  f.options.keep_trail = 1;
  f.options.method = THALWEG_METHOD_FLIP;
  thalweg_terrain* terrain;
  CHECK_STATUS(THALWEG_OK, thalweg_build(f.xyz, kPoints, &f.options, &terrain, &f.error), f.error);
  const thalweg_summary s = summary_of(terrain, &f.error);
  CHECK(s.trail_count > 0 && s.trail_count == s.flips && s.removed_count > 0);
  thalweg_trail_step* steps = malloc(s.trail_count * sizeof *steps);
  CHECK_STATUS(THALWEG_OK, thalweg_terrain_trail(terrain, steps, s.trail_count, &f.error), f.error);
  uint32_t removed = 0;
  for (size_t i = 0; i < s.trail_count; ++i) {
    CHECK(steps[i].kind == THALWEG_STEP_FLIP && steps[i].order <= f.options.order);
    CHECK(steps[i].u < kPoints && steps[i].v < kPoints && steps[i].old_u < kPoints);
    removed += steps[i].pit != THALWEG_NONE;
  }
  CHECK(removed == s.delaunay_pits.total - s.pits.total);
  free(steps);
  static thalweg_removed_pit gone[kPoints];
  static thalweg_remaining_pit left[kPoints];
  CHECK_STATUS(THALWEG_OK, thalweg_terrain_removed(terrain, gone, kPoints, &f.error), f.error);
  CHECK_STATUS(THALWEG_OK, thalweg_terrain_remaining(terrain, left, kPoints, &f.error), f.error);
  for (size_t i = 0; i < s.removed_count; ++i) CHECK(gone[i].vertex < kPoints && gone[i].vertices >= 1);
  for (size_t i = 0; i < s.remaining_count; ++i) {
    CHECK(left[i].vertex < kPoints && left[i].boundary <= 1);
    CHECK(left[i].reason >= THALWEG_REASON_UNREMOVABLE && left[i].reason <= THALWEG_REASON_KEPT);
  }
  thalweg_terrain_free(terrain);
}

static void sweep_agrees_with_single_runs(void) {
  Fixture f = set_up(100000, 11);
  thalweg_sweep_row rows[5];
  CHECK_STATUS(THALWEG_OK, thalweg_sweep(f.xyz, kPoints, 2, 6, &f.options, rows, 5, &f.error), f.error);
  for (size_t i = 0; i < 5; ++i) {
    CHECK(rows[i].order == i + 2);
    f.options.order = rows[i].order;
    thalweg_terrain* terrain;
    CHECK_STATUS(THALWEG_OK, thalweg_build(f.xyz, kPoints, &f.options, &terrain, &f.error), f.error);
    const thalweg_summary s = summary_of(terrain, &f.error);
    CHECK(s.pits.total == rows[i].best && s.lower_bound == rows[i].lower_bound);
    CHECK(s.certified == rows[i].certified);
    thalweg_terrain_free(terrain);
  }
  CHECK_STATUS(THALWEG_USAGE, thalweg_sweep(f.xyz, kPoints, 6, 2, NULL, rows, 5, &f.error), f.error);
  CHECK_STATUS(THALWEG_USAGE, thalweg_sweep(f.xyz, kPoints, 2, 7, NULL, rows, 5, &f.error), f.error);
  CHECK_STATUS(THALWEG_USAGE, thalweg_sweep(f.xyz, kPoints, 0, UINT32_MAX, NULL, rows, SIZE_MAX, &f.error),
               f.error);
}

typedef struct {
  int calls;
  int stop_at;
} Progress;

static int watch(void* data, const char* stage, double fraction) {
  Progress* progress = data;
  CHECK(stage != NULL && stage[0] != '\0' && fraction >= 0 && fraction <= 1);
  return ++progress->calls == progress->stop_at;
}

/// Stops at the first callback, the second, ... until a run ends by itself.
static void cancelled_at_every_callback(void) {
  for (int32_t method = THALWEG_METHOD_DELAUNAY; method <= THALWEG_METHOD_EXACT; ++method) {
    for (int with_request = 0; with_request < 2; ++with_request) {
      int stop_at = 1;
      for (;; ++stop_at) {
        Fixture f = set_up(100000, 12);
        Progress progress = {0, stop_at};
        f.options.method = method;
        f.options.progress = watch;
        f.options.progress_data = &progress;
        if (with_request) f.options.cancel = thalweg_cancel_new();
        thalweg_terrain* terrain;
        const thalweg_status status = thalweg_build(f.xyz, kPoints, &f.options, &terrain, &f.error);
        CHECK(thalweg_cancel_requested(f.options.cancel) == (with_request && progress.calls >= stop_at));
        thalweg_cancel_free(f.options.cancel);
        if (status == THALWEG_OK) {
          CHECK(progress.calls < stop_at);
          thalweg_terrain_free(terrain);
          break;
        }
        CHECK(status == THALWEG_CANCELLED && terrain == NULL && f.error.code == THALWEG_ERROR_CANCELLED);
        CHECK(progress.calls >= stop_at);
      }
      CHECK(stop_at > 4);
    }
  }
}

static void sweep_is_cancelled_at_every_callback(void) {
  for (int stop_at = 1;; ++stop_at) {
    Fixture f = set_up(100000, 13);
    Progress progress = {0, stop_at};
    f.options.progress = watch;
    f.options.progress_data = &progress;
    thalweg_sweep_row rows[4];
    const thalweg_status status = thalweg_sweep(f.xyz, kPoints, 0, 3, &f.options, rows, 4, &f.error);
    if (status == THALWEG_OK) {
      CHECK(stop_at > 4);
      break;
    }
    CHECK(status == THALWEG_CANCELLED);
  }
}

static void a_request_made_before_stops_and_can_be_taken_back(void) {
  Fixture f = set_up(100000, 14);
  f.options.cancel = thalweg_cancel_new();
  CHECK(thalweg_cancel_requested(f.options.cancel) == 0);
  thalweg_cancel_request(f.options.cancel);
  thalweg_terrain* terrain;
  CHECK_STATUS(THALWEG_CANCELLED, thalweg_build(f.xyz, kPoints, &f.options, &terrain, &f.error), f.error);
  thalweg_cancel_reset(f.options.cancel);
  CHECK_STATUS(THALWEG_OK, thalweg_build(f.xyz, kPoints, &f.options, &terrain, &f.error), f.error);
  CHECK(f.error.status == THALWEG_OK && f.error.message[0] == '\0' && f.error.row_count == 0);
  thalweg_terrain_free(terrain);
  thalweg_cancel_free(f.options.cancel);
}

int main(void) {
  every_method_gives_a_sound_terrain();
  null_options_are_the_defaults();
  duplicates_follow_the_policy();
  lists_of_the_report_are_consistent();
  sweep_agrees_with_single_runs();
  cancelled_at_every_callback();
  sweep_is_cancelled_at_every_callback();
  a_request_made_before_stops_and_can_be_taken_back();
  return check_result();
}
