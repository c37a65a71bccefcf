/// Ejection chains, depth first.
#include "terrain/ejection.hpp"

#include <algorithm>
#include <array>
#include <unordered_map>
#include <vector>

#include "kernel/edge_insertion.hpp"
#include "order/sleeve_search.hpp"
#include "terrain/exits.hpp"
#include "terrain/flats.hpp"

namespace thalweg::detail {
namespace {

constexpr std::size_t kDepth = 3;

/// Insertions tried in one call: some seconds at the most, and never needed on real terrain.
constexpr std::uint64_t kBudget = 200'000;

class Chains {
 public:
  Chains(const Surface& surface, unsigned k, const Watch& watch, Outcome& outcome)
      : surface_(surface),
        watch_(watch),
        k_(k),
        outcome_(outcome),
        counter_(surface.graph()),
        flats_(surface) {}
  ~Chains() { outcome_.circle_counts += counter_.calls(); }
  Chains(const Chains&) = delete;
  Chains& operator=(const Chains&) = delete;

  void run() {
    for (bool gained = true; gained;) {
      gained = false;
      for (const VertexId pit : pits_by_elevation()) {
        if (drain(pit, 0, 0)) gained = true;
        if (exhausted()) return;
      }
    }
  }

 private:
  bool exhausted() const noexcept { return tried_ >= kBudget || flats_.exhausted() || watch_.stopped(); }

  std::vector<VertexId> pits_by_elevation() const {
    const Pits pits = find_pits(outcome_.triangulation, surface_.z());
    std::vector<VertexId> lowest;
    for (std::uint32_t i = 0; i < pits.size(); ++i) lowest.push_back(surface_.lowest(pits[i]));
    std::sort(lowest.begin(), lowest.end(), [&](VertexId u, VertexId v) { return surface_.lower(u, v); });
    return lowest;
  }

  /// Inserts an exit of the pit of v; `debt` is how many pits the chain has made so far, less those it has
  /// removed. True if the chain ends with fewer pits than it began with, and stands; otherwise the
  /// triangulation is as before.
  bool drain(VertexId v, std::size_t depth, int debt) {
    if (!flats_.on_pit(outcome_.triangulation, v)) return false;
    const std::vector<VertexId> pit(flats_.flat().begin(), flats_.flat().end());
    for (const VertexId p : pit) {
      for (const Exit& exit : exits_of(p)) {
        if (exhausted()) return false;
        const bool stays_level = surface_.z(exit.to) == surface_.z(p);
        if (stays_level && std::find(pit.begin(), pit.end(), exit.to) != pit.end()) continue;
        if (insert(exit, depth, debt)) return true;
      }
    }
    return false;
  }

  bool insert(const Exit& exit, std::size_t depth, int debt) {
    Triangulation& t = outcome_.triangulation;
    EdgeInsertion& insertion = insertions_[depth];
    ++tried_;
    if (!insertion.plan(t, surface_.sites(), exit.from, exit.to)) return false;
    const auto within = [&](const Triangle& triangle) { return counter_.order_at_most(k_, triangle); };
    if (!std::all_of(insertion.triangles().begin(), insertion.triangles().end(), within)) return false;

    const auto before = static_cast<int>(flats_.pits_touching(t, insertion.vertices()));
    insertion.apply(t);
    const auto after = static_cast<int>(flats_.pits_touching(t, insertion.vertices()));
    debt += after - before;
    const std::size_t steps_before = outcome_.trail.size();
    outcome_.note_insertion(exit.order, exit.from, exit.to, VertexId(), watch_.keep_trail);
    if (debt < 0) {
      outcome_.pits -= static_cast<std::uint32_t>(-debt);
      return true;
    }
    // A chain that goes on deeper in debt than one pit cannot pay it off in the steps left.
    if (debt == 0 && depth + 1 < kDepth) {
      const std::vector<VertexId> touched(insertion.vertices().begin(), insertion.vertices().end());
      for (const VertexId v : touched) {
        if (drain(v, depth + 1, debt)) return true;
      }
    }
    insertion.undo(t);
    outcome_.trail.resize(steps_before);
    --outcome_.insertions;
    return false;
  }

  /// All pairs of p to lower or level ground, by order, then elevation. (Whether level ground is outside the
  /// pit is for the caller.)
  const std::vector<Exit>& exits_of(VertexId p) {
    const auto emplaced = exits_.try_emplace(p.index());
    std::vector<Exit>& exits = emplaced.first->second;
    if (emplaced.second) {
      unsigned limit = k_;
      SleeveSearch(surface_.graph(), counter_)
          .run(
              p, limit, [&](VertexId q) { return surface_.z(q) <= surface_.z(p); },
              [&](VertexId q, unsigned order) {
                exits.push_back({p, q, order});
                return false;
              });
      std::sort(exits.begin(), exits.end(), [&](const Exit& a, const Exit& b) {
        return a.order != b.order ? a.order < b.order : surface_.lower(a.to, b.to);
      });
    }
    return exits;
  }

  const Surface& surface_;
  const Watch& watch_;
  const unsigned k_;
  Outcome& outcome_;
  CircleCounter counter_;
  FlatSearch flats_;
  std::array<EdgeInsertion, kDepth> insertions_;
  std::unordered_map<std::uint32_t, std::vector<Exit>> exits_;
  std::uint64_t tried_ = 0;
};

}  // namespace

void insert_chains(const Surface& surface, unsigned k, const Watch& watch, Outcome& outcome) {
  Chains(surface, k, watch, outcome).run();
}

}  // namespace thalweg::detail
