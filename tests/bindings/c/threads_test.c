/// Several threads at once: on handles of their own, on one handle together, and one that stops another.
#include <pthread.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"

enum { kPoints = 300, kThreads = 4, kOrder = 3 };

static double xyz[3 * kPoints], xy[2 * kPoints];
static const thalweg_sites* shared_sites;
static const thalweg_voronoi* shared_voronoi;
static const thalweg_terrain* shared_terrain;

typedef struct {
  int failed;
  uint32_t pits;
  uint32_t orders[2 * kPoints];
  uint32_t nearest[kPoints * kOrder];
} Answers;

/// Each thread notes failures for itself: check_failures is not shared among threads.
static void* work(void* data) {
  Answers* answers = data;
  thalweg_error e = fresh_error();
  thalweg_terrain* terrain;
  if (thalweg_build(xyz, kPoints, NULL, &terrain, &e) != THALWEG_OK) return answers->failed = 1, NULL;
  thalweg_summary summary = {.struct_size = sizeof summary};
  answers->failed |= thalweg_terrain_summary(terrain, &summary, &e);
  answers->pits = summary.pits.total;
  thalweg_terrain_free(terrain);

  static _Thread_local uint32_t triangles[6 * kPoints];
  const thalweg_mesh* mesh = thalweg_terrain_mesh(shared_terrain);
  answers->failed |= thalweg_mesh_triangles(mesh, triangles, 6 * kPoints, &e);
  answers->failed |= thalweg_sites_triangle_orders(shared_sites, triangles, thalweg_mesh_triangle_count(mesh),
                                                   99, 2, answers->orders, 2 * kPoints, &e);
  answers->failed |=
      thalweg_voronoi_nearest(shared_voronoi, xy, kPoints, 2, answers->nearest, kPoints * kOrder, &e);
  // A failure here leaves other threads' errors alone.
  answers->failed |= thalweg_voronoi_new(NULL, 0, 1, 1, NULL, &e) != THALWEG_USAGE;
  return NULL;
}

static void threads_share_handles(void) {
  thalweg_error e = fresh_error();
  thalweg_sites* sites;
  thalweg_voronoi* voronoi;
  thalweg_terrain* terrain;
  CHECK_STATUS(THALWEG_OK, thalweg_sites_new(xy, kPoints, 1, &sites, &e), e);
  CHECK_STATUS(THALWEG_OK, thalweg_voronoi_new(xy, kPoints, kOrder, 1, &voronoi, &e), e);
  CHECK_STATUS(THALWEG_OK, thalweg_build(xyz, kPoints, NULL, &terrain, &e), e);
  shared_sites = sites;
  shared_voronoi = voronoi;
  shared_terrain = terrain;
  static Answers answers[kThreads];
  pthread_t threads[kThreads];
  for (int i = 0; i < kThreads; ++i) CHECK(pthread_create(&threads[i], NULL, work, &answers[i]) == 0);
  for (int i = 0; i < kThreads; ++i) CHECK(pthread_join(threads[i], NULL) == 0);
  for (int i = 0; i < kThreads; ++i) {
    CHECK(answers[i].failed == 0);
    CHECK(memcmp(&answers[i], &answers[0], sizeof answers[0]) == 0);
  }
  thalweg_sites_free(sites);
  thalweg_voronoi_free(voronoi);
  thalweg_terrain_free(terrain);
}

static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static pthread_cond_t changed = PTHREAD_COND_INITIALIZER;
static int begun = 0, requested = 0;

/// Lets the other thread go on, and waits until it has made its request.
static int wait_for_request(void* data, const char* stage, double fraction) {
  (void)data, (void)stage, (void)fraction;
  pthread_mutex_lock(&lock);
  begun = 1;
  pthread_cond_broadcast(&changed);
  while (!requested) pthread_cond_wait(&changed, &lock);
  pthread_mutex_unlock(&lock);
  return 0;
}

static void* request(void* cancel) {
  pthread_mutex_lock(&lock);
  while (!begun) pthread_cond_wait(&changed, &lock);
  thalweg_cancel_request(cancel);
  requested = 1;
  pthread_cond_broadcast(&changed);
  pthread_mutex_unlock(&lock);
  return NULL;
}

static void another_thread_cancels(void) {
  thalweg_error e = fresh_error();
  thalweg_build_options options;
  CHECK(thalweg_build_options_init(&options, sizeof options) == THALWEG_OK);
  options.progress = wait_for_request;
  options.cancel = thalweg_cancel_new();
  pthread_t other;
  CHECK(pthread_create(&other, NULL, request, options.cancel) == 0);
  thalweg_terrain* terrain;
  CHECK_STATUS(THALWEG_CANCELLED, thalweg_build(xyz, kPoints, &options, &terrain, &e), e);
  CHECK(pthread_join(other, NULL) == 0);
  thalweg_cancel_free(options.cancel);
}

int main(void) {
  fill_points(xyz, kPoints, 3, 100000, 41);
  for (size_t i = 0; i < kPoints; ++i) memcpy(xy + 2 * i, xyz + 3 * i, 2 * sizeof(double));
  threads_share_handles();
  another_thread_cancels();
  return check_result();
}
