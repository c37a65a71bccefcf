/// Is a set of triangles a triangulation? What can be told from triangles, edges and the border alone; only
/// when that fails are crossings searched for (validate_search.cpp).
///
/// Theorem. Let all triangles be counter-clockwise, let no directed edge occur twice, let the directed edges
/// whose reverse does not occur be exactly the edges of the convex hull of all vertices, counter-clockwise
/// and through every vertex on it, and let every vertex be used and no two coincide. Then the triangles are a
/// triangulation of the vertices.
///
/// Proof. Let p be a point on no edge. The winding number of a counter-clockwise triangle about p is 1 if it
/// contains p and 0 if not, so the sum over all triangles is the number that cover p. That sum is also the
/// sum over directed edges of the angle they subtend at p, where an edge and its reverse cancel; what is left
/// is the hull's winding number, 1 inside and 0 outside. So almost every point of the hull is covered exactly
/// once: interiors of triangles are disjoint and, finitely many closed sets being closed, they fill the hull.
/// No vertex w lies inside a triangle or on an edge it does not end: some triangle has w as corner and area
/// near w; if w were inside a triangle, or on an edge with a triangle on either side, that area would be
/// covered twice; and an edge with one side is a hull edge, which passes no vertex. So triangles meet in
/// whole edges and corners. (Then the triangles at each vertex are also one fan, which need not be assumed.)
#include "thalweg/validate.hpp"

#include <algorithm>
#include <numeric>

#include "kernel/mesh_faults.hpp"
#include "kernel/predicates_inline.hpp"

namespace thalweg {
namespace detail {

bool FaultLog::empty() const noexcept {
  return std::all_of(faults_.begin(), faults_.end(), [](const Fault& f) { return f.count == 0; });
}

std::vector<Fault> FaultLog::take() && {
  std::vector<Fault> result;
  for (std::size_t kind = 0; kind < kKinds; ++kind) {
    if (faults_[kind].count == 0) continue;
    faults_[kind].kind = static_cast<FaultKind>(kind);
    result.push_back(std::move(faults_[kind]));
  }
  return result;
}

std::string triangle_text(std::span<const Corners> given, std::uint32_t triangle) {
  const Corners& t = given[triangle];
  return "triangle " + std::to_string(triangle) + " (" + std::to_string(t[0]) + ", " + std::to_string(t[1]) +
         ", " + std::to_string(t[2]) + ")";
}

}  // namespace detail

namespace {

using detail::CleanMesh;
using detail::Corners;
using detail::Edge;
using detail::FaultLog;

std::string edge_text(std::uint32_t u, std::uint32_t v) {
  return "edge " + std::to_string(u) + " - " + std::to_string(v);
}

/// The vertices by (x, y), equal ones by index.
std::vector<std::uint32_t> sorted_vertices(std::span<const Point2> points) {
  std::vector<std::uint32_t> sorted(points.size());
  std::iota(sorted.begin(), sorted.end(), 0u);
  std::sort(sorted.begin(), sorted.end(), [&](std::uint32_t i, std::uint32_t j) {
    const Point2 a = points[i], b = points[j];
    if (a.x != b.x) return a.x < b.x;
    if (a.y != b.y) return a.y < b.y;
    return i < j;
  });
  return sorted;
}

/// The place of each vertex. Logs duplicates and removes them from `sorted`.
std::vector<std::uint32_t> merge_places(std::span<const Point2> points, std::vector<std::uint32_t>& sorted,
                                        FaultLog& log) {
  std::vector<std::uint32_t> place(points.size());
  std::size_t kept = 0;
  for (const std::uint32_t v : sorted) {
    if (kept > 0 && points[sorted[kept - 1]] == points[v]) {
      const std::uint32_t first = sorted[kept - 1];
      place[v] = first;
      log.add(FaultKind::duplicate_vertex,
              [&] { return "vertices " + std::to_string(first) + " and " + std::to_string(v); });
    } else {
      place[v] = v;
      sorted[kept++] = v;
    }
  }
  sorted.resize(kept);
  return place;
}

/// The hull through every place on it, as successor of each place. Requires: places by (x, y).
std::vector<std::uint32_t> hull_successors(std::span<const Point2> points,
                                           std::span<const std::uint32_t> places) {
  std::vector<std::uint32_t> next(points.size(), CleanMesh::kNoPlace);
  const auto add_chain = [&](auto first, auto last) {
    std::vector<std::uint32_t> chain;
    for (; first != last; ++first) {
      while (chain.size() >= 2 && detail::orient2d_sign(points[chain[chain.size() - 2]], points[chain.back()],
                                                        points[*first]) < 0) {
        chain.pop_back();
      }
      chain.push_back(*first);
    }
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) next[chain[i]] = chain[i + 1];
  };
  add_chain(places.begin(), places.end());
  add_chain(places.rbegin(), places.rend());
  return next;
}

/// The triangles without faults of their own: indices in range, with area, turned counter-clockwise, no
/// repetition. Returns their vertices; mesh.names tells which they are.
std::vector<Corners> keep_sound_triangles(CleanMesh& mesh, FaultLog& log) {
  std::vector<std::pair<Corners, std::uint32_t>> seen;
  std::vector<Corners> sound(mesh.given.size());
  std::vector<bool> used(mesh.points.size(), false);
  for (std::uint32_t i = 0; i < mesh.given.size(); ++i) {
    Corners t = mesh.given[i];
    const auto text = [&] { return detail::triangle_text(mesh.given, i); };
    if (std::any_of(t.begin(), t.end(), [&](std::uint32_t v) { return v >= mesh.points.size(); })) {
      log.add(FaultKind::index_out_of_range, text);
      continue;
    }
    for (const std::uint32_t v : t) used[v] = true;
    const bool repeats = t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
    const int sign =
        repeats ? 0 : detail::orient2d_sign(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]);
    if (sign == 0) {
      log.add(FaultKind::degenerate, text);
      continue;
    }
    if (sign < 0) {
      log.add(FaultKind::clockwise, text);
      std::swap(t[1], t[2]);
    }
    sound[i] = t;
    std::sort(t.begin(), t.end());
    seen.emplace_back(t, i);
  }
  for (std::uint32_t v = 0; v < mesh.points.size(); ++v) {
    if (!used[v]) log.add(FaultKind::unused_vertex, [&] { return "vertex " + std::to_string(v); });
  }

