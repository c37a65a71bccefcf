/// The packed half-edge triangulation: linking, edits, and the checker.
#include "thalweg/triangulation.hpp"

#include <algorithm>
#include <utility>

#include "kernel/assert.hpp"

namespace thalweg {
namespace {

constexpr std::uint32_t kNone = HalfedgeId::kInvalid;

/// A half-edge with its ends, to be sorted so that the two directions of an edge meet.
struct DirectedEdge {
  VertexId from;
  VertexId to;
  HalfedgeId halfedge;
  friend auto operator<=>(const DirectedEdge&, const DirectedEdge&) = default;
};

std::string edge_text(VertexId u, VertexId v) {
  return std::to_string(u.index()) + " -> " + std::to_string(v.index());
}

}  // namespace

std::optional<Triangulation> Triangulation::from_triangles(std::span<const Triangle> triangles,
                                                           std::uint32_t vertex_count) {
  Triangulation result;
  result.origin_.reserve(3 * triangles.size());
  for (const Triangle& t : triangles) {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return std::nullopt;
    for (const VertexId v : t) {
      if (v.index() >= vertex_count) return std::nullopt;
      result.origin_.push_back(v.index());
    }
  }
  result.twin_.assign(result.origin_.size(), kNone);
  result.outgoing_.assign(vertex_count, kNone);

  std::vector<DirectedEdge> edges;
  edges.reserve(result.origin_.size());
  for (std::uint32_t i = 0; i < result.halfedge_count(); ++i) {
    const HalfedgeId h(i);
    edges.push_back({result.origin(h), result.dest(h), h});
  }
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const DirectedEdge& e = edges[i];
    if (i > 0 && edges[i - 1].from == e.from && edges[i - 1].to == e.to) return std::nullopt;
    if (e.from > e.to) continue;
    const auto twin = std::lower_bound(edges.begin(), edges.end(), DirectedEdge{e.to, e.from, HalfedgeId(0)});
    if (twin != edges.end() && twin->from == e.to && twin->to == e.from) {
      result.link(e.halfedge, twin->halfedge);
    }
  }
  result.set_outgoing();
  if (result.find_fault()) return std::nullopt;
  return result;
}

Triangulation Triangulation::from_arrays(std::vector<std::uint32_t> origin, std::vector<std::uint32_t> twin,
                                         std::uint32_t vertex_count) {
  Triangulation result;
  result.origin_ = std::move(origin);
  result.twin_ = std::move(twin);
  result.outgoing_.assign(vertex_count, kNone);
  result.set_outgoing();
  return result;
}

void Triangulation::set_outgoing() {
  for (std::uint32_t h = 0; h < halfedge_count(); ++h) {
    if (origin_[h] >= outgoing_.size() || h >= twin_.size()) continue;  // find_fault names it
    std::uint32_t& out = outgoing_[origin_[h]];
    if (out == kNone || twin_[h] == kNone) out = h;
  }
}

void Triangulation::link(HalfedgeId h, HalfedgeId twin) noexcept {
  twin_[h.index()] = twin.index();
  if (twin.valid()) twin_[twin.index()] = h.index();
}

HalfedgeId Triangulation::find_halfedge(VertexId u, VertexId v) const noexcept {
  const HalfedgeId first = outgoing(u);
  for (HalfedgeId h = first; h.valid();) {
    if (dest(h) == v) return h;
    h = turn_ccw(h);
    if (h == first) break;
  }
  return HalfedgeId();
}

bool Triangulation::joined(VertexId u, VertexId v) const noexcept {
  return find_halfedge(u, v).valid() || find_halfedge(v, u).valid();
}

HalfedgeId Triangulation::flip(HalfedgeId h) noexcept {
  THALWEG_ASSERT(!on_hull(h));
  const HalfedgeId bc_old = next(h), ca_old = prev(h);
  const HalfedgeId t = twin(h), ad_old = next(t), db_old = prev(t);
  const VertexId a = origin(h), b = origin(t), c = origin(ca_old), d = origin(db_old);
  const HalfedgeId bc = twin(bc_old), ca = twin(ca_old), ad = twin(ad_old), db = twin(db_old);

  origin_[h.index()] = d.index();  // h: d -> c, then c -> a, a -> d
  origin_[bc_old.index()] = c.index();
  origin_[ca_old.index()] = a.index();
  origin_[t.index()] = c.index();  // t: c -> d, then d -> b, b -> c
  origin_[ad_old.index()] = d.index();
  origin_[db_old.index()] = b.index();
  link(bc_old, ca);
  link(ca_old, ad);
  link(ad_old, db);
  link(db_old, bc);

  const FaceId faces[] = {face(h), face(t)};
  settle_outgoing(faces);
  return h;
}

/// Points `outgoing` of the corners of edited faces back at half-edges that leave them. A hull vertex whose
/// hull half-edge lies in another face still points there, because that slot was not edited.
void Triangulation::settle_outgoing(std::span<const FaceId> faces) noexcept {
  for (const FaceId f : faces) {
    for (std::uint32_t corner = 0; corner < 3; ++corner) {
      const HalfedgeId h = halfedge(f, corner);
      std::uint32_t& out = outgoing_[origin_[h.index()]];
      if (origin_[out] != origin_[h.index()]) out = h.index();
    }
  }
  for (const FaceId f : faces) {
    for (std::uint32_t corner = 0; corner < 3; ++corner) {
      const HalfedgeId h = halfedge(f, corner);
      if (on_hull(h)) outgoing_[origin_[h.index()]] = h.index();
    }
  }
}

