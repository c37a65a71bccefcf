/// The main job: points in, a terrain of order k with as few pits as can be found out, with a proof of how
/// far that is.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "thalweg/export.hpp"
#include "thalweg/pits.hpp"
#include "thalweg/point.hpp"
#include "thalweg/result.hpp"
#include "thalweg/triangulation.hpp"

namespace thalweg {

/// How pits are removed.
enum class Method {
  delaunay,  ///< not at all: the canonical Delaunay triangulation
  flip,      ///< the paper's flip heuristic (section 3)
  hull,      ///< the paper's hull heuristic (section 4)
  best,      ///< by assignment, with a proof wherever one is found; never worse than flip or hull, nor at a
             ///< larger order
  exact,     ///< best, and then a search that ends with the minimum and its proof, or with the time limit
};

/// Which elevation a site takes that occurs in several rows.
enum class DuplicatePolicy {
  lowest,   ///< the lowest of them
  highest,  ///< the highest of them
  mean,     ///< their mean, rounded: the one case in which an elevation is computed
  first,    ///< that of the first row
  last,     ///< that of the last row
  error,    ///< none: the call returns ErrorCode::duplicate_points
};

/// How sites in circles are counted. Both give the same answers, and so the same result.
enum class Counter {
  crawl,    ///< search of the Delaunay graph: no memory, no preparation
  voronoi,  ///< point location in the order-(k+1) Voronoi diagram, as in the paper: hundreds of bytes times k
            ///< a site
};

/// What `minimize_pits` is to do.
struct MinimizeOptions {
  unsigned order = 8;            ///< k: every circumcircle holds at most so many sites
  Method method = Method::best;  ///< how pits are removed
  DuplicatePolicy duplicates = DuplicatePolicy::lowest;  ///< what becomes of rows with the same (x, y)
  Counter counter = Counter::crawl;                      ///< how sites in circles are counted
  unsigned threads = 0;     ///< 0 = all of the machine; the result does not depend on it
  double time_limit = 0;    ///< seconds that Method::exact may search beyond best; 0 = until the end
  bool keep_trail = false;  ///< fill Minimized::trail (24 bytes a step)
  /// Called from the calling thread, now and then, with what is being done and how much of it is done in [0,
  /// 1].
  std::function<void(const char* stage, double fraction)> progress = {};
  const std::atomic<bool>* cancel = nullptr;  ///< polled; when true the call returns ErrorCode::cancelled
};

/// Why a pit is still there.
enum class PitReason {
  unremovable,  ///< no vertex of it has a pair of useful order <= k to lower (or equal, other) ground
  conflict,     ///< it has such pairs, but none could be used: each crosses what other pits need, or gains
                ///< nothing
  kept,         ///< it has such pairs, and the method did not try them
};

/// A pit of the result.
struct RemainingPit {
  VertexId vertex;                            ///< the first of the pit in elevation order (z, x, y)
  std::uint32_t vertices = 1;                 ///< how many vertices the pit has
  bool boundary = false;                      ///< whether one of them is on the convex hull
  PitReason reason = PitReason::unremovable;  ///< why it is still there
  /// Least useful order of a pair that leads from the pit to lower, or to equal other, ground; nothing if
  /// there is none at all (the lowest pit), or none up to Minimized::order_searched.
  std::optional<unsigned> order_needed = {};
};

/// A pit of the Delaunay triangulation that is no more.
struct RemovedPit {
  VertexId vertex;             ///< the first of it in elevation order
  std::uint32_t vertices = 1;  ///< how many vertices it had
  bool boundary = false;       ///< whether one of them is on the convex hull
};

/// One change on the way from the Delaunay triangulation to the result.
struct TrailStep {
  /// The two kinds of change.
  enum class Kind : std::uint8_t {
    flip,       ///< the diagonal of a quadrilateral was exchanged
    insertion,  ///< an edge was put in, and with it new triangles on both sides
  };
  Kind kind = Kind::flip;  ///< which of the two it was
  /// Flip: the round in which it was done; no new triangle has a larger order. Insertion: the edge's useful
  /// order.
  unsigned order = 0;
  /// One end of the edge that came. Flip: the lower. Insertion: the one that drains over it.
  VertexId u;
  /// The other end of the edge that came.
  VertexId v;
  /// Flip: one end of the edge that went.
  VertexId old_u;
  /// Flip: the other end of the edge that went.
  VertexId old_v;
  /// First vertex, in elevation order, of the pit that this step removed; invalid if it removed none.
  VertexId pit;
};

/// A terrain, how good it is, and how that is known.
struct Minimized {
  /// The terrain. Vertex ids are the indices of the caller's points; merged rows are isolated vertices.
  Triangulation triangulation;
  /// Order of each face, parallel to the faces.
  std::vector<std::uint32_t> face_orders;

