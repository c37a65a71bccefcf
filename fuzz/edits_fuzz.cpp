/// Edits of a triangulation of hostile points: flips, and edges that are inserted and taken back, on a copy
/// and on a revision of the same base. Both stay equal and sound, the triangles turn left and cover the hull,
/// inserted edges are there, undone ones leave what was before. Which edits follows from the first two bytes.
#include <vector>

#include "kernel/edge_insertion.hpp"
#include "mesh.hpp"
#include "support/random.hpp"
#include "thalweg/validate.hpp"

namespace {

using thalweg::FaceId;
using thalweg::HalfedgeId;
using thalweg::Point2;
using thalweg::Triangulation;
using thalweg::VertexId;
using thalweg::detail::EdgeInsertion;

/// A copy and a revision of one base, which every edit is done to.
struct Twins {
  Triangulation copy, revision;

  void check_equal(const std::vector<Point2>& sites) const {
    fuzz::check(copy == revision && revision == copy, "a revision equals the edited copy", sites);
  }
};

void flip(Twins& twins, const std::vector<Point2>& sites, HalfedgeId h) {
  if (!fuzz::flippable(twins.copy, sites, h)) return;
  const VertexId c = twins.copy.apex(h), d = twins.copy.apex(twins.copy.twin(h));
  const HalfedgeId flipped = twins.copy.flip(h);
  fuzz::check(flipped == twins.revision.flip(h), "a flip of a revision gives the same half-edge", sites);
  fuzz::check(twins.copy.origin(flipped) == d && twins.copy.dest(flipped) == c, "the other diagonal is there",
              sites);
}

/// The new triangles of a plan: constrained Delaunay, so that across each inner edge of the two polygons no
/// corner of one is inside the circle of the other.
void check_constrained_delaunay(const Triangulation& t, const EdgeInsertion& plan,
                                const std::vector<Point2>& sites, VertexId p, VertexId q) {
  const std::vector<FaceId> inside(plan.faces().begin(), plan.faces().end());
  for (const FaceId face : inside) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const HalfedgeId h = Triangulation::halfedge(face, i), twin = t.twin(h);
      if (!twin.valid() || std::find(inside.begin(), inside.end(), Triangulation::face(twin)) == inside.end())
        continue;
      const VertexId u = t.origin(h), v = t.dest(h);
      if ((u == p && v == q) || (u == q && v == p)) continue;
      // An edge of the old boundary that dangles into the polygon has both its sides inside.
      if (std::count(plan.vertices().begin(), plan.vertices().end(), u) > 1 ||
          std::count(plan.vertices().begin(), plan.vertices().end(), v) > 1)
        continue;
      fuzz::check(thalweg::incircle(sites[u.index()], sites[v.index()], sites[t.apex(h).index()],
                                    sites[t.apex(twin).index()]) <= 0,
                  "polygons are triangulated Delaunay", sites);
    }
  }
}

void insert(Twins& twins, const std::vector<Point2>& sites, VertexId p, VertexId q, bool keep) {
  EdgeInsertion plan, same;
  const Triangulation before = twins.copy;
  const bool possible = plan.plan(twins.copy, sites, p, q);
  fuzz::check(possible == same.plan(twins.revision, sites, p, q), "plans do not depend on sharing", sites);
  const bool open = std::none_of(sites.begin(), sites.end(), [&](Point2 r) {
    return support::lies_between(sites[p.index()], sites[q.index()], r);
  });
  fuzz::check(possible == (open && !before.joined(p, q)), "exactly open pairs can be inserted", sites);
  if (!possible) return;
  plan.apply(twins.copy);
  same.apply(twins.revision);
  fuzz::check(twins.copy.joined(p, q), "an inserted edge is there", sites);
  twins.check_equal(sites);
  check_constrained_delaunay(twins.copy, plan, sites, p, q);
  if (keep) return;
  plan.undo(twins.copy);
  same.undo(twins.revision);
  // Which half-edge `outgoing` names at an inner vertex is free.
  fuzz::check(std::ranges::equal(twins.copy.origins(), before.origins()) &&
                  std::ranges::equal(twins.copy.twins(), before.twins()),
              "an undone insertion leaves no trace", sites);
}

void check_sound(const Twins& twins, const Triangulation& base, const std::vector<Point2>& sites) {
  fuzz::check(!twins.copy.find_fault() && !twins.revision.find_fault(), "links are sound", sites);
  fuzz::check(thalweg::find_faults(sites, fuzz::triangles_of(twins.copy)).empty(), "it is a triangulation",
              sites);
  const std::vector<FaceId> revised = twins.revision.revised_faces();
  for (std::uint32_t f = 0; f < base.face_count(); ++f) {
    const bool differs = base.corners(FaceId(f)) != twins.copy.corners(FaceId(f));
    fuzz::check(!differs || std::binary_search(revised.begin(), revised.end(), FaceId(f)),
                "changed faces are listed", sites);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Input input(data, size);
  const std::uint64_t first = input.byte();
  support::Random random(256 * first + input.byte());
  const std::vector<Point2> sites = fuzz::distinct_sites(fuzz::take_points(input, 32));
  const auto delaunay = thalweg::delaunay(sites);
  if (!delaunay) return 0;
  Triangulation base = *delaunay;
  Twins twins = {base, Triangulation::revision_of(base)};
  for (std::uint64_t edits = first < 240 ? 1 + first % 6 : 24; edits > 0; --edits) {
    if (random.below(2) == 0) {
      flip(twins, sites, HalfedgeId(random.below(base.halfedge_count())));
    } else {
      const VertexId p(random.below(base.vertex_count())), q(random.below(base.vertex_count()));
      if (p != q) insert(twins, sites, p, q, random.below(3) > 0);
    }
    twins.check_equal(sites);
  }
  check_sound(twins, base, sites);
  fuzz::check(base == *delaunay, "the base of a revision does not change", sites);
  base.take(std::move(twins.revision));
  fuzz::check(base == twins.copy && !base.is_revision(), "a revision is taken whole", sites);
  return 0;
}
