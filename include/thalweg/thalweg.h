/// thalweg for C and for everything that can call C: all of it in this one header, long as that makes it.
///
/// What holds for every function here:
///
/// - No exception leaves it, no signal is raised, nothing is printed, no global is changed. Whatever can fail
///   returns a status, and says why in the caller's `thalweg_error` if there is one (it may be null).
/// - Null pointers, counts of 0, NaN, infinities, ids out of range, unknown values of options and structs too
///   small for this version are answered with a status. A handle that is null or of another type is noticed;
///   one that was freed is not.
/// - Several threads may call it at once. Handles do not change once made: threads may share them until one
///   frees them. The one handle made to be changed by several threads is `thalweg_cancel`.
/// - Arrays belong to the caller, input and output: nothing refers to them after the return. An output array
///   comes with its capacity in elements; one that is too small is THALWEG_USAGE, and nothing is written.
///   On any other failure the content of output arrays is unspecified, and output handles are null.
/// - Points are doubles in a row: x, y, x, y ... ("xy") or x, y, z, x, y, z ... ("xyz"). Any finite value is
///   legal. Units: x and y the same (metres, not degrees); only comparisons of z are ever made. Ids are the
///   indices of the caller's points, from 0. A null array is legal if its count is 0.
/// - `threads` is the number of threads to use, 0 = all of the machine; no result depends on it.
/// - Results are exact and the same on every run, as the C++ headers beside this one say in detail.
#ifndef THALWEG_THALWEG_H
#define THALWEG_THALWEG_H

#include <stddef.h>
#include <stdint.h>

#ifndef THALWEG_API
#if defined(__GNUC__)
/// What the shared library shows.
#define THALWEG_API __attribute__((visibility("default")))
#else
/// What the shared library shows.
#define THALWEG_API
#endif
#endif

