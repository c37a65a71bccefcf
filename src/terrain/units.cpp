/// The fixpoint of units, their exits and the edges these cross.
#include "terrain/units.hpp"

#include <algorithm>

#include "kernel/assert.hpp"
#include "kernel/parallel.hpp"
#include "kernel/sleeve.hpp"
#include "order/sleeve_search.hpp"

namespace thalweg::detail {
namespace {

class UnitFinder {
 public:
  UnitFinder(const Surface& surface, unsigned k, const Watch& watch)
      : surface_(surface),
        t_(surface.delaunay()),
        watch_(watch),
        k_(k),
        crossed_(t_.halfedge_count(), 0),
        is_touched_(t_.vertex_count(), 0),
        group_(t_.vertex_count(), kUnseen),
        searched_as_(t_.vertex_count(), {kUnseen, 0}) {}

  Units run(std::span<const Exit> exits) {
    // The order makes no difference; this one goes through memory, that of the exits across the whole ground.
    exits_.assign(exits.begin(), exits.end());
    std::sort(exits_.begin(), exits_.end(), [](const Exit& a, const Exit& b) { return a.from < b.from; });
    for (std::uint32_t i = 0; i < surface_.pits().size(); ++i) {
      for (const VertexId v : surface_.pits()[i]) {
        touch(v);
        // With nothing crossed yet the pits are the units, and their exits are known.
        searched_as_[v.index()] = {surface_.pits()[i].front().index(),
                                   static_cast<std::uint32_t>(surface_.pits()[i].size())};
      }
    }
    std::size_t marked = 0;
    for (bool changed = true; changed && !watch_.stopped();) {
      for (; marked < exits_.size(); ++marked) cross(exits_[marked]);
      find_groups();
      changed = search_new_units();
    }
    return collect();
  }

 private:
  static constexpr std::uint32_t kUnseen = 0xffffffffu;
  static constexpr std::uint32_t kDrains = 0xfffffffeu;

  struct Member {
    std::uint32_t first, size;
    friend bool operator==(const Member&, const Member&) = default;
  };

  void touch(VertexId v) {
    if (is_touched_[v.index()] != 0) return;
    is_touched_[v.index()] = 1;
    touched_.push_back(v);
  }

  /// Puts the Delaunay edges that the exit crosses into X, and touches their ends.
  void cross(const Exit& exit) {
    if (t_.joined(exit.from, exit.to)) return;
    const bool clear = find_sleeve(t_, surface_.sites(), exit.from, exit.to, sleeve_);
    THALWEG_ASSERT(clear);
    static_cast<void>(clear);
    for (std::size_t i = 1; i < sleeve_.faces.size(); ++i) {
      for (std::uint32_t corner = 0; corner < 3; ++corner) {
        const HalfedgeId h = Triangulation::halfedge(sleeve_.faces[i], corner), twin = t_.twin(h);
        if (!twin.valid() || Triangulation::face(twin) != sleeve_.faces[i - 1]) continue;
        crossed_[h.index()] = crossed_[twin.index()] = 1;
        touch(t_.origin(h));
        touch(t_.dest(h));
      }
    }
  }

  /// Calls visit(w) for every neighbour w of v over an edge that is not in X, until it returns false.
  template <class Visit>
  void for_each_safe_neighbor(VertexId v, Visit&& visit) const {
    const HalfedgeId first = t_.outgoing(v);
    for (HalfedgeId h = first; h.valid();) {
      if (crossed_[h.index()] == 0 && !visit(t_.dest(h))) return;
      const HalfedgeId turned = t_.turn_ccw(h);
      if (!turned.valid()) visit(t_.apex(h));  // along the hull, where nothing crosses
      if (turned == first) return;
      h = turned;
    }
  }

  void find_groups() {
    for (const std::vector<VertexId>& members : groups_) {
      for (const VertexId v : members) group_[v.index()] = kUnseen;
    }
    for (const VertexId v : drained_) group_[v.index()] = kUnseen;
    groups_.clear();
    drained_.clear();
    for (const VertexId v : touched_) {
      if (group_[v.index()] == kUnseen) flood(v);
    }
  }

  /// Floods the group of v until it is seen to drain; a group that does not drain becomes a unit.
  void flood(VertexId v) {
    const double level = surface_.z(v);
    const auto number = static_cast<std::uint32_t>(groups_.size());
    std::vector<VertexId> members = {v};
    group_[v.index()] = number;
    bool drains = false;
    for (std::size_t head = 0; head < members.size() && !drains; ++head) {
      for_each_safe_neighbor(members[head], [&](VertexId w) {
        const double z = surface_.z(w);
        std::uint32_t& group = group_[w.index()];
        if (z < level || (z == level && group == kDrains)) drains = true;
        if (z == level && group == kUnseen) {
          group = number;
          members.push_back(w);
        }
        return !drains;
      });
    }
    if (drains) {
      for (const VertexId w : members) group_[w.index()] = kDrains;
      drained_.insert(drained_.end(), members.begin(), members.end());
      return;
    }
    std::sort(members.begin(), members.end());
    groups_.push_back(std::move(members));
  }

