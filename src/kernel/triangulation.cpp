/// The packed half-edge triangulation: linking, edits, and the checker.
#include "thalweg/triangulation.hpp"

#include <algorithm>
#include <utility>

#include "kernel/assert.hpp"
#include "kernel/parallel.hpp"

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

/// Half-edges by their ends: those out of one vertex together, sorted by where they lead, so that a search
/// touches one short stretch of memory whatever the size of the triangulation. Complexity: O(m log d) for
/// degrees of at most d.
class HalfedgeIndex {
 public:
  struct Entry {
    VertexId to;
    HalfedgeId halfedge;
    friend auto operator<=>(const Entry&, const Entry&) = default;
  };

  /// Requires: all origins are less than vertex_count.
  HalfedgeIndex(const Triangulation& t, std::uint32_t vertex_count)
      : starts_(vertex_count + std::size_t{1}, 0), entries_(t.halfedge_count()) {
    for (std::uint32_t i = 0; i < t.halfedge_count(); ++i) {
      ++starts_[t.origin(HalfedgeId(i)).index() + std::size_t{1}];
    }
    for (std::uint32_t v = 0; v < vertex_count; ++v) starts_[v + std::size_t{1}] += starts_[v];
    std::vector<std::uint32_t> place(starts_.begin(), starts_.end() - 1);
    for (std::uint32_t i = 0; i < t.halfedge_count(); ++i) {
      const HalfedgeId h(i);
      entries_[place[t.origin(h).index()]++] = {t.dest(h), h};
    }
    for (std::uint32_t v = 0; v < vertex_count; ++v) {
      std::sort(entries_.begin() + starts_[v], entries_.begin() + starts_[v + std::size_t{1}]);
    }
  }

  std::span<const Entry> out_of(VertexId v) const noexcept {
    return std::span(entries_).subspan(starts_[v.index()],
                                       starts_[v.index() + std::size_t{1}] - starts_[v.index()]);
  }

  /// The half-edge from u to v; invalid if there is none.
  HalfedgeId find(VertexId u, VertexId v) const noexcept {
    const auto out = out_of(u);
    const auto it = std::lower_bound(out.begin(), out.end(), Entry{v, HalfedgeId(0)});
    return it != out.end() && it->to == v ? it->halfedge : HalfedgeId();
  }

  /// A half-edge that is not the only one with its ends; invalid if there is none.
  HalfedgeId find_repeated() const noexcept {
    for (std::uint32_t v = 0; v + std::size_t{1} < starts_.size(); ++v) {
      const auto out = out_of(VertexId(v));
      for (std::size_t i = 1; i < out.size(); ++i) {
        if (out[i - 1].to == out[i].to) return out[i].halfedge;
      }
    }
    return HalfedgeId();
  }

 private:
  std::vector<std::uint32_t> starts_;
  std::vector<Entry> entries_;
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

  const HalfedgeIndex index(result, vertex_count);
  if (index.find_repeated().valid()) return std::nullopt;
  for (std::uint32_t i = 0; i < result.halfedge_count(); ++i) {
    const HalfedgeId h(i);
    result.twin_[i] = index.find(result.dest(h), result.origin(h)).index();
  }
  result.set_outgoing();
  if (result.find_fault()) return std::nullopt;
  return result;
}

Triangulation Triangulation::from_arrays(std::span<const std::uint32_t> origin,
                                         std::span<const std::uint32_t> twin, std::uint32_t vertex_count) {
  Triangulation result;
  result.origin_.assign(origin.begin(), origin.end());
  result.twin_.assign(twin.begin(), twin.end());
  result.outgoing_.assign(vertex_count, kNone);
  result.set_outgoing();
  return result;
}

Triangulation detail::linked(Array<std::uint32_t> origin, Array<std::uint32_t> twin,
                             Array<std::uint32_t> outgoing) {
  Triangulation result;
  result.origin_ = std::move(origin);
  result.twin_ = std::move(twin);
  result.outgoing_ = std::move(outgoing);
  return result;
}

Triangulation Triangulation::revision_of(const Triangulation& base) {
  THALWEG_ASSERT(!base.is_revision());
  Triangulation result;
  result.base_ = &base;
  result.outgoing_ = base.outgoing_;
  result.pages_.assign((base.halfedge_count() + kPage - 1) / kPage, kShared);
  return result;
}

