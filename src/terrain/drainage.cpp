/// Flow paths: the steepest edge at each vertex, breadth first across flats, then once along every path.
#include "thalweg/drainage.hpp"

#include <algorithm>
#include <cmath>

#include "kernel/assert.hpp"

namespace thalweg {
namespace {

constexpr std::uint32_t kUnreached = 0xffffffffu;

class Flow {
 public:
  Flow(const Triangulation& terrain, std::span<const Point3> points)
      : terrain_(terrain), points_(points), steps_(points.size(), kUnreached) {
    result_.downstream.resize(points.size());
    result_.sink.resize(points.size());
  }

  Drainage run() && {
    for (std::uint32_t v = 0; v < points_.size(); ++v) {
      if (!terrain_.isolated(VertexId(v))) choose_steepest(VertexId(v));
    }
    for (std::uint32_t v = 0; v < points_.size(); ++v) {
      if (terrain_.isolated(VertexId(v)) || result_.downstream[v].valid() || steps_[v] != kUnreached)
        continue;
      cross_flat(VertexId(v));
    }
    follow_paths();
    return std::move(result_);
  }

 private:
  const Point3& at(VertexId v) const { return points_[v.index()]; }

  bool lower(VertexId u, VertexId v) const {
    const Point3 &p = at(u), &q = at(v);
    if (p.z != q.z) return p.z < q.z;
    return p.x != q.x ? p.x < q.x : p.y < q.y;
  }

  void choose_steepest(VertexId v) {
    VertexId best;
    terrain_.for_each_neighbor(v, [&](VertexId w) {
      if (!(at(w).z < at(v).z)) return;
      const int side = best.valid() ? compare_steepness(at(v), at(w), at(best)) : 1;
      if (side > 0 || (side == 0 && lower(w, best))) best = w;
    });
    result_.downstream[v.index()] = best;
  }

  /// Decides for all vertices of the flat of v that have no lower neighbour. Requires: v is one, undecided.
  void cross_flat(VertexId v) {
    flood(v);
    queue_.clear();
    VertexId first = v;
    for (const VertexId w : flat_) {
      if (result_.downstream[w.index()].valid()) queue_.push_back(w);
      if (lower(w, first)) first = w;
    }
    if (queue_.empty()) {
      queue_.push_back(first);
      ++result_.basins;
    }
    for (const VertexId w : queue_) steps_[w.index()] = 0;
    for (std::size_t head = 0; head < queue_.size(); ++head) {
      const VertexId u = queue_[head];
      terrain_.for_each_neighbor(u, [&](VertexId w) {
        if (at(w).z != at(u).z || steps_[w.index()] < kUnreached - 1) return;
        steps_[w.index()] = steps_[u.index()] + 1;
        queue_.push_back(w);
      });
    }
    // Only now are all steps known: whichever vertex reached w first in the queue depends on their numbers.
    for (const VertexId w : queue_) {
      if (steps_[w.index()] > 0) choose_nearer(w);
    }
  }

  /// All vertices of the flat of v into flat_, marked as seen but without steps.
  void flood(VertexId v) {
    flat_.assign(1, v);
    steps_[v.index()] = kUnreached - 1;
    for (std::size_t head = 0; head < flat_.size(); ++head) {
      terrain_.for_each_neighbor(flat_[head], [&](VertexId w) {
        if (at(w).z != at(v).z || steps_[w.index()] != kUnreached) return;
        steps_[w.index()] = kUnreached - 1;
        flat_.push_back(w);
      });
    }
  }

  void choose_nearer(VertexId w) {
    VertexId best;
    terrain_.for_each_neighbor(w, [&](VertexId u) {
      if (at(u).z != at(w).z || steps_[u.index()] + 1 != steps_[w.index()]) return;
      if (!best.valid() || lower(u, best)) best = u;
    });
    result_.downstream[w.index()] = best;
  }

  /// Sinks, and the longest path. Every vertex is put on the stack once.
  void follow_paths() {
    std::vector<double> length(points_.size(), 0);
    std::vector<std::uint32_t> edges(points_.size(), 0);
    std::vector<VertexId> path;
    for (std::uint32_t start = 0; start < points_.size(); ++start) {
      if (terrain_.isolated(VertexId(start))) continue;
      for (VertexId v(start); !result_.sink[v.index()].valid();) {
        const VertexId next = result_.downstream[v.index()];
        if (!next.valid()) {
          result_.sink[v.index()] = v;
          break;
        }
        path.push_back(v);
        v = next;
      }
      for (; !path.empty(); path.pop_back()) {
        const std::uint32_t v = path.back().index(), next = result_.downstream[v].index();
        result_.sink[v] = result_.sink[next];
        edges[v] = edges[next] + 1;
        length[v] = length[next] + distance(points_[v], points_[next]);
      }
      const std::uint32_t longest = result_.longest_from.index();
      if (!result_.longest_from.valid() || length[start] > length[longest] ||
          (length[start] == length[longest] && lower(VertexId(start), result_.longest_from)))
        result_.longest_from = VertexId(start);
    }
    if (!result_.longest_from.valid()) return;
    result_.longest_edges = edges[result_.longest_from.index()];
    result_.longest_length = length[result_.longest_from.index()];
  }

  /// By operations that IEEE 754 defines to the last bit, and without overflow before the result has it.
  static double distance(const Point3& p, const Point3& q) {
    const double dx = std::fabs(0.5 * p.x - 0.5 * q.x), dy = std::fabs(0.5 * p.y - 0.5 * q.y);
    const double longer = std::max(dx, dy);
    if (longer == 0) return 0;
    const double ratio = std::min(dx, dy) / longer;
    return 2 * (longer * std::sqrt(1 + ratio * ratio));
  }

  const Triangulation& terrain_;
  std::span<const Point3> points_;
  std::vector<std::uint32_t> steps_;  // edges to the way out of the flat; kUnreached - 1: seen
  std::vector<VertexId> flat_, queue_;
  Drainage result_;
};

}  // namespace

Drainage drain(const Triangulation& terrain, std::span<const Point3> points) {
  THALWEG_ASSERT(points.size() == terrain.vertex_count());
  return Flow(terrain, points).run();
}

}  // namespace thalweg