  /// Searches the exits of units that are new or have lost vertices; returns whether there were any exits to
  /// add.
  bool search_new_units() {
    std::vector<VertexId> sources;
    for (const std::vector<VertexId>& members : groups_) {
      const Member as{members.front().index(), static_cast<std::uint32_t>(members.size())};
      for (const VertexId v : members) {
        // Groups only ever get finer, so one with the same first vertex and size is the same.
        if (searched_as_[v.index()] == as) continue;
        searched_as_[v.index()] = as;
        sources.push_back(v);
      }
    }
    constexpr std::size_t kChunk = 16;
    std::vector<std::vector<Exit>> lists((sources.size() + kChunk - 1) / kChunk);
    parallel_chunks(sources.size(), kChunk, watch_.threads, [&] {
      return [&, counter = CircleCounter(surface_.graph())](std::size_t begin, std::size_t end) mutable {
        SleeveSearch search(surface_.graph(), counter);
        for (std::size_t i = begin; i < end && !watch_.stopped(); ++i) {
          const VertexId p = sources[i];
          unsigned limit = k_;
          search.run(
              p, limit, [&](VertexId q) { return leads_out(p, q); },
              [&](VertexId q, unsigned order) {
                lists[begin / kChunk].push_back({p, q, order});
                return false;
              });
        }
      };
    });
    for (const auto& list : lists) exits_.insert(exits_.end(), list.begin(), list.end());
    return !sources.empty();
  }

  bool leads_out(VertexId p, VertexId q) const noexcept {
    return surface_.z(q) < surface_.z(p) ||
           (surface_.z(q) == surface_.z(p) && group_[q.index()] != group_[p.index()]);
  }

  Units collect() const {
    Units units;
    units.count = static_cast<std::uint32_t>(groups_.size());
    std::vector<std::pair<VertexId, std::uint32_t>> by_lowest;
    for (std::uint32_t i = 0; i < units.count; ++i) by_lowest.emplace_back(surface_.lowest(groups_[i]), i);
    std::sort(by_lowest.begin(), by_lowest.end(),
              [&](const auto& a, const auto& b) { return surface_.lower(a.first, b.first); });
    std::vector<std::uint32_t> number(units.count);
    for (std::uint32_t i = 0; i < units.count; ++i) number[by_lowest[i].second] = i;

    for (const Exit& exit : exits_) {
      const std::uint32_t group = group_[exit.from.index()], target = group_[exit.to.index()];
      if (group >= kDrains || !leads_out(exit.from, exit.to)) continue;
      const bool to_unit = surface_.z(exit.to) == surface_.z(exit.from) && target < kDrains;
      units.exits.push_back({exit, number[group], to_unit ? number[target] : Units::kGround});
    }
    std::sort(units.exits.begin(), units.exits.end(), [&](const UnitExit& a, const UnitExit& b) {
      if (a.unit != b.unit) return a.unit < b.unit;
      if (a.exit.order != b.exit.order) return a.exit.order < b.exit.order;
      return a.exit.from != b.exit.from ? surface_.lower(a.exit.from, b.exit.from)
                                        : surface_.lower(a.exit.to, b.exit.to);
    });
    // A vertex whose unit lost vertices was searched again, and found its old exits again.
    units.exits.erase(std::unique(units.exits.begin(), units.exits.end(),
                                  [&](const UnitExit& a, const UnitExit& b) {
                                    return a.exit.from == b.exit.from && a.exit.to == b.exit.to;
                                  }),
                      units.exits.end());
    units.starts.assign(units.count + std::size_t{1}, 0);
    for (const UnitExit& e : units.exits) ++units.starts[e.unit + std::size_t{1}];
    for (std::uint32_t i = 0; i < units.count; ++i) units.starts[i + std::size_t{1}] += units.starts[i];
    return units;
  }

  const Surface& surface_;
  const Triangulation& t_;
  const Watch& watch_;
  const unsigned k_;
  Array<std::uint8_t> crossed_;     // X, by half-edge
  Array<std::uint8_t> is_touched_;  // pits, and ends of edges in X: where a unit can be
  std::vector<VertexId> touched_;
  Array<std::uint32_t> group_;  // unit, kDrains or kUnseen: drains beyond doubt
  Array<Member> searched_as_;   // the unit as it was when the exits of a vertex were searched
  std::vector<std::vector<VertexId>> groups_;
  std::vector<VertexId> drained_;
  std::vector<Exit> exits_;
  Sleeve sleeve_;
};

}  // namespace

Units find_units(const Surface& surface, std::span<const Exit> exits, unsigned k, const Watch& watch) {
  return UnitFinder(surface, k, watch).run(exits);
}

}  // namespace thalweg::detail