  std::sort(seen.begin(), seen.end());
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (i == 0 || seen[i].first != seen[i - 1].first) {
      mesh.names.push_back(seen[i].second);
      continue;
    }
    log.add(FaultKind::duplicate_triangle, [&] {
      return detail::triangle_text(mesh.given, seen[i].second) + ", the same as triangle " +
             std::to_string(mesh.names.back());
    });
  }
  std::sort(mesh.names.begin(), mesh.names.end());
  std::vector<Corners> result;
  result.reserve(mesh.names.size());
  for (const std::uint32_t i : mesh.names) result.push_back(sound[i]);
  return result;
}

/// One side of one triangle, sorted so that all sides between the same two vertices are neighbours.
struct Side {
  std::uint32_t low, high;
  std::uint32_t corner;  ///< 3 * triangle + i: from corner i to corner i + 1
  friend auto operator<=>(const Side&, const Side&) = default;
};

constexpr std::uint32_t following(std::uint32_t corner) {
  return corner % 3 == 2 ? corner - 2 : corner + 1;
}

std::vector<Side> sorted_sides(std::span<const Corners> triangles) {
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint32_t u = triangles[t][i], v = triangles[t][(i + 1) % 3];
      sides.push_back({std::min(u, v), std::max(u, v), 3 * t + i});
    }
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

/// Calls visit(sides of one edge) for each edge.
template <class Visit>
void for_each_edge(std::span<const Side> sides, Visit&& visit) {
  for (std::size_t first = 0; first < sides.size();) {
    std::size_t last = first + 1;
    while (last < sides.size() && sides[last].low == sides[first].low &&
           sides[last].high == sides[first].high) {
      ++last;
    }
    visit(sides.subspan(first, last - first));
    first = last;
  }
}

