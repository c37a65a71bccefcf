/// Growing triangles of order <= k from required edges, with backtracking.
#include "terrain/completion.hpp"

#include <algorithm>

#include "kernel/assert.hpp"
#include "kernel/edge_insertion.hpp"
#include "kernel/predicates_inline.hpp"
#include "order/sleeve_search.hpp"
#include "terrain/changes.hpp"
#include "terrain/crossings.hpp"

namespace thalweg::detail {

Completion::Completion(const Surface& surface, unsigned k)
    : surface_(&surface), k_(k), counter_(surface.graph()) {}

const std::vector<VertexId>& Completion::partners(VertexId v) {
  const auto emplaced = partners_.try_emplace(v.index());
  std::vector<VertexId>& partners = emplaced.first->second;
  if (emplaced.second) {
    unsigned limit = k_;
    SleeveSearch(surface_->graph(), counter_)
        .run(
            v, limit, [](VertexId) { return true; },
            [&](VertexId q, unsigned) {
              partners.push_back(q);
              return false;
            });
    std::sort(partners.begin(), partners.end());
  }
  return partners;
}

Completion::Answer Completion::find(std::span<const RequiredEdge> edges, std::uint64_t budget,
                                    const Watch& watch) {
  edges_.clear();
  for (const RequiredEdge& edge : edges) {
    if (!has_edge(edge.u, edge.v)) edges_.push_back(std::minmax(edge.u, edge.v));
  }
  if (!insert_all(edges)) return Answer::impossible;
  if (is_of_order()) return Answer::found;
  const Answer answer = grow(budget, watch);
  if (answer != Answer::found) return answer;
  // A placed triangle holds no site, so with its sides in place it is a face; beyond the region all
  // constraints are Delaunay edges, and the constrained Delaunay triangulation there is the Delaunay
  // triangulation.
  std::vector<RequiredEdge> all;
  for (const auto& [u, v] : edges_) all.push_back({u, v});
  const bool complete = insert_all(all) && is_of_order();
  THALWEG_ASSERT(complete);
  return complete ? Answer::found : Answer::unknown;
}

/// Makes triangulation_ the constrained Delaunay triangulation with these edges; false if one of them crosses
/// a site.
bool Completion::insert_all(std::span<const RequiredEdge> edges) {
  triangulation_ = Triangulation::revision_of(surface_->delaunay());
  EdgeInsertion insertion;
  for (const RequiredEdge& edge : edges) {
    if (triangulation_.joined(edge.u, edge.v)) continue;
    if (!insertion.plan(triangulation_, surface_->sites(), edge.u, edge.v)) return false;
    insertion.apply(triangulation_);
  }
  return true;
}

bool Completion::is_of_order() {
  const auto changed = changed_faces(*surface_, triangulation_);
  return std::all_of(changed.begin(), changed.end(),
                     [&](FaceId f) { return counter_.order_at_most(k_, triangulation_.corners(f)); });
}

Completion::Answer Completion::grow(std::uint64_t budget, const Watch& watch) {
  triangles_.clear();
  std::vector<Decision> decisions;
  for (std::uint64_t steps = 0;; ++steps) {
    if (steps >= budget || watch.stopped()) return Answer::unknown;
    std::optional<Decision> side = tightest_open_side();
    if (!side) return Answer::found;
    decisions.push_back(*std::move(side));
    // Back to the last decision that has an alternative left.
    while (decisions.back().next == decisions.back().apexes.size()) {
      decisions.pop_back();
      if (decisions.empty()) return Answer::impossible;
      remove(decisions.back());
    }
    Decision& decision = decisions.back();
    place(decision, decision.apexes[decision.next++]);
  }
}

/// The open side with the fewest triangles that fit; nothing if no side is open.
std::optional<Completion::Decision> Completion::tightest_open_side() {
  std::optional<Decision> best;
  for (const auto& [u, v] : edges_) {
    if (surface_->delaunay().joined(u, v)) continue;
    for (const Edge& side : {Edge(u, v), Edge(v, u)}) {
      if (has_triangle_at(side.first, side.second)) continue;
      std::vector<VertexId> apexes = apexes_at(side);
      if (best && best->apexes.size() <= apexes.size()) continue;
      best = Decision{side, std::move(apexes), 0, edges_.size()};
      if (best->apexes.empty()) return best;
    }
  }
  return best;
}

/// The apexes of all triangles of order <= k left of the side that fit into the region as it is.
std::vector<VertexId> Completion::apexes_at(const Edge& side) {
  const VertexId u = side.first, v = side.second;
  std::vector<VertexId> common, apexes;
  const std::vector<VertexId>& of_u = partners(u);
  const std::vector<VertexId>& of_v = partners(v);
  std::set_intersection(of_u.begin(), of_u.end(), of_v.begin(), of_v.end(), std::back_inserter(common));
  for (const VertexId w : common) {
    if (orient2d_sign(at(u), at(v), at(w)) <= 0) continue;
    if (counter_.count_in_circle(u, v, w, k_) > k_) continue;
    // No site lies on a side of it, its sides having a useful order; one inside it is inside its circle.
    const auto inside = counter_.inside();
    const bool is_empty = std::none_of(inside.begin(), inside.end(), [&](VertexId s) {
      return orient2d_sign(at(u), at(v), at(s)) > 0 && orient2d_sign(at(v), at(w), at(s)) > 0 &&
             orient2d_sign(at(w), at(u), at(s)) > 0;
    });
    if (is_empty && fits(u, w) && fits(v, w)) apexes.push_back(w);
  }
  return apexes;
}

/// Whether the pair crosses no edge of the region. Different empty triangles whose sides do not cross cannot
/// share area. Not even two on the same side of a common edge vw, with apexes u and x: neither apex is inside
/// the other triangle, so x is beyond uv alone or beyond uw alone, as seen from inside, and wx crosses uv, or
/// vx crosses uw.
bool Completion::fits(VertexId u, VertexId v) {
  return std::none_of(edges_.begin(), edges_.end(),
                      [&](const Edge& e) { return cross_properly(at(u), at(v), at(e.first), at(e.second)); });
}

bool Completion::has_edge(VertexId u, VertexId v) const {
  return std::find(edges_.begin(), edges_.end(), Edge(std::minmax(u, v))) != edges_.end();
}

bool Completion::has_triangle_at(VertexId u, VertexId v) const {
  return std::any_of(triangles_.begin(), triangles_.end(), [&](const Triangle& t) {
    return (t[0] == u && t[1] == v) || (t[1] == u && t[2] == v) || (t[2] == u && t[0] == v);
  });
}

void Completion::place(const Decision& decision, VertexId apex) {
  const auto [u, v] = decision.side;
  triangles_.push_back({u, v, apex});
  for (const VertexId end : {u, v}) {
    if (!has_edge(end, apex)) edges_.push_back(std::minmax(end, apex));
  }
}

void Completion::remove(const Decision& decision) {
  triangles_.pop_back();
  edges_.resize(decision.edges_before);
}

}  // namespace thalweg::detail
