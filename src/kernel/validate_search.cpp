/// The search for crossings, overlaps and holes in a mesh that is known, or suspected, to be broken.
///
/// Boxes are swept by x; every pair that may touch is tested exactly. A mesh gets here only when its border
/// is not the hull or its triangles are at odds with each other, so this may take longer than the checks
/// before, but not for ever: a sweep stops after some number of steps, and what it has not met by then is not
/// reported. A broken mesh never passes for sound all the same: see the end.
#include <algorithm>
#include <numeric>
#include <utility>

#include "kernel/mesh_faults.hpp"
#include "kernel/predicates_inline.hpp"

namespace thalweg::detail {
namespace {

constexpr std::uint64_t kStepsOfTest = 32;  ///< what an exact test costs, in comparisons of two boxes

struct ItemBox {
  double min_x, max_x, min_y, max_y;
  std::uint32_t item;
};

template <class... Points>
ItemBox box_of(std::uint32_t item, Points... p) {
  return {std::min({p.x...}), std::max({p.x...}), std::min({p.y...}), std::max({p.y...}), item};
}

/// Calls visit(lower item, higher item) for pairs of touching boxes. Returns whether all were visited: it
/// stops when `visit` returns false or there have been too many steps.
template <class Visit>
bool sweep(std::vector<ItemBox> boxes, std::uint64_t most_steps, Visit&& visit) {
  std::sort(boxes.begin(), boxes.end(), [](const ItemBox& a, const ItemBox& b) {
    return a.min_x != b.min_x ? a.min_x < b.min_x : a.item < b.item;
  });
  std::uint64_t steps = 0;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const ItemBox a = boxes[i];
    std::size_t j = i + 1;
    for (; j < boxes.size() && boxes[j].min_x <= a.max_x; ++j) {
      const ItemBox& b = boxes[j];
      if (b.min_y > a.max_y || b.max_y < a.min_y) continue;
      if (!visit(std::min(a.item, b.item), std::max(a.item, b.item))) return false;
      steps += kStepsOfTest;
    }
    steps += j - i;
    if (steps > most_steps) return false;
  }
  return true;
}

class FaultSearch {
 public:
  FaultSearch(const CleanMesh& mesh, FaultLog& log, std::uint64_t most_steps)
      : mesh_(mesh), log_(log), most_steps_(most_steps) {}

  void find_crossings();
  void find_overlaps_and_holes();

 private:
  /// The place `at`, seen in the direction of `toward`, a little to its right (or left).
  struct Query {
    std::uint32_t at;
    std::uint32_t toward;
    bool right;
    std::uint32_t border;  ///< which border edge asks
    bool covered = false;
  };

  /// orient2d of places; the repeated ones that abound here need no arithmetic.
  int turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const noexcept {
    if (a == b || b == c || c == a) return 0;
    return orient2d_sign(mesh_.points[a], mesh_.points[b], mesh_.points[c]);
  }
  bool edges_cross(Edge e, Edge f) const noexcept;
  bool inside_edge(std::uint32_t v, Edge e) const noexcept;
  bool separated(const Corners& s, const Corners& t) const noexcept;
  bool covers(const Corners& t, const Query& q) const noexcept;
  void log_holes(const std::vector<Query>& queries);

  const CleanMesh& mesh_;
  FaultLog& log_;
  const std::uint64_t most_steps_;
};

bool FaultSearch::edges_cross(Edge e, Edge f) const noexcept {
  return turn(e.from, e.to, f.from) * turn(e.from, e.to, f.to) < 0 &&
         turn(f.from, f.to, e.from) * turn(f.from, f.to, e.to) < 0;
}

/// Requires: v in the closed box of e.
bool FaultSearch::inside_edge(std::uint32_t v, Edge e) const noexcept {
  return v != e.from && v != e.to && turn(e.from, e.to, v) == 0;
}

/// Whether a side of s has all of t on its right or on its line. Two convex polygons have disjoint interiors
/// if and only if this holds for a side of one of them.
bool FaultSearch::separated(const Corners& s, const Corners& t) const noexcept {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t u = s[i], v = s[(i + 1) % 3];
    if (turn(u, v, t[0]) <= 0 && turn(u, v, t[1]) <= 0 && turn(u, v, t[2]) <= 0) return true;
  }
  return false;
}

/// Whether t covers the points next to q.at in the direction q.toward turned by an infinitesimal angle,
/// clockwise if q.right.
bool FaultSearch::covers(const Corners& t, const Query& q) const noexcept {
  const int nudged = q.right ? -1 : 1;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t a = t[i], b = t[(i + 1) % 3], c = t[(i + 2) % 3];
    if (a == q.at) {
      const int from_b = turn(a, b, q.toward), from_c = turn(a, c, q.toward);
      return q.right ? from_b > 0 && from_c <= 0 : from_b >= 0 && from_c < 0;
    }
    if (b == q.at || c == q.at) continue;
    const int side = turn(a, b, q.at);
    if (side < 0) return false;
    if (side > 0) continue;
    // On the line of ab; if not between a and b, another side decides.
    int ahead = turn(a, b, q.toward);
    if (ahead == 0) {
      // Along ab, the left is inside; against it, the right. c tells which: it is left of ab.
      ahead = turn(q.at, q.toward, c) == nudged ? 1 : -1;
    }
    if (ahead < 0) return false;
  }
  return true;
}

