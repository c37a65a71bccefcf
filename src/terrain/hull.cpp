/// Insertions of exits: apart from each other, then across each other.
#include "terrain/hull.hpp"

#include <algorithm>

#include "kernel/assert.hpp"
#include "kernel/edge_insertion.hpp"
#include "terrain/flats.hpp"

namespace thalweg::detail {
namespace {

/// Inserts one exit at a time and keeps the count of pits.
class Inserter {
 public:
  Inserter(const Surface& surface, const Watch& watch, Outcome& outcome)
      : surface_(surface), watch_(watch), outcome_(outcome), counter_(surface.graph()), flats_(surface) {}
  ~Inserter() { outcome_.circle_counts += counter_.calls(); }
  Inserter(const Inserter&) = delete;
  Inserter& operator=(const Inserter&) = delete;

  /// Whether the exit's pit is still there, and the exit still leads out of it; if so, its insertion is
  /// planned.
  bool plan(const Exit& exit) {
    if (!flats_.on_pit(outcome_.triangulation, exit.from)) return false;
    const auto pit = flats_.flat();
    if (surface_.z(exit.to) == surface_.z(exit.from) &&
        std::find(pit.begin(), pit.end(), exit.to) != pit.end()) {
      return false;
    }
    pit_ = surface_.lowest(pit);
    if (surface_.z(exit.to) == surface_.z(exit.from) && flats_.on_pit(outcome_.triangulation, exit.to)) {
      // Two pits become one, which keeps the lower of their names.
      pit_ = std::max(pit_, surface_.lowest(flats_.flat()),
                      [&](VertexId u, VertexId v) { return surface_.lower(u, v); });
    }
    return insertion_.plan(outcome_.triangulation, surface_.sites(), exit.from, exit.to);
  }

  /// Whether to leave it at what has been inserted: see FlatSearch.
  bool exhausted() const noexcept { return watch_.stopped() || flats_.exhausted(); }

  std::span<const FaceId> faces() const noexcept { return insertion_.faces(); }

  bool new_triangles_within(unsigned k) {
    return std::all_of(insertion_.triangles().begin(), insertion_.triangles().end(),
                       [&](const Triangle& t) { return counter_.order_at_most(k, t); });
  }

  /// Carries out the planned insertion of the exit if it lowers the number of pits; returns whether it did.
  bool insert_if_it_pays(const Exit& exit) {
    Triangulation& t = outcome_.triangulation;
    const std::uint32_t before = flats_.pits_touching(t, insertion_.vertices());
    insertion_.apply(t);
    const std::uint32_t after = flats_.pits_touching(t, insertion_.vertices());
    if (after >= before) {
      insertion_.undo(t);
      return false;
    }
    outcome_.pits -= before - after;
    outcome_.note_insertion(exit.order, exit.from, exit.to, pit_, watch_.keep_trail);
    return true;
  }

 private:
  const Surface& surface_;
  const Watch& watch_;
  Outcome& outcome_;
  CircleCounter counter_;
  FlatSearch flats_;
  EdgeInsertion insertion_;
  VertexId pit_;
};

}  // namespace

Outcome insert_hulls(const Surface& surface, std::span<const Exit> exits, unsigned k, const Watch& watch,
                     std::vector<std::uint32_t>* pits_at) {
  Outcome outcome;
  outcome.triangulation = Triangulation::revision_of(surface.delaunay());
  outcome.pits = surface.pits().size();
  if (pits_at != nullptr) pits_at->clear();
  Inserter inserter(surface, watch, outcome);
  std::vector<std::uint8_t> locked(outcome.triangulation.face_count(), 0);
  const auto is_locked = [&](FaceId f) { return locked[f.index()] != 0; };
  for (const Exit& exit : exits) {
    if (inserter.exhausted()) break;
    THALWEG_ASSERT(exit.order <= k);
    if (pits_at != nullptr) pits_at->resize(std::max<std::size_t>(pits_at->size(), exit.order), outcome.pits);
    if (!inserter.plan(exit)) continue;
    if (std::any_of(inserter.faces().begin(), inserter.faces().end(), is_locked)) continue;
    if (!inserter.insert_if_it_pays(exit)) continue;
    // The paper's guarantee: the hull of one useful edge of order <= k, by itself, never needs a triangle of
    // higher order.
    THALWEG_ASSERT(inserter.new_triangles_within(k));
    for (const FaceId f : inserter.faces()) locked[f.index()] = 1;
  }
  if (pits_at != nullptr) pits_at->resize(k + std::size_t{1}, outcome.pits);
  return outcome;
}

void insert_overlapping(const Surface& surface, std::span<const Exit> exits, unsigned k, const Watch& watch,
                        Outcome& outcome) {
  Inserter inserter(surface, watch, outcome);
  for (bool gained = true; gained;) {
    gained = false;
    for (const Exit& exit : exits) {
      if (inserter.exhausted()) return;
      if (inserter.plan(exit) && inserter.new_triangles_within(k) && inserter.insert_if_it_pays(exit))
        gained = true;
    }
  }
}

}  // namespace thalweg::detail