/// Logs edges of three or more triangles, and vertices whose triangles do not hang together by edges.
void check_manifold(std::size_t vertex_count, std::span<const Corners> triangles, std::span<const Side> sides,
                    FaultLog& log) {
  // Union-find over corners: two corners at one vertex are joined when an edge at it is.
  std::vector<std::uint32_t> parent(3 * triangles.size());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root = [&](std::uint32_t c) {
    while (parent[c] != c) c = parent[c] = parent[parent[c]];
    return c;
  };
  const auto vertex = [&](std::uint32_t corner) { return triangles[corner / 3][corner % 3]; };
  for_each_edge(sides, [&](std::span<const Side> edge) {
    if (edge.size() > 2) {
      log.add(FaultKind::non_manifold, [&] {
        return edge_text(edge[0].low, edge[0].high) + " of " + std::to_string(edge.size()) + " triangles";
      });
    }
    for (std::size_t i = 1; i < edge.size(); ++i) {
      const std::uint32_t a = edge[0].corner, b = edge[i].corner;
      const bool same_way = vertex(a) == vertex(b);
      parent[root(a)] = root(same_way ? b : following(b));
      parent[root(following(a))] = root(same_way ? following(b) : b);
    }
  });

  std::vector<std::uint32_t> fans(vertex_count, 0);
  for (std::uint32_t c = 0; c < parent.size(); ++c) {
    if (parent[c] == c) ++fans[vertex(c)];
  }
  for (std::uint32_t v = 0; v < vertex_count; ++v) {
    if (fans[v] <= 1) continue;
    log.add(FaultKind::non_manifold, [&] {
      return "vertex " + std::to_string(v) + " with " + std::to_string(fans[v]) + " separate fans";
    });
  }
}

/// Fills edges and border. Returns whether every directed edge occurs once and the border is the hull.
bool find_border(std::span<const Side> sides, std::size_t place_count, CleanMesh& mesh) {
  bool sound = true;
  std::size_t hull_edges = 0;
  for_each_edge(sides, [&](std::span<const Side> edge) {
    const std::uint32_t low = edge[0].low, high = edge[0].high;
    const auto upward = std::count_if(edge.begin(), edge.end(), [&](const Side& side) {
      return mesh.corners[side.corner / 3][side.corner % 3] == low;
    });
    const auto downward = static_cast<std::ptrdiff_t>(edge.size()) - upward;
    mesh.edges.push_back({low, high});
    if (upward > 1 || downward > 1) sound = false;
    if (upward == downward) return;
    const Edge border = upward > downward ? Edge{low, high} : Edge{high, low};
    mesh.border.push_back(border);
    if (mesh.hull_next[border.from] == border.to) ++hull_edges;
  });
  const auto hull_size =
      mesh.hull_next.size() -
      static_cast<std::size_t>(std::count(mesh.hull_next.begin(), mesh.hull_next.end(), CleanMesh::kNoPlace));
  return sound && place_count >= 3 && hull_edges == hull_size && mesh.border.size() == hull_size;
}

}  // namespace

const char* fault_name(FaultKind kind) noexcept {
  switch (kind) {
    case FaultKind::index_out_of_range:
      return "index out of range";
    case FaultKind::degenerate:
      return "degenerate triangle";
    case FaultKind::clockwise:
      return "clockwise triangle";
    case FaultKind::duplicate_vertex:
      return "duplicate vertex";
    case FaultKind::unused_vertex:
      return "unused vertex";
    case FaultKind::duplicate_triangle:
      return "duplicate triangle";
    case FaultKind::non_manifold:
      return "non-manifold edge or vertex";
    case FaultKind::crossing:
      return "crossing edges";
    case FaultKind::overlap:
      return "overlapping triangles";
    case FaultKind::hole:
      return "hole";
  }
  return "unknown fault";
}

std::vector<Fault> find_faults(std::span<const Point2> points,
                               std::span<const std::array<std::uint32_t, 3>> triangles) {
  FaultLog log;
  CleanMesh mesh;
  mesh.points = points;
  mesh.given = triangles;
  std::vector<std::uint32_t> places = sorted_vertices(points);
  const std::vector<std::uint32_t> place = merge_places(points, places, log);
  mesh.hull_next = hull_successors(points, places);

  mesh.corners = keep_sound_triangles(mesh, log);
  std::vector<Side> sides = sorted_sides(mesh.corners);
  check_manifold(points.size(), mesh.corners, sides, log);
  if (places.size() < points.size()) {
    for (Corners& t : mesh.corners) t = {place[t[0]], place[t[1]], place[t[2]]};
    sides = sorted_sides(mesh.corners);
  }
  if (!find_border(sides, places.size(), mesh)) detail::search_faults(mesh, log);
  return std::move(log).take();
}

}  // namespace thalweg