/// Where the numbers of h are in the arrays of a revision, which copies their page first.
std::size_t Triangulation::place_in_revision(HalfedgeId h) {
  std::uint32_t& page = pages_[h.index() / kPage];
  if (page == kShared) {
    const std::size_t begin = h.index() / kPage * std::size_t{kPage};
    const std::size_t end = std::min<std::size_t>(begin + kPage, halfedge_count());
    const std::size_t place = twin_.size();  // the array that grows last, should memory end between the two
    origin_.resize(place + kPage);
    twin_.resize(place + kPage);
    std::copy(base_->origin_.data() + begin, base_->origin_.data() + end, origin_.data() + place);
    std::copy(base_->twin_.data() + begin, base_->twin_.data() + end, twin_.data() + place);
    page = static_cast<std::uint32_t>(place / kPage);
  }
  return page * std::size_t{kPage} + h.index() % kPage;
}

/// Makes the numbers of h this revision's own, if h is valid. Edits do it for all that they will write before
/// they write anything: memory that ends then leaves the triangulation as it was.
void Triangulation::claim(HalfedgeId h) {
  if (h.valid()) own_place(h);
}

std::vector<FaceId> Triangulation::revised_faces() const {
  THALWEG_ASSERT(is_revision());
  std::vector<FaceId> faces;
  for (std::uint32_t i = 0; i < pages_.size(); ++i) {
    if (pages_[i] == kShared) continue;
    const std::uint32_t last = std::min(i * kPage + kPage, halfedge_count()) - 1;
    for (std::uint32_t f = i * kPage / 3; f <= last / 3; ++f) {
      if (faces.empty() || faces.back() < FaceId(f)) faces.emplace_back(f);
    }
  }
  return faces;
}

void Triangulation::take(Triangulation&& revision) {
  THALWEG_ASSERT(revision.base_ == this);
  for (std::size_t i = 0; i < revision.pages_.size(); ++i) {
    if (revision.pages_[i] == kShared) continue;
    const std::size_t begin = i * kPage, length = std::min<std::size_t>(kPage, halfedge_count() - begin);
    const std::size_t place = revision.pages_[i] * std::size_t{kPage};
    std::copy_n(revision.origin_.data() + place, length, origin_.data() + begin);
    std::copy_n(revision.twin_.data() + place, length, twin_.data() + begin);
  }
  outgoing_ = std::move(revision.outgoing_);
  revision = Triangulation();
}

bool operator==(const Triangulation& a, const Triangulation& b) noexcept {
  if (a.halfedge_count() != b.halfedge_count() || a.vertex_count() != b.vertex_count()) return false;
  if (!a.is_revision() && !b.is_revision()) return a.origin_ == b.origin_ && a.twin_ == b.twin_;
  for (std::uint32_t i = 0; i < a.halfedge_count(); ++i) {
    const HalfedgeId h(i);
    if (a.origin(h) != b.origin(h) || a.twin(h) != b.twin(h)) return false;
  }
  return true;
}

void Triangulation::set_outgoing() {
  for (std::uint32_t h = 0; h < halfedge_count(); ++h) {
    if (origin_[h] >= outgoing_.size() || h >= twin_.size()) continue;  // find_fault names it
    std::uint32_t& out = outgoing_[origin_[h]];
    if (out == kNone || twin_[h] == kNone) out = h;
  }
}

