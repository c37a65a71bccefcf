/// Ways for edges across, and the rise in pieces.
#include "kernel/seam_split.hpp"

#include <cstddef>

#include "kernel/parallel.hpp"
#include "kernel/predicates_inline.hpp"

namespace thalweg::detail {
namespace {

using Index = std::uint32_t;

/// A word of the slot of a half-edge that nothing else uses.
constexpr Index spare_of(Index h) noexcept {
  return h | 3;
}

}  // namespace

/// The half-edge that leaves a site to the right of the way to a target, which no edge of the site follows:
/// its face is the triangle that the way enters, or if it leaves the hull there, that of a ghost, and it goes
/// to the ghost. kGhost if the site is not found.
Index SeamSplit::facing(Index site, Index target) const noexcept {
  const Index first = halfedge_near(mesh_, parts_, site);
  if (first == kGhost) return kGhost;
  const Point2 p = mesh_.at(site), q = mesh_.at(target);
  const auto side = [&](Index v) { return orient2d_sign(p, mesh_.at(v), q); };
  Index g = first;
  do {
    const Index u = mesh_.dest(g);
    const bool outside = mesh_.apex(g) == kGhost;
    const Index next = outside ? mesh_.around(g) : kGhost;
    const Index v = outside ? mesh_.apex(next) : mesh_.apex(g);
    if (u != kGhost && v != kGhost) {
      // Between u and v, counter-clockwise; the angle is less than a half turn, or more, or all around.
      const int turn = u == v ? -1 : orient2d_sign(p, mesh_.at(u), mesh_.at(v));
      const bool between = turn > 0    ? side(u) > 0 && side(v) < 0
                           : turn == 0 ? side(u) > 0
                                       : u == v || !(side(v) > 0 && side(u) < 0);
      if (between) return outside ? next : g;
    }
    g = mesh_.around(g);
  } while (g != first);
  return kGhost;
}

/// Removes the triangles of a site's part between the site and a target in the other part, from the hull
/// inwards. `exits` is for the edges on the way.
void SeamSplit::open_way(Index site, Index target, std::vector<Index>& exits) const {
  const Index enters = facing(site, target);
  if (enters == kGhost || mesh_.dest(enters) == kGhost) return;
  const Point2 p = mesh_.at(site), q = mesh_.at(target);
  exits.clear();
  for (Index exit = next_of(enters);;) {
    exits.push_back(exit);
    const Index entry = mesh_.twin(exit), v = mesh_.apex(entry);
    if (v == kGhost) break;
    exit = orient2d_sign(p, q, mesh_.at(v)) > 0 ? next_of(entry) : prev_of(entry);
  }
  for (auto exit = exits.rbegin(); exit != exits.rend(); ++exit) {
    if (parts_.in_left(site)) {
      open_left(mesh_, mesh_.twin(*exit));
    } else {
      open_right(mesh_, mesh_.twin(*exit));
    }
  }
}

void SeamSplit::open() {
  const std::vector<EdgeAcross> edges = edges_across(mesh_, parts_);
  if (edges.size() < least_edges_) return;
  parallel_chunks(2, 1, threads_, [&] {
    return [&, exits = std::vector<Index>()](std::size_t part, std::size_t) mutable {
      // From the top down, since parts often fan out from the lower tangent; the other order takes longer
      // there.
      for (auto e = edges.rbegin(); e != edges.rend(); ++e)
        part == 0 ? open_way(e->left, e->right, exits) : open_way(e->right, e->left, exits);
    };
  });
  for (const EdgeAcross& e : edges) {
    const Index of_left = facing(e.left, e.right), of_right = facing(e.right, e.left);
    if (of_left == kGhost || of_right == kGhost) continue;
    const Index left = prev_of(of_left), right = next_of(mesh_.twin(of_right));
    // Of two edges one after the other at least one side differs, so no two pieces have the same word.
    const bool left_again = !starts_.empty() && starts_.back().left == left;
    starts_.push_back({e.left, e.right, left, right, spare_of(left_again ? right : left)});
  }
}

/// A piece begins with a word of its own for what is below, since that comes to be meanwhile; the first
/// triangle of the piece is linked to it, and then to what is there in the end.
///
/// A part all of whose hull faces the other has the lower tangent and the upper one in the same corner, where
/// nothing tells edges at the bottom of the seam from those at its top: edges in a corner of the lower
/// tangent start no piece.
Seam SeamSplit::rise(const Seam& seam) {
  std::erase_if(starts_, [&](const Seam& s) { return s.left == seam.left || s.right == seam.right; });
  std::vector<Seam> pieces = {seam};
  pieces.insert(pieces.end(), starts_.begin(), starts_.end());
  starts_.push_back({kGhost, kGhost, kGhost, kGhost, kGhost});  // where the last piece ends: nowhere
  parallel_chunks(pieces.size(), 1, threads_, [&] {
    return [&](std::size_t i, std::size_t) {
      pieces[i] = risen_to(mesh_, pieces[i], starts_[i].left, starts_[i].right);
    };
  });
  Seam result = pieces.back();
  Index below = pieces.front().below;
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    const Index spare = starts_[i - 1].below;
    if (pieces[i].below == spare) continue;  // nothing came above this edge
    mesh_.link(mesh_.twin(spare), below);
    below = pieces[i].below;
  }
  result.below = below;
  return result;
}

}  // namespace thalweg::detail