  PitCount delaunay_pits;               ///< of the canonical Delaunay triangulation
  PitCount pits;                        ///< of the result
  std::uint32_t lower_bound = 0;        ///< no triangulation of order <= k has fewer pits
  bool certified = false;               ///< pits.total is proved to be the minimum
  std::vector<RemainingPit> remaining;  ///< by vertex
  std::vector<RemovedPit> removed;      ///< by vertex
  unsigned order_searched = 0;          ///< `order_needed` was looked for up to this order
  std::vector<TrailStep> trail;         ///< if asked for

  std::uint32_t sites = 0;  ///< distinct (x, y)
  /// Rows merged into another: (row, row that stands for it), by row. Empty without duplicates.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> merged;
  /// DuplicatePolicy::mean only: rows that stand for several, with the elevation used instead of their own.
  std::vector<std::pair<std::uint32_t, double>> mean_elevations;

  std::uint32_t edges_changed = 0;       ///< edges that the canonical Delaunay triangulation does not have
  std::uint32_t non_delaunay_edges = 0;  ///< inner edges that are not locally Delaunay
  double min_angle_before_deg = 0;       ///< smallest angle of Delaunay in degrees, rounded, for reading only
  double min_angle_after_deg = 0;        ///< the same of the result

  std::uint64_t flips = 0;          ///< how many were done
  std::uint64_t insertions = 0;     ///< how many were done
  std::uint64_t circle_counts = 0;  ///< how often the sites in a circle were counted
  double seconds_delaunay = 0;      ///< time for the Delaunay triangulation, by the clock on the wall
  double seconds_minimize = 0;      ///< time for all the rest
};

/// A terrain over `points` of order <= options.order with as few pits as the method finds. Elevations and
/// places are never changed (but see DuplicatePolicy::mean). Deterministic: the same points give the same set
/// of triangles, whatever the order of rows, the machine or the number of threads. Laws: pits.total <=
/// delaunay_pits.total; lower_bound <= pits.total; certified == (pits.total == lower_bound). Errors:
/// not_finite, too_few_points, all_collinear, duplicate_points, too_many_points, cancelled; rows name the
/// culprits. Complexity: O(n log n) for the Delaunay triangulation, then in the number of pits and k, not in
/// n; Method::exact is exponential in the worst case, which options.time_limit cuts off. Source: de Kok, van
/// Kreveld, Loeffler, sections 3 and 4, for flip and hull; best and exact are our own.
THALWEG_EXPORT Result<Minimized> minimize_pits(std::span<const Point3> points,
                                               const MinimizeOptions& options = {});

/// Pits at one order, by every method: a row of the paper's Table 1.
struct SweepRow {
  unsigned order = 0;             ///< k
  std::uint32_t flip = 0;         ///< pits that Method::flip leaves
  std::uint32_t hull = 0;         ///< pits that Method::hull leaves
  std::uint32_t best = 0;         ///< pits that Method::best leaves
  std::uint32_t lower_bound = 0;  ///< no triangulation of order <= k has fewer
  bool certified = false;         ///< best == lower_bound
};

/// The table of `sweep_pits`.
struct Sweep {
  std::uint32_t sites = 0;     ///< distinct (x, y)
  std::vector<SweepRow> rows;  ///< by order
};

/// The counts of minimize_pits for every order from `first` to `last` and each method, sharing all that the
/// runs have in common. Uses duplicates, threads, progress and cancel of the options. Errors: as
/// minimize_pits; invalid_argument if first > last, or for more than a million orders. Complexity: as
/// minimize_pits by the three methods for each order, but for one Delaunay triangulation in all.
THALWEG_EXPORT Result<Sweep> sweep_pits(std::span<const Point3> points, unsigned first, unsigned last,
                                        const MinimizeOptions& options = {});

}  // namespace thalweg
