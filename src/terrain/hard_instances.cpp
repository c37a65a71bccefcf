/// Theorem 1: the degenerate hard instance.
///
/// Claim. Let T be a triangulation of P and H, and m(T) the number of segments of S that are edges of T. Then
/// pits(T) = 2n - m(T), and a set of segments occurs in some T if and only if no two of it cross.
///
/// The plan of shields gives: (a) between two ends that are not partners lies a site, so no edge joins them;
/// (b) no site lies inside a segment of S; (c) all sites are distinct.
///
/// Elevation 1. By (a) every neighbour of such an end is a shield or its partner, all higher. Each is a pit
/// of its own: n pits in every T.
///
/// Elevation 2. By (a) the neighbours are shields and perhaps the partner. The end drains if its segment is
/// an edge of T, and is a pit of its own if not: n - m(T) pits.
///
/// Elevation 3. Take a set of shields that edges of T join, as large as it goes. T is connected and has ends,
/// so an edge leads out of the set; by maximality to an end, which is lower. No shield is part of a pit. (Of
/// single shields, rather than flats, this may fail: a shield can have shields alone for neighbours.)
///
/// Segments that are edges of T do not cross. Conversely, segments that do not cross are disjoint, as no end
/// lies on another segment, and by (b) no site is inside one: they are a plane graph, which extends to a
/// triangulation.
#include "thalweg/hard_instances.hpp"

#include "terrain/shields.hpp"

namespace thalweg {
namespace {

Point3 at_elevation(LatticePoint p, double z) {
  return {static_cast<double>(p.x), static_cast<double>(p.y), z};
}

}  // namespace

Result<HardInstance> theorem1_instance(std::span<const LatticeSegment> segments) {
  const Result<detail::ShieldPlan> plan = detail::plan_shields(segments, kMostTheorem1Segments);
  if (!plan) return plan.error();
  HardInstance instance;
  instance.segments = static_cast<std::uint32_t>(segments.size());
  instance.shields = static_cast<std::uint32_t>(plan->shields.size());
  instance.scale = plan->scale;
  instance.points.reserve(plan->ends.size() + plan->shields.size());
  for (const LatticePoint p : plan->ends) {
    const double z = instance.points.size() % 2 == 0 ? 1 : 2;
    instance.points.push_back(at_elevation({plan->scale * p.x, plan->scale * p.y}, z));
  }
  for (const detail::Shield& shield : plan->shields) {
    instance.points.push_back(at_elevation(plan->place(shield), 3));
  }
  instance.order = static_cast<unsigned>(instance.points.size() - 3);
  return instance;
}

}  // namespace thalweg
