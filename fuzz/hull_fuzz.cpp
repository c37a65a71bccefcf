/// The hull heuristic over hostile terrains: its result, and every insertion on the way to it. The first byte
/// is the order.
#include <set>

#include "kernel/edge_insertion.hpp"
#include "mesh.hpp"
#include "terrain.hpp"

namespace {

using fuzz::Terrain;
using thalweg::FaceId;
using thalweg::Minimized;
using thalweg::TrailStep;
using thalweg::Triangulation;

void replay(const Terrain& terrain, const Minimized& from, const Minimized& to) {
  Triangulation t = from.triangulation;
  thalweg::detail::EdgeInsertion insertion;
  std::set<FaceId> taken;
  unsigned order = 0;
  std::uint32_t pits = from.pits.total;
  for (const TrailStep& step : to.trail) {
    fuzz::check(step.kind == TrailStep::Kind::insertion && step.order >= order && step.order <= terrain.order,
                "insertions, by order", terrain);
    order = step.order;
    const std::uint32_t u = step.u.index(), v = step.v.index();
    fuzz::check(support::useful_order_of(terrain.places, terrain.rows, u, v) == step.order,
                "the edge's useful order", terrain);
    fuzz::check(terrain.points[v].z <= terrain.points[u].z, "the edge drains", terrain);
    fuzz::check(insertion.plan(t, terrain.places, step.u, step.v), "the edge is new", terrain);
    for (const FaceId face : insertion.faces()) {
      fuzz::check(taken.insert(face).second, "hulls do not overlap", terrain);
    }
    insertion.apply(t);
    const std::uint32_t left = fuzz::pits_of(terrain, t);
    fuzz::check(left < pits, "every insertion pays", terrain);
    pits = left;
  }
  fuzz::check(fuzz::triangle_set(t) == fuzz::triangle_set(to.triangulation), "the trail leads to the result",
              terrain);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Input input(data, size);
  const Terrain terrain(input, 32);
  const auto hull = fuzz::run_if_legal(terrain, thalweg::Method::hull);
  if (!hull) return 0;
  fuzz::check(hull->insertions == hull->trail.size() && hull->flips == 0, "insertions alone", terrain);
  replay(terrain, fuzz::run(terrain, thalweg::Method::delaunay, terrain.order), *hull);
  fuzz::check_against_fewest(*hull, terrain, 6);
  return 0;
}
