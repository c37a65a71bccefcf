/* Reads rows of x y z, makes a terrain without false pits, and writes it as OBJ to stdout; what there is to
 * say goes to stderr.
 *
 *     cc xyz_to_obj.c -lthalweg_c -o xyz_to_obj && ./xyz_to_obj survey.xyz > survey.obj
 *
 * The statuses of thalweg are the exit codes of this program, as they are those of the command. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "thalweg/thalweg.h"

typedef struct {
  double* xyz;
  size_t count;
} Points;

/* Reads rows until the file ends or something else comes. Returns 0 if memory runs out. */
static int read_points(FILE* file, Points* points) {
  size_t room = 0;
  double row[3];
  points->xyz = NULL;
  points->count = 0;
  while (fscanf(file, "%lf %lf %lf", &row[0], &row[1], &row[2]) == 3) {
    if (points->count == room) {
      room = room ? 2 * room : 1024;
      double* larger = realloc(points->xyz, room * sizeof row);
      if (larger == NULL) return 0;
      points->xyz = larger;
    }
    memcpy(points->xyz + 3 * points->count++, row, sizeof row);
  }
  return 1;
}

/* A result other than 0 would stop the run. */
static int tell(void* data, const char* stage, double fraction) {
  (void)data;
  fprintf(stderr, "%s %.0f %%\n", stage, 100 * fraction);
  return 0;
}

/* Writes vertices and faces; OBJ counts from 1. */
static thalweg_status write_obj(const Points* points, const thalweg_mesh* mesh, thalweg_error* error) {
  const size_t count = thalweg_mesh_triangle_count(mesh);
  uint32_t* triangles = malloc(3 * count * sizeof *triangles);
  if (triangles == NULL) return THALWEG_OUT_OF_MEMORY;
  const thalweg_status status = thalweg_mesh_triangles(mesh, triangles, 3 * count, error);
  if (status == THALWEG_OK) {
    for (size_t i = 0; i < points->count; ++i) {
      const double* p = points->xyz + 3 * i;
      printf("v %.17g %.17g %.17g\n", p[0], p[1], p[2]);
    }
    for (size_t t = 0; t < count; ++t) {
      printf("f %u %u %u\n", triangles[3 * t] + 1, triangles[3 * t + 1] + 1, triangles[3 * t + 2] + 1);
    }
  }
  free(triangles);
  return status;
}

static thalweg_status make_terrain(const Points* points, thalweg_error* error) {
  thalweg_build_options options;
  thalweg_terrain* terrain;
  thalweg_summary summary = {.struct_size = sizeof summary};
  thalweg_build_options_init(&options, sizeof options);
  options.progress = tell;
  thalweg_status status = thalweg_build(points->xyz, points->count, &options, &terrain, error);
  if (status != THALWEG_OK) return status;
  status = thalweg_terrain_summary(terrain, &summary, error);
  if (status == THALWEG_OK) {
    fprintf(stderr, "%u points, pits %u -> %u, %s\n", (unsigned)summary.vertex_count,
            (unsigned)summary.delaunay_pits.total, (unsigned)summary.pits.total,
            summary.certified ? "proved to be the fewest" : "perhaps not the fewest");
    status = write_obj(points, thalweg_terrain_mesh(terrain), error);
  }
  thalweg_terrain_free(terrain);
  return status;
}

int main(int argc, char** argv) {
  if (argc != 2) {
    fprintf(stderr, "usage: %s POINTS.xyz > MESH.obj\n", argv[0]);
    return THALWEG_USAGE;
  }
  FILE* file = fopen(argv[1], "r");
  if (file == NULL) {
    perror(argv[1]);
    return THALWEG_BAD_INPUT;
  }
  Points points;
  thalweg_error error = {.struct_size = sizeof error};
  thalweg_status status = read_points(file, &points) ? THALWEG_OK : THALWEG_OUT_OF_MEMORY;
  fclose(file);
  if (status == THALWEG_OK) status = make_terrain(&points, &error);
  if (status != THALWEG_OK) fprintf(stderr, "%s: %s\n", thalweg_status_name(status), error.message);
  free(points.xyz);
  return status;
}