#ifdef __cplusplus
extern "C" {
#endif

// NOLINTBEGIN: the names and idioms of C

/// "No vertex", "no triangle", "no order": the id that nothing has. As a signed 32-bit number it is -1.
#define THALWEG_NONE UINT32_C(0xffffffff)

/* ---- Status and errors ------------------------------------------------------------------------------- */

/// How a call ended: 0 or why not. The numbers are the exit codes of the command `thalweg`.
typedef int32_t thalweg_status;
enum {
  THALWEG_OK = 0,              ///< done
  THALWEG_INTERNAL = 1,        ///< a bug of the library
  THALWEG_USAGE = 2,           ///< an argument that makes no sense
  THALWEG_BAD_INPUT = 3,       ///< points that are not finite, too few, all on one line, ...
  THALWEG_VERIFICATION = 4,    ///< triangles that are no triangulation
  THALWEG_OUT_OF_MEMORY = 5,   ///< memory ran out; nothing leaks
  THALWEG_OUTPUT_REFUSED = 6,  ///< the command's; no function here returns it
  THALWEG_CANCELLED = 130      ///< the caller asked to stop
};

/// What exactly was wrong; 0 where the status says all.
enum {
  THALWEG_ERROR_NONE = 0,              ///< none of these
  THALWEG_ERROR_TOO_FEW_POINTS = 1,    ///< fewer distinct points than are needed
  THALWEG_ERROR_ALL_COLLINEAR = 2,     ///< all points on one line
  THALWEG_ERROR_NOT_FINITE = 3,        ///< a NaN or an infinity
  THALWEG_ERROR_DUPLICATE_POINTS = 4,  ///< the same place twice where that is forbidden
  THALWEG_ERROR_TOO_MANY_POINTS = 5,   ///< more than ids can number
  THALWEG_ERROR_INVALID_ARGUMENT = 6,  ///< an argument that makes no sense
  THALWEG_ERROR_INVALID_MESH = 7,      ///< triangles that are no triangulation
  THALWEG_ERROR_CANCELLED = 8          ///< the caller asked to stop
};

/// How many rows a thalweg_error names at most.
#define THALWEG_ERROR_ROWS 16
/// The room for the message of a thalweg_error, its end included.
#define THALWEG_ERROR_MESSAGE 412

/// Why a call failed. Owned by the caller, no part of it is to be freed. A successful call leaves it empty:
/// status 0, no rows, message "". Set `struct_size` before the first call; the rest need not be set.
typedef struct thalweg_error {
  size_t struct_size;                   ///< in: sizeof(thalweg_error)
  thalweg_status status;                ///< what the call returned
  int32_t code;                         ///< THALWEG_ERROR_...
  uint32_t row_count;                   ///< how many points are named in `rows`
  uint32_t rows[THALWEG_ERROR_ROWS];    ///< the first of the points (or triangles) to blame
  char message[THALWEG_ERROR_MESSAGE];  ///< for a person, English, ASCII, ends with 0
} thalweg_error;

/// The name of a status: "ok", "usage", "bad input", ...; "unknown" for other numbers. Never null, not to be
/// freed. Complexity: O(1).
THALWEG_API const char* thalweg_status_name(thalweg_status status);

/// "major.minor.patch" of the library that runs. Never null, not to be freed. Complexity: O(1).
THALWEG_API const char* thalweg_version(void);

/* ---- Predicates -------------------------------------------------------------------------------------- */

/// *sign = +1 if the points a, b, c (two doubles each) turn counter-clockwise, -1 if clockwise, 0 if
/// collinear. Exact. Errors: USAGE for null; BAD_INPUT unless all are finite. Complexity: O(1).
THALWEG_API thalweg_status thalweg_orient2d(const double* a, const double* b, const double* c, int* sign,
                                            thalweg_error* error);

/// *sign, for a, b, c counter-clockwise: +1 if d is strictly inside their circle, 0 if on it, -1 if outside;
/// the opposite for a, b, c clockwise. Exact. Errors: as thalweg_orient2d. Complexity: O(1).
THALWEG_API thalweg_status thalweg_incircle(const double* a, const double* b, const double* c,
                                            const double* d, int* sign, thalweg_error* error);

/// *sign = -1 if b is nearer to a than c is, 0 if equally far, +1 if farther. Exact. Errors: as
/// thalweg_orient2d. Complexity: O(1).
THALWEG_API thalweg_status thalweg_compare_distance(const double* a, const double* b, const double* c,
                                                    int* sign, thalweg_error* error);

/* ---- Watching and stopping --------------------------------------------------------------------------- */

/// Called in the thread of the call that it was given to, now and then: what is being done, and how much of
/// it is done in [0, 1]. `stage` is valid during the call only. A result other than 0 ends the run with
/// THALWEG_CANCELLED. It must return: no exception, no longjmp.
typedef int (*thalweg_progress)(void* data, const char* stage, double fraction);

/// A request to stop that one thread makes and others obey.
typedef struct thalweg_cancel thalweg_cancel;

/// A new request that is not made yet, or null if there is no memory. The caller frees it.
THALWEG_API thalweg_cancel* thalweg_cancel_new(void);
/// Makes the request: runs that were given it return THALWEG_CANCELLED as soon as they look, which for a
/// million points is a fraction of a second (THALWEG_COUNTER_VORONOI builds its diagram first). May be called
/// from any thread and from signal handlers. Null is ignored.
THALWEG_API void thalweg_cancel_request(thalweg_cancel* cancel);
/// Takes it back, so that it can be used again. Null is ignored.
THALWEG_API void thalweg_cancel_reset(thalweg_cancel* cancel);
/// 1 if it was made, else 0; 0 for null.
THALWEG_API int thalweg_cancel_requested(const thalweg_cancel* cancel);
/// Frees it. Requires: no run uses it any more. Null is ignored.
THALWEG_API void thalweg_cancel_free(thalweg_cancel* cancel);

/* ---- Meshes ------------------------------------------------------------------------------------------ */

/// A triangulation: which vertices are joined, without coordinates.
typedef struct thalweg_mesh thalweg_mesh;

/// The canonical Delaunay triangulation of n points "xy". Of equal points the first is a vertex, the others
/// are in no triangle. The caller frees *mesh. Errors: BAD_INPUT with the rows to blame: not finite, fewer
/// than three distinct points, all on one line, too many. Complexity: O(n log n).
THALWEG_API thalweg_status thalweg_delaunay(const double* xy, size_t n, uint32_t threads, thalweg_mesh** mesh,
                                            thalweg_error* error);

/// The mesh of m triangles, three ids in a row each, over n vertices; vertices in no triangle are legal. The
/// caller frees *mesh. Errors: VERIFICATION if an id is n or more, a triangle repeats a vertex, a directed
/// edge occurs twice, or the triangles at a vertex are not one fan. Positions are not looked at:
/// `thalweg_validate` does. Complexity: O(m log m).
THALWEG_API thalweg_status thalweg_mesh_from_triangles(const uint32_t* triangles, size_t m, size_t n,
                                                       thalweg_mesh** mesh, thalweg_error* error);

/// The number of vertices, those in no triangle included; 0 for a wrong handle. Complexity: O(1).
THALWEG_API size_t thalweg_mesh_vertex_count(const thalweg_mesh* mesh);
/// The number of triangles; 0 for a wrong handle. Complexity: O(1).
THALWEG_API size_t thalweg_mesh_triangle_count(const thalweg_mesh* mesh);

/// Writes the triangles, counter-clockwise, three ids each: 3 * triangle_count elements. Errors: USAGE.
/// Complexity: O(m).
THALWEG_API thalweg_status thalweg_mesh_triangles(const thalweg_mesh* mesh, uint32_t* triangles,
                                                  size_t capacity, thalweg_error* error);

/// Writes for each corner of each triangle the triangle across the edge opposite to it, THALWEG_NONE on the
/// hull: 3 * triangle_count elements, in the order of `thalweg_mesh_triangles`. Errors: USAGE. Complexity:
/// O(m).
THALWEG_API thalweg_status thalweg_mesh_neighbors(const thalweg_mesh* mesh, uint32_t* neighbors,
                                                  size_t capacity, thalweg_error* error);

/// Frees it. Null is ignored, and so is a mesh that belongs to a terrain or to sites.
THALWEG_API void thalweg_mesh_free(thalweg_mesh* mesh);

/* ---- Pits -------------------------------------------------------------------------------------------- */

/// Numbers of pits. Laws: total == interior + boundary.
typedef struct thalweg_pit_count {
  uint32_t total;     ///< all pits
  uint32_t interior;  ///< pits without a vertex on the convex hull
  uint32_t boundary;  ///< pits with a vertex on the convex hull
} thalweg_pit_count;

/// The pits of a terrain, each a set of vertices.
typedef struct thalweg_pits thalweg_pits;

/// The pits of the terrain with elevation z[v] at vertex v: maximal sets of joined vertices of equal z
/// without a strictly lower neighbour, by their first vertex. The caller frees *pits. Errors: USAGE unless n
/// is the number of vertices; BAD_INPUT with rows unless all z are finite. Complexity: O(n).
THALWEG_API thalweg_status thalweg_mesh_pits(const thalweg_mesh* mesh, const double* z, size_t n,
                                             thalweg_pits** pits, thalweg_error* error);

/// How many they are; zeros for a wrong handle. Complexity: O(number of pits).
THALWEG_API thalweg_pit_count thalweg_pits_count(const thalweg_pits* pits);
/// The number of vertices of all pits together; 0 for a wrong handle. Complexity: O(number of pits).
THALWEG_API size_t thalweg_pits_vertex_count(const thalweg_pits* pits);

/// Writes the pits one after the other: pit i has vertices[starts[i]] to vertices[starts[i + 1] - 1],
/// ascending, and boundary[i] is 1 if it touches the hull, else 0. `starts` has total + 1 elements,
/// `vertices` has vertex_count, `boundary` has total; capacities in that order. Errors: USAGE. Complexity:
/// O(vertices written).
THALWEG_API thalweg_status thalweg_pits_get(const thalweg_pits* pits, uint32_t* starts,
                                            size_t starts_capacity, uint32_t* vertices,
                                            size_t vertices_capacity, uint8_t* boundary,
                                            size_t boundary_capacity, thalweg_error* error);

/// Frees them. Null is ignored.
THALWEG_API void thalweg_pits_free(thalweg_pits* pits);

/* ---- The main job ------------------------------------------------------------------------------------ */

/// How pits are removed.
enum {
  THALWEG_METHOD_DELAUNAY = 0,  ///< not at all
  THALWEG_METHOD_FLIP = 1,      ///< the flip heuristic
  THALWEG_METHOD_HULL = 2,      ///< the hull heuristic
  THALWEG_METHOD_BEST = 3,      ///< by assignment, never worse than flip or hull
  THALWEG_METHOD_EXACT = 4      ///< best, and then a search for the minimum
};

/// Which elevation a place takes that occurs in several rows. The row that stands for the place is a vertex
/// of the mesh, the others are in no triangle.
enum {
  THALWEG_DUPLICATES_LOWEST = 0,   ///< the lowest of them
  THALWEG_DUPLICATES_HIGHEST = 1,  ///< the highest
  THALWEG_DUPLICATES_MEAN = 2,     ///< the only policy that computes an elevation
  THALWEG_DUPLICATES_FIRST = 3,    ///< that of the first row
  THALWEG_DUPLICATES_LAST = 4,     ///< that of the last row
  THALWEG_DUPLICATES_ERROR = 5     ///< BAD_INPUT
};

/// How sites in circles are counted; the results are the same.
enum {
  THALWEG_COUNTER_CRAWL = 0,   ///< search of the Delaunay graph: the faster
  THALWEG_COUNTER_VORONOI = 1  ///< point location in the order-(k+1) Voronoi diagram
};

/// What to do. Fill it by `thalweg_build_options_init`, then change what is wanted. It may grow at its end:
/// `struct_size` tells which fields the caller knows, and the others have their defaults.
typedef struct thalweg_build_options {
  size_t struct_size;         ///< sizeof(thalweg_build_options)
  uint32_t order;             ///< k: every circumcircle holds at most so many points; default 8
  int32_t method;             ///< THALWEG_METHOD_...; default best
  int32_t duplicates;         ///< THALWEG_DUPLICATES_...; default lowest
  int32_t counter;            ///< THALWEG_COUNTER_...; default crawl
  uint32_t threads;           ///< default 0 = all of the machine
  uint32_t keep_trail;        ///< not 0: keep what was changed, step by step; default 0
  double time_limit;          ///< seconds that exact may search beyond best, 0 = to the end; default 0
  thalweg_progress progress;  ///< may be null, the default
  void* progress_data;        ///< handed to `progress`
  /// May be null, the default. With both, a result of `progress` other than 0 makes the request of `cancel`.
  thalweg_cancel* cancel;
} thalweg_build_options;

/// Sets the defaults. Returns USAGE, with nothing written, for null or a size that is smaller than the first
/// version of the struct. Fields that a newer header has and this library does not know become 0.
THALWEG_API thalweg_status thalweg_build_options_init(thalweg_build_options* options, size_t struct_size);

/// A finished terrain with its report.
typedef struct thalweg_terrain thalweg_terrain;

/// A terrain of order <= options->order over n points "xyz" with as few pits as the method finds. Null
/// options are the defaults. The caller frees *terrain. Places and elevations are never changed. Errors:
/// USAGE (also for options of a newer header that ask for what this library does not know); BAD_INPUT with
/// the rows to blame; CANCELLED; OUT_OF_MEMORY. Complexity: O(n log n), then in the number of pits and k.
THALWEG_API thalweg_status thalweg_build(const double* xyz, size_t n, const thalweg_build_options* options,
                                         thalweg_terrain** terrain, thalweg_error* error);

/// What there is to tell of a terrain. May grow at its end as thalweg_build_options does.
typedef struct thalweg_summary {
  size_t struct_size;               ///< in: sizeof(thalweg_summary)
  uint32_t vertex_count;            ///< the caller's points
  uint32_t site_count;              ///< distinct places
  uint32_t triangle_count;          ///< of the mesh
  uint32_t max_order;               ///< of all triangles
  thalweg_pit_count delaunay_pits;  ///< before
  thalweg_pit_count pits;           ///< after
  uint32_t lower_bound;             ///< no triangulation of this order has fewer pits
  uint32_t certified;               ///< 1 if pits.total is proved to be the minimum, else 0
  uint32_t order_searched;          ///< order_needed of remaining pits was looked for up to this order
  uint32_t remaining_count;         ///< pits that are left
  uint32_t removed_count;           ///< pits of the Delaunay triangulation that are no more
  uint32_t merged_count;            ///< rows merged into others
  uint32_t mean_count;              ///< rows with a mean elevation
  uint32_t edges_changed;           ///< edges that the Delaunay triangulation does not have
  uint32_t non_delaunay_edges;      ///< inner edges that are not locally Delaunay
  uint32_t reserved;                ///< 0
  uint64_t trail_count;             ///< steps kept
  uint64_t flips;                   ///< edges flipped
  uint64_t insertions;              ///< edges inserted
  uint64_t circle_counts;           ///< circles whose points were counted
  double min_angle_before_deg;      ///< rounded, for reading only
  double min_angle_after_deg;       ///< the same of the result
  double seconds_delaunay;          ///< for the Delaunay triangulation
  double seconds_minimize;          ///< for all that followed
} thalweg_summary;

/// Fills the fields that summary->struct_size covers; set it before. Errors: USAGE. Complexity: O(pits +
/// triangles).
THALWEG_API thalweg_status thalweg_terrain_summary(const thalweg_terrain* terrain, thalweg_summary* summary,
                                                   thalweg_error* error);

/// The mesh of the terrain, over the caller's points; null for a wrong handle. It belongs to the terrain.
THALWEG_API const thalweg_mesh* thalweg_terrain_mesh(const thalweg_terrain* terrain);

/// Writes the order of each triangle: triangle_count elements. Errors: USAGE. Complexity: O(m).
THALWEG_API thalweg_status thalweg_terrain_orders(const thalweg_terrain* terrain, uint32_t* orders,
                                                  size_t capacity, thalweg_error* error);

/// Why a pit is still there.
enum {
  THALWEG_REASON_UNREMOVABLE = 0,  ///< nothing lower can be joined to it at this order
  THALWEG_REASON_CONFLICT = 1,     ///< its ways out cross what others need, or gain nothing
  THALWEG_REASON_KEPT = 2          ///< the method did not try
};

/// A pit that is left. This struct and those below never change; more to tell gets a function of its own.
typedef struct thalweg_remaining_pit {
  uint32_t vertex;        ///< the first of the pit in elevation order (z, x, y)
  uint32_t vertices;      ///< how many it has
  uint32_t boundary;      ///< 1 if it touches the hull, else 0
  int32_t reason;         ///< THALWEG_REASON_...
  uint32_t order_needed;  ///< least order that joins it to lower ground; THALWEG_NONE if none was found
} thalweg_remaining_pit;

/// A pit of the Delaunay triangulation that is no more.
typedef struct thalweg_removed_pit {
  uint32_t vertex;    ///< the first of the pit in elevation order (z, x, y)
  uint32_t vertices;  ///< how many it had
  uint32_t boundary;  ///< 1 if it touched the hull, else 0
} thalweg_removed_pit;

/// A row that is in no triangle, and the row at the same place that is.
typedef struct thalweg_merged_row {
  uint32_t row;   ///< in no triangle
  uint32_t kept;  ///< in its stead
} thalweg_merged_row;

/// A row that stands for several, with the elevation that was used instead of its own.
typedef struct thalweg_mean_elevation {
  double z;           ///< the mean
  uint32_t row;       ///< the row that has it
  uint32_t reserved;  ///< 0
} thalweg_mean_elevation;

/// Kinds of changes.
enum {
  THALWEG_STEP_FLIP = 0,      ///< one diagonal of a quadrilateral for the other
  THALWEG_STEP_INSERTION = 1  ///< an edge, and what it crosses made anew
};

/// One change on the way from the Delaunay triangulation to the result.
typedef struct thalweg_trail_step {
  int32_t kind;    ///< THALWEG_STEP_...
  uint32_t order;  ///< of the flip's new triangles at most; the useful order of an inserted edge
  uint32_t u;      ///< the edge that came; u drains over an inserted one
  uint32_t v;      ///< its other end
  uint32_t old_u;  ///< the edge that went; THALWEG_NONE for insertions
  uint32_t old_v;  ///< its other end
  uint32_t pit;    ///< first vertex of the pit that is gone by it, or THALWEG_NONE
} thalweg_trail_step;

/// Writes the pits that are left, by vertex: summary.remaining_count elements. Errors: USAGE. Complexity:
/// O(elements), here and below.
THALWEG_API thalweg_status thalweg_terrain_remaining(const thalweg_terrain* terrain,
                                                     thalweg_remaining_pit* pits, size_t capacity,
                                                     thalweg_error* error);
/// Writes the pits that are no more, by vertex: summary.removed_count elements. Errors: USAGE.
THALWEG_API thalweg_status thalweg_terrain_removed(const thalweg_terrain* terrain, thalweg_removed_pit* pits,
                                                   size_t capacity, thalweg_error* error);
/// Writes the rows that were merged into others, by row: summary.merged_count elements. Errors: USAGE.
THALWEG_API thalweg_status thalweg_terrain_merged(const thalweg_terrain* terrain, thalweg_merged_row* rows,
                                                  size_t capacity, thalweg_error* error);
/// Writes the rows with a mean elevation, by row: summary.mean_count elements. Errors: USAGE.
THALWEG_API thalweg_status thalweg_terrain_means(const thalweg_terrain* terrain, thalweg_mean_elevation* rows,
                                                 size_t capacity, thalweg_error* error);
/// Writes the changes from the first to the last: summary.trail_count elements, none unless keep_trail was
/// set. Errors: USAGE.
THALWEG_API thalweg_status thalweg_terrain_trail(const thalweg_terrain* terrain, thalweg_trail_step* steps,
                                                 size_t capacity, thalweg_error* error);

/// Frees it and its mesh. Null is ignored.
THALWEG_API void thalweg_terrain_free(thalweg_terrain* terrain);

/// Pits at one order, by every method.
typedef struct thalweg_sweep_row {
  uint32_t order;        ///< k
  uint32_t flip;         ///< pits left by the flip heuristic
  uint32_t hull;         ///< pits left by the hull heuristic
  uint32_t best;         ///< pits left by the best method
  uint32_t lower_bound;  ///< no triangulation of this order has fewer
  uint32_t certified;    ///< 1 if best is proved to be the minimum, else 0
} thalweg_sweep_row;

/// Writes the counts of pits for every order from `first` to `last`: last - first + 1 rows. Of the options
/// (null = defaults) it uses duplicates, threads, progress and cancel. Errors: as thalweg_build; USAGE if
/// first > last, or for more than a million orders. Complexity: less than a thalweg_build an order.
THALWEG_API thalweg_status thalweg_sweep(const double* xyz, size_t n, uint32_t first, uint32_t last,
                                         const thalweg_build_options* options, thalweg_sweep_row* rows,
                                         size_t capacity, thalweg_error* error);

/* ---- Is it a triangulation? -------------------------------------------------------------------------- */

/// Kinds of faults of a mesh.
enum {
  THALWEG_FAULT_INDEX_OUT_OF_RANGE = 0,  ///< an id that no point has
  THALWEG_FAULT_DEGENERATE = 1,          ///< a triangle without area
  THALWEG_FAULT_CLOCKWISE = 2,           ///< a triangle that turns the wrong way
  THALWEG_FAULT_DUPLICATE_VERTEX = 3,    ///< two vertices at the same place
  THALWEG_FAULT_UNUSED_VERTEX = 4,       ///< a point in no triangle
  THALWEG_FAULT_DUPLICATE_TRIANGLE = 5,  ///< the same three points twice
  THALWEG_FAULT_NON_MANIFOLD = 6,        ///< three triangles at an edge, or several fans at a vertex
  THALWEG_FAULT_CROSSING = 7,            ///< two edges that cross, or a vertex inside an edge
  THALWEG_FAULT_OVERLAP = 8,             ///< two triangles that share area
  THALWEG_FAULT_HOLE = 9                 ///< part of the convex hull is not covered
};

/// What is wrong with a mesh: one entry a kind of fault.
typedef struct thalweg_faults thalweg_faults;

/// Whether m triangles, three ids each, are a counter-clockwise triangulation of n points "xy" that uses all
/// of them and covers their convex hull. Returns OK if so, VERIFICATION if not. `faults` may be null;
/// otherwise *faults is made in both cases, and the caller frees it. Exact. Errors: USAGE; BAD_INPUT with
/// rows unless all coordinates are finite. Complexity: O(m log m) for a sound mesh.
THALWEG_API thalweg_status thalweg_validate(const double* xy, size_t n, const uint32_t* triangles, size_t m,
                                            thalweg_faults** faults, thalweg_error* error);

/// How many kinds of faults there are; 0 for a wrong handle. Complexity: O(1), here and below.
THALWEG_API size_t thalweg_faults_count(const thalweg_faults* faults);
/// The kind of entry i, THALWEG_FAULT_..., ascending in i; -1 if there is no such entry.
THALWEG_API int32_t thalweg_faults_kind(const thalweg_faults* faults, size_t i);
/// How often that fault was found (counting stops at a million); 0 if there is no such entry.
THALWEG_API uint64_t thalweg_faults_occurrences(const thalweg_faults* faults, size_t i);
/// Where, in words, for a person: example j of entry i; null if there are not so many (at most five). Belongs
/// to the handle.
THALWEG_API const char* thalweg_faults_example(const thalweg_faults* faults, size_t i, size_t j);
/// The name of a kind: "hole", ...; "unknown" for other numbers. Never null, not to be freed.
THALWEG_API const char* thalweg_fault_name(int32_t kind);
/// Frees it. Null is ignored.
THALWEG_API void thalweg_faults_free(thalweg_faults* faults);

/* ---- Orders of triangles and pairs ------------------------------------------------------------------- */

/// Points in the plane, prepared for questions about circles. Equal points are one site.
typedef struct thalweg_sites thalweg_sites;

/// Copies n points "xy" and triangulates them. The caller frees *sites. Errors: as thalweg_delaunay.
/// Complexity: O(n log n).
THALWEG_API thalweg_status thalweg_sites_new(const double* xy, size_t n, uint32_t threads,
                                             thalweg_sites** sites, thalweg_error* error);

/// Their Delaunay triangulation; null for a wrong handle. It belongs to the sites.
THALWEG_API const thalweg_mesh* thalweg_sites_mesh(const thalweg_sites* sites);

/// Writes the order of each of m triangles, three ids each: how many sites are strictly inside its
/// circumcircle, or limit + 1 if they are more than `limit`. The triangles need not be a mesh. Exact. Errors:
/// USAGE for an id out of range; VERIFICATION, with the triangles as rows, for one that is not
/// counter-clockwise. Complexity: O(n + m * order).
THALWEG_API thalweg_status thalweg_sites_triangle_orders(const thalweg_sites* sites,
                                                         const uint32_t* triangles, size_t m, uint32_t limit,
                                                         uint32_t threads, uint32_t* orders, size_t capacity,
                                                         thalweg_error* error);

/// *order = the useful order of the pair u, v: the least k for which some triangulation of order k joins
/// them; limit + 1 if it is more than `limit`; THALWEG_NONE if a site lies between them. Exact. Errors: USAGE
/// for ids out of range or at the same place. Complexity: O(n) for scratch memory, then of the order of
/// `limit`: for many pairs take thalweg_sites_useful_pairs.
THALWEG_API thalweg_status thalweg_sites_useful_order(const thalweg_sites* sites, uint32_t u, uint32_t v,
                                                      uint32_t limit, uint32_t* order, thalweg_error* error);

/// A pair of points with its useful order.
typedef struct thalweg_pair {
  uint32_t u;      ///< the smaller id
  uint32_t v;      ///< the larger id
  uint32_t order;  ///< their useful order
} thalweg_pair;

/// Pairs of points.
typedef struct thalweg_pairs thalweg_pairs;

/// All pairs of useful order at most k, each once with u < v, sorted. Of equal points the first stands for
/// all. The caller frees *pairs. Errors: USAGE, OUT_OF_MEMORY. Complexity: of the order of n k^2.7 for sites
/// in general position.
THALWEG_API thalweg_status thalweg_sites_useful_pairs(const thalweg_sites* sites, uint32_t k,
                                                      uint32_t threads, thalweg_pairs** pairs,
                                                      thalweg_error* error);

/// How many they are; 0 for a wrong handle. Complexity: O(1).
THALWEG_API size_t thalweg_pairs_count(const thalweg_pairs* pairs);
/// Writes them: count elements. Errors: USAGE. Complexity: O(count).
THALWEG_API thalweg_status thalweg_pairs_get(const thalweg_pairs* pairs, thalweg_pair* out, size_t capacity,
                                             thalweg_error* error);
/// Frees them. Null is ignored.
THALWEG_API void thalweg_pairs_free(thalweg_pairs* pairs);
/// Frees them and their mesh. Null is ignored.
THALWEG_API void thalweg_sites_free(thalweg_sites* sites);

/* ---- Which k points are the nearest? ----------------------------------------------------------------- */

/// The order-k Voronoi diagram: its cells are where the k nearest points are the same.
typedef struct thalweg_voronoi thalweg_voronoi;

/// The diagram of order k of n points "xy". One point, and points on one line, are legal; of equal points the
/// first stands for all. The caller frees *voronoi. Errors: USAGE if k is 0; BAD_INPUT: not finite with
/// rows, fewer than k distinct points, too many. Complexity: O(k^2 n + n log n) expected; memory about 415 k
/// bytes a point at the peak.
THALWEG_API thalweg_status thalweg_voronoi_new(const double* xy, size_t n, uint32_t k, uint32_t threads,
                                               thalweg_voronoi** voronoi, thalweg_error* error);

/// k; 0 for a wrong handle. Complexity: O(1), as for all that are numbers.
THALWEG_API uint32_t thalweg_voronoi_order(const thalweg_voronoi* voronoi);
/// The number of distinct points; 0 for a wrong handle.
THALWEG_API size_t thalweg_voronoi_site_count(const thalweg_voronoi* voronoi);
/// The number of cells; 0 for a wrong handle.
THALWEG_API size_t thalweg_voronoi_cell_count(const thalweg_voronoi* voronoi);
/// Bytes of memory that it holds; 0 for a wrong handle.
THALWEG_API size_t thalweg_voronoi_memory_bytes(const thalweg_voronoi* voronoi);

/// Writes the k nearest points of each of q places "xy", nearest first, equal distances by (x, y): q * k
/// elements. Exact. Errors: USAGE; BAD_INPUT with the places as rows unless all are finite. Complexity: per
/// place O(log n) to a point near it, expected O(sqrt(k)) cells from there, and O(k log k).
THALWEG_API thalweg_status thalweg_voronoi_nearest(const thalweg_voronoi* voronoi, const double* places,
                                                   size_t q, uint32_t threads, uint32_t* nearest,
                                                   size_t capacity, thalweg_error* error);

/// Writes the cell of each of q places "xy": q elements. Ties as in thalweg_voronoi_nearest. Exact. Errors:
/// as there. Complexity: as there, without the sorting.
THALWEG_API thalweg_status thalweg_voronoi_locate(const thalweg_voronoi* voronoi, const double* places,
                                                  size_t q, uint32_t threads, uint32_t* cells,
                                                  size_t capacity, thalweg_error* error);

/// Writes the k points of a cell, ascending: k elements. Errors: USAGE. Complexity: O(k).
THALWEG_API thalweg_status thalweg_voronoi_cell_sites(const thalweg_voronoi* voronoi, uint32_t cell,
                                                      uint32_t* sites, size_t capacity, thalweg_error* error);

/// The cell as a convex polygon "xy", counter-clockwise, clipped to the box (low x, low y, high x, high y),
/// in rounded coordinates, for drawing only. *corners = how many corners it has, 0 if nothing is left; they
/// are written if `capacity` (in doubles) is at least twice that, and otherwise nothing is and the status is
/// USAGE, so that a first call with capacity 0 tells how much is needed. Errors: USAGE; BAD_INPUT unless the
/// box is finite. Complexity: O(edges^2) of the cell.
THALWEG_API thalweg_status thalweg_voronoi_polygon(const thalweg_voronoi* voronoi, uint32_t cell,
                                                   const double* box, double* polygon, size_t capacity,
                                                   size_t* corners, thalweg_error* error);

/// Frees it. Null is ignored.
THALWEG_API void thalweg_voronoi_free(thalweg_voronoi* voronoi);

// NOLINTEND

#ifdef __cplusplus
}
#endif

#endif
