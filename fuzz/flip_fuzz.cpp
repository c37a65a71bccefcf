/// The flip heuristic over hostile terrains: its result, and every flip on the way to it, by the paper's rule
/// and lemmas. The first byte is the order.
#include <set>
#include <utility>

#include "mesh.hpp"
#include "terrain.hpp"

namespace {

using fuzz::Terrain;
using thalweg::HalfedgeId;
using thalweg::Minimized;
using thalweg::TrailStep;
using thalweg::Triangulation;
using thalweg::VertexId;

using Pair = std::pair<std::uint32_t, std::uint32_t>;

Pair pair_of(VertexId u, VertexId v) {
  return std::minmax(u.index(), v.index());
}

/// Elevation order: (z, x, y).
bool lower(const Terrain& terrain, std::uint32_t u, std::uint32_t v) {
  const auto key = [&](std::uint32_t w) {
    const thalweg::Point3& p = terrain.points[w];
    return std::array{p.z, p.x, p.y};
  };
  return key(u) < key(v);
}

std::uint32_t lower_end(const Terrain& terrain, Pair e) {
  return lower(terrain, e.first, e.second) ? e.first : e.second;
}

bool cross(const Terrain& terrain, Pair e, Pair f) {
  const auto splits = [&](Pair line, Pair ends) {
    const auto turn = [&](std::uint32_t p) {
      return thalweg::orient2d(terrain.places[line.first], terrain.places[line.second], terrain.places[p]);
    };
    return turn(ends.first) * turn(ends.second) < 0;
  };
  return splits(e, f) && splits(f, e);
}

/// The flip of h, if the rule allows it at some order: that order.
std::optional<unsigned> order_of_flip(const Terrain& terrain, const Triangulation& t, HalfedgeId h) {
  if (!fuzz::flippable(t, terrain.places, h)) return std::nullopt;
  const std::uint32_t a = t.origin(h).index(), b = t.dest(h).index(), c = t.apex(h).index(),
                      d = t.apex(t.twin(h)).index();
  if (!lower(terrain, lower_end(terrain, {c, d}), lower_end(terrain, {a, b}))) return std::nullopt;
  return std::max(support::sites_in_circle(terrain.places, terrain.rows, d, c, a),
                  support::sites_in_circle(terrain.places, terrain.rows, c, d, b));
}

/// Lemmas 3 and 4, for an edge that comes: it crosses no edge of all that ever were, unless its lower end is
/// lower than that one's; and it is not one of them.
void check_fresh(const Terrain& terrain, std::set<Pair>& ever, Pair fresh) {
  for (const Pair& old : ever) {
    if (!cross(terrain, old, fresh)) continue;
    fuzz::check(lower(terrain, lower_end(terrain, fresh), lower_end(terrain, old)),
                "lower edges come, higher ones go", terrain);
  }
  fuzz::check(ever.insert(fresh).second, "no edge returns", terrain);
}

void replay(const Terrain& terrain, const Minimized& from, const Minimized& to) {
  Triangulation t = from.triangulation;
  std::set<Pair> ever;
  for (std::uint32_t i = 0; i < t.halfedge_count(); ++i) {
    ever.insert(pair_of(t.origin(HalfedgeId(i)), t.dest(HalfedgeId(i))));
  }
  unsigned round = 0;
  for (const TrailStep& step : to.trail) {
    fuzz::check(step.kind == TrailStep::Kind::flip && step.order >= round, "flips, by rounds", terrain);
    round = step.order;
    const HalfedgeId h = t.find_halfedge(step.old_u, step.old_v);
    const auto order = order_of_flip(terrain, t, h);
    fuzz::check(order && *order <= step.order, "a flip is allowed in its round", terrain);
    fuzz::check(pair_of(t.apex(h), t.apex(t.twin(h))) == pair_of(step.u, step.v), "the edge that comes",
                terrain);
    check_fresh(terrain, ever, pair_of(step.u, step.v));
    t.flip(h);
  }
  fuzz::check(fuzz::triangle_set(t) == fuzz::triangle_set(to.triangulation), "the trail leads to the result",
              terrain);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Input input(data, size);
  const Terrain terrain(input, 32);
  const auto flip = fuzz::run_if_legal(terrain, thalweg::Method::flip);
  if (!flip) return 0;
  fuzz::check(flip->flips == flip->trail.size() && flip->insertions == 0, "flips alone", terrain);
  replay(terrain, fuzz::run(terrain, thalweg::Method::delaunay, terrain.order), *flip);
  for (std::uint32_t i = 0; terrain.order > 0 && i < flip->triangulation.halfedge_count(); ++i) {
    const auto left = order_of_flip(terrain, flip->triangulation, HalfedgeId(i));
    fuzz::check(!left || *left > terrain.order, "no flip is left", terrain);
  }
  fuzz::check_against_fewest(*flip, terrain, 6);
  return 0;
}