void Triangulation::link(HalfedgeId h, HalfedgeId twin) {
  set_twin(h, twin);
  if (twin.valid()) set_twin(twin, h);
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

HalfedgeId Triangulation::flip(HalfedgeId h) {
  THALWEG_ASSERT(!on_hull(h));
  const HalfedgeId bc_old = next(h), ca_old = prev(h);
  const HalfedgeId t = twin(h), ad_old = next(t), db_old = prev(t);
  const VertexId a = origin(h), b = origin(t), c = origin(ca_old), d = origin(db_old);
  const HalfedgeId bc = twin(bc_old), ca = twin(ca_old), ad = twin(ad_old), db = twin(db_old);
  if (is_revision()) {
    for (const HalfedgeId edited : {h, bc_old, ca_old, t, ad_old, db_old, bc, ca, ad, db}) claim(edited);
  }

  set_origin(h, d);  // h: d -> c, then c -> a, a -> d
  set_origin(bc_old, c);
  set_origin(ca_old, a);
  set_origin(t, c);  // t: c -> d, then d -> b, b -> c
  set_origin(ad_old, d);
  set_origin(db_old, b);
  link(bc_old, ca);
  link(ca_old, ad);
  link(ad_old, db);
  link(db_old, bc);

  // Each of the four corners may have pointed at a half-edge that has another origin now. On the hull it
  // points at the half-edge there, which has moved with it.
  const auto move_outgoing = [&](VertexId v, HalfedgeId from, HalfedgeId or_from, HalfedgeId to) {
    std::uint32_t& out = outgoing_[v.index()];
    if (out == from.index() || out == or_from.index()) out = to.index();
  };
  move_outgoing(a, h, ad_old, ca_old);
  move_outgoing(b, t, bc_old, db_old);
  move_outgoing(c, ca_old, ca_old, bc_old);
  move_outgoing(d, db_old, db_old, ad_old);
  return h;
}

/// Points `outgoing` of the corners of edited faces back at half-edges that leave them. A hull vertex whose
/// hull half-edge lies in another face still points there, because that slot was not edited.
void Triangulation::settle_outgoing(std::span<const FaceId> faces) noexcept {
  for (const FaceId f : faces) {
    for (std::uint32_t corner = 0; corner < 3; ++corner) {
      const HalfedgeId h = halfedge(f, corner);
      std::uint32_t& out = outgoing_[origin(h).index()];
      if (origin(HalfedgeId(out)) != origin(h)) out = h.index();
    }
  }
  for (const FaceId f : faces) {
    for (std::uint32_t corner = 0; corner < 3; ++corner) {
      const HalfedgeId h = halfedge(f, corner);
      if (on_hull(h)) outgoing_[origin(h).index()] = h.index();
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
      fresh.push_back({news[i][corner], news[i][(corner + 1) % 3], halfedge(olds[i], corner)});
    }
  }
  std::sort(fresh.begin(), fresh.end());
  if (is_revision()) {
    for (const DirectedEdge& e : fresh) claim(e.halfedge);
    for (const DirectedEdge& e : border) claim(e.halfedge);
  }
  for (const DirectedEdge& e : fresh) set_origin(e.halfedge, e.from);

  const auto find = [](const std::vector<DirectedEdge>& edges, VertexId from, VertexId to) {
    const auto it = std::lower_bound(edges.begin(), edges.end(), DirectedEdge{from, to, HalfedgeId(0)});
    return it != edges.end() && it->from == from && it->to == to ? &*it : nullptr;
  };
  for (const DirectedEdge& e : fresh) {
    // A new twin goes first: an edge that dangles into the region has both its sides within.
    if (const DirectedEdge* twin = find(fresh, e.to, e.from)) {
      set_twin(e.halfedge, twin->halfedge);
    } else {
      const DirectedEdge* outer = find(border, e.from, e.to);
      THALWEG_ASSERT(outer != nullptr);
      link(e.halfedge, outer->halfedge);
    }
  }
  settle_outgoing(olds);
}

Triangulation Triangulation::renamed(std::span<const std::uint32_t> names, std::uint32_t vertex_count,
                                     unsigned threads) && {
  THALWEG_ASSERT(!is_revision() && names.size() == this->vertex_count());
  Triangulation result;
  result.outgoing_ = Numbers(vertex_count);
  if (names.size() < vertex_count) std::fill(result.outgoing_.begin(), result.outgoing_.end(), kNone);
  detail::parallel_for(names.size(), threads,
                       [&](std::size_t v) { result.outgoing_[names[v]] = outgoing_[v]; });
  detail::parallel_for(origin_.size(), threads, [&](std::size_t h) { origin_[h] = names[origin_[h]]; });
  result.origin_ = std::move(origin_);
  result.twin_ = std::move(twin_);
  return result;
}

std::optional<std::string> Triangulation::find_fault() const {
  const std::uint32_t count = halfedge_count();
  if (twin_.size() != origin_.size() || count % 3 != 0) return "arrays of half-edges differ in length";

  for (std::uint32_t i = 0; i < count; ++i) {
    const HalfedgeId h(i);
    if (origin(h).index() >= vertex_count())
      return "half-edge " + std::to_string(i) + " has an origin out of range";
    if (origin(h) == dest(h)) return "face " + std::to_string(i / 3) + " repeats a vertex";
  }
  const HalfedgeIndex index(*this, vertex_count());
  if (const HalfedgeId h = index.find_repeated(); h.valid()) {
    return "edge " + edge_text(origin(h), dest(h)) + " occurs twice";
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    const HalfedgeId h(i);
    if (twin(h) != index.find(dest(h), origin(h)))
      return "edge " + edge_text(origin(h), dest(h)) + " has the wrong twin";
  }
  for (std::uint32_t i = 0; i < vertex_count(); ++i) {
    const VertexId v(i);
    const HalfedgeId first = outgoing(v);
    const std::size_t degree = index.out_of(v).size();
    if (!first.valid() && degree == 0) continue;
    if (first.index() >= count || origin(first) != v) {
      return "vertex " + std::to_string(i) + " has a wrong outgoing half-edge";
    }
    std::size_t met = 0;
    HalfedgeId h = first;
    do {
      ++met;
      h = turn_ccw(h);
    } while (h.valid() && h != first && met <= degree);
    if (!h.valid() && !on_hull(first)) {
      return "vertex " + std::to_string(i) + " is on the hull, but its outgoing half-edge is not";
    }
    if (met != degree) return "the faces at vertex " + std::to_string(i) + " are not one fan";
  }
  return std::nullopt;
}

}  // namespace thalweg