void Triangulation::replace(std::span<const FaceId> olds, std::span<const Triangle> news) {
  THALWEG_ASSERT(olds.size() == news.size());
  std::vector<FaceId> inside(olds.begin(), olds.end());
  std::sort(inside.begin(), inside.end());
  const auto is_inside = [&](HalfedgeId h) {
    return std::binary_search(inside.begin(), inside.end(), face(h));
  };

  // The region's border as it is seen from within: each directed edge with the half-edge outside (invalid on
  // the hull).
  std::vector<DirectedEdge> border;
  for (const FaceId f : olds) {
    for (std::uint32_t corner = 0; corner < 3; ++corner) {
      const HalfedgeId h = halfedge(f, corner), outer = twin(h);
      if (!outer.valid() || !is_inside(outer)) border.push_back({origin(h), dest(h), outer});
    }
  }
  std::sort(border.begin(), border.end());

  std::vector<DirectedEdge> fresh;
  for (std::size_t i = 0; i < olds.size(); ++i) {
    for (std::uint32_t corner = 0; corner < 3; ++corner) {
      const HalfedgeId h = halfedge(olds[i], corner);
      origin_[h.index()] = news[i][corner].index();
      fresh.push_back({news[i][corner], news[i][(corner + 1) % 3], h});
    }
  }
  std::sort(fresh.begin(), fresh.end());

  const auto find = [](const std::vector<DirectedEdge>& edges, VertexId from, VertexId to) {
    const auto it = std::lower_bound(edges.begin(), edges.end(), DirectedEdge{from, to, HalfedgeId(0)});
    return it != edges.end() && it->from == from && it->to == to ? &*it : nullptr;
  };
  for (const DirectedEdge& e : fresh) {
    // A new twin goes first: an edge that dangles into the region has both its sides within.
    if (const DirectedEdge* twin = find(fresh, e.to, e.from)) {
      twin_[e.halfedge.index()] = twin->halfedge.index();
    } else {
      const DirectedEdge* outer = find(border, e.from, e.to);
      THALWEG_ASSERT(outer != nullptr);
      link(e.halfedge, outer->halfedge);
    }
  }
  settle_outgoing(olds);
}

Triangulation Triangulation::renamed(std::span<const std::uint32_t> names, std::uint32_t vertex_count) && {
  THALWEG_ASSERT(names.size() == this->vertex_count());
  Triangulation result;
  result.outgoing_.assign(vertex_count, kNone);
  for (std::size_t v = 0; v < names.size(); ++v) result.outgoing_[names[v]] = outgoing_[v];
  result.origin_ = std::move(origin_);
  for (std::uint32_t& v : result.origin_) v = names[v];
  result.twin_ = std::move(twin_);
  return result;
}

std::optional<std::string> Triangulation::find_fault() const {
  const std::uint32_t count = halfedge_count();
  if (twin_.size() != origin_.size() || count % 3 != 0) return "arrays of half-edges differ in length";

  std::vector<std::uint32_t> degree(vertex_count(), 0);
  std::vector<DirectedEdge> edges;
  edges.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const HalfedgeId h(i);
    if (origin_[i] >= vertex_count()) return "half-edge " + std::to_string(i) + " has an origin out of range";
    if (origin(h) == dest(h)) return "face " + std::to_string(i / 3) + " repeats a vertex";
    ++degree[origin_[i]];
    edges.push_back({origin(h), dest(h), h});
  }
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 1; i < edges.size(); ++i) {
    if (edges[i - 1].from == edges[i].from && edges[i - 1].to == edges[i].to) {
      return "edge " + edge_text(edges[i].from, edges[i].to) + " occurs twice";
    }
  }
  for (const DirectedEdge& e : edges) {
    const HalfedgeId t = twin(e.halfedge);
    const auto other =
        std::lower_bound(edges.begin(), edges.end(), DirectedEdge{e.to, e.from, HalfedgeId(0)});
    const bool exists = other != edges.end() && other->from == e.to && other->to == e.from;
    if (t != (exists ? other->halfedge : HalfedgeId())) {
      return "edge " + edge_text(e.from, e.to) + " has the wrong twin";
    }
  }
  for (std::uint32_t i = 0; i < vertex_count(); ++i) {
    const VertexId v(i);
    const HalfedgeId first = outgoing(v);
    if (!first.valid() && degree[i] == 0) continue;
    if (first.index() >= count || origin(first) != v) {
      return "vertex " + std::to_string(i) + " has a wrong outgoing half-edge";
    }
    std::uint32_t met = 0;
    HalfedgeId h = first;
    do {
      ++met;
      h = turn_ccw(h);
    } while (h.valid() && h != first && met <= degree[i]);
    if (!h.valid() && !on_hull(first)) {
      return "vertex " + std::to_string(i) + " is on the hull, but its outgoing half-edge is not";
    }
    if (met != degree[i]) return "the faces at vertex " + std::to_string(i) + " are not one fan";
  }
  return std::nullopt;
}

}  // namespace thalweg