void FaultSearch::find_crossings() {
  const auto edge_count = static_cast<std::uint32_t>(mesh_.edges.size());
  std::vector<std::uint32_t> places;
  for (const Edge e : mesh_.edges) {
    places.push_back(e.from);
    places.push_back(e.to);
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());

  std::vector<ItemBox> boxes;
  boxes.reserve(mesh_.edges.size() + places.size());
  for (std::uint32_t i = 0; i < edge_count; ++i) {
    boxes.push_back(box_of(i, mesh_.points[mesh_.edges[i].from], mesh_.points[mesh_.edges[i].to]));
  }
  for (std::uint32_t i = 0; i < places.size(); ++i) {
    boxes.push_back(box_of(edge_count + i, mesh_.points[places[i]]));
  }
  const auto ends = [&](Edge e) { return std::to_string(e.from) + " - " + std::to_string(e.to); };
  sweep(std::move(boxes), most_steps_, [&](std::uint32_t i, std::uint32_t j) {
    if (i >= edge_count) return true;
    const Edge e = mesh_.edges[i];
    if (j >= edge_count) {
      const std::uint32_t v = places[j - edge_count];
      if (inside_edge(v, e)) {
        log_.add(FaultKind::crossing,
                 [&] { return "vertex " + std::to_string(v) + " inside edge " + ends(e); });
      }
    } else if (edges_cross(e, mesh_.edges[j])) {
      log_.add(FaultKind::crossing, [&] { return "edges " + ends(e) + " and " + ends(mesh_.edges[j]); });
    }
    return !log_.full(FaultKind::crossing);
  });
}

/// A border edge off the hull has a hole on its right unless something covers it there. Both its ends are
/// asked, because a crossing may lie between. (A hole whose every corner is a crossing is logged as those
/// crossings only.)
void FaultSearch::find_overlaps_and_holes() {
  const auto triangle_count = static_cast<std::uint32_t>(mesh_.corners.size());
  std::vector<Query> queries;
  for (std::uint32_t i = 0; i < mesh_.border.size(); ++i) {
    const Edge e = mesh_.border[i];
    const std::uint32_t next = mesh_.hull_next[e.from];
    if (next != CleanMesh::kNoPlace && turn(e.from, next, e.to) == 0) continue;
    queries.push_back({e.from, e.to, true, i});
    queries.push_back({e.to, e.from, false, i});
  }

  std::vector<ItemBox> boxes;
  boxes.reserve(mesh_.corners.size() + queries.size());
  for (std::uint32_t i = 0; i < triangle_count; ++i) {
    const Corners& t = mesh_.corners[i];
    boxes.push_back(box_of(i, mesh_.points[t[0]], mesh_.points[t[1]], mesh_.points[t[2]]));
  }
  for (std::uint32_t i = 0; i < queries.size(); ++i) {
    boxes.push_back(box_of(triangle_count + i, mesh_.points[queries[i].at]));
  }
  const bool complete = sweep(std::move(boxes), most_steps_, [&](std::uint32_t i, std::uint32_t j) {
    if (i >= triangle_count) return true;
    const Corners& t = mesh_.corners[i];
    if (j >= triangle_count) {
      Query& q = queries[j - triangle_count];
      q.covered = q.covered || covers(t, q);
      return true;
    }
    if (!log_.full(FaultKind::overlap) && !separated(t, mesh_.corners[j]) &&
        !separated(mesh_.corners[j], t)) {
      log_.add(FaultKind::overlap, [&] {
        return triangle_text(mesh_.given, mesh_.names[i]) + " and " +
               triangle_text(mesh_.given, mesh_.names[j]);
      });
    }
    return !log_.full(FaultKind::overlap) || !queries.empty();
  });
  if (complete) log_holes(queries);
}

/// Border edges with common ends count as one hole.
void FaultSearch::log_holes(const std::vector<Query>& queries) {
  std::vector<Edge> open;
  for (std::size_t i = 0; i < queries.size(); i += 2) {
    if (!queries[i].covered || !queries[i + 1].covered) open.push_back(mesh_.border[queries[i].border]);
  }
  std::vector<std::uint32_t> parent(mesh_.points.size());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root = [&](std::uint32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const Edge e : open) parent[root(e.from)] = root(e.to);
  std::vector<std::uint32_t> size(parent.size(), 0);
  for (const Edge e : open) ++size[root(e.from)];
  for (const Edge e : open) {
    const std::uint32_t edges = std::exchange(size[root(e.from)], 0);
    if (edges == 0) continue;
    log_.add(FaultKind::hole, [&] {
      return "right of the edge " + std::to_string(e.from) + " -> " + std::to_string(e.to) + ", border of " +
             std::to_string(edges) + (edges == 1 ? " edge" : " edges");
    });
  }
}

}  // namespace

void search_faults(const CleanMesh& mesh, FaultLog& log, std::uint64_t most_steps) {
  FaultSearch search(mesh, log, most_steps);
  search.find_crossings();
  search.find_overlaps_and_holes();
  if (!log.empty()) return;
  // The steps ran out before a fault was met. Then some border edge is off the hull. For if the border is the
  // hull, all places are covered equally often, as often as the border goes around them; that is at least
  // twice, or there would be no fault, and then the very first triangle of the sweep meets another one over
  // it.
  for (const Edge e : mesh.border) {
    if (mesh.hull_next[e.from] == e.to) continue;
    log.add(FaultKind::hole, [&] {
      return "border edge " + std::to_string(e.from) + " -> " + std::to_string(e.to) + " off the hull";
    });
    return;
  }
}

}  // namespace thalweg::detail
