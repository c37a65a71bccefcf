/// Kernelisation, components, branch and bound.
#include "terrain/assignment.hpp"

#include <algorithm>
#include <numeric>

#include "kernel/assert.hpp"
#include "kernel/parallel.hpp"
#include "terrain/disjoint_sets.hpp"

namespace thalweg::detail {
namespace {

constexpr std::uint32_t kUnset = 0xffffffffu;

/// Steps that one component may take: a fraction of a second. Real terrain needs a few thousand in all.
constexpr std::uint64_t kComponentBudget = 300'000;

/// Steps that all components may take together: some seconds, shared equally where there are very many of
/// them.
constexpr std::uint64_t kTotalBudget = 100'000'000;

/// Settles every unit that can have an exit at no cost to the others: one that crosses no exit of a unit
/// still open, and leads to ground or to a settled unit. Exchanging whatever a largest assignment gives this
/// unit for it keeps the size.
class Kernel {
 public:
  Kernel(const Units& units, const Crossings& crossings)
      : units_(units),
        crossings_(crossings),
        open_(units.count, 1),
        crossed_by_(units.exits.size(), 0),
        aimed_at_(units.count) {}

  /// Returns the exits taken; `open()` tells what is left.
  std::vector<std::uint32_t> run() {
    for (std::uint32_t e = 0; e < units_.exits.size(); ++e) {
      crossed_by_[e] = static_cast<std::uint32_t>(crossings_.of(e).size());
      if (units_.exits[e].target != Units::kGround) aimed_at_[units_.exits[e].target].push_back(e);
    }
    // A unit without exits never has one: level exits may lead to it without fear of a cycle.
    for (std::uint32_t u = 0; u < units_.count; ++u) {
      if (units_.of(u).empty()) close(u);
    }
    for (std::uint32_t e = 0; e < units_.exits.size(); ++e) ready_.push_back(e);
    std::vector<std::uint32_t> taken;
    for (std::size_t head = 0; head < ready_.size(); ++head) {
      const std::uint32_t e = ready_[head];
      if (!is_free(e)) continue;
      taken.push_back(e);
      close(units_.exits[e].unit);
    }
    return taken;
  }

  bool is_open(std::uint32_t unit) const noexcept { return open_[unit] != 0; }

 private:
  bool is_free(std::uint32_t e) const noexcept {
    const UnitExit& exit = units_.exits[e];
    return is_open(exit.unit) && crossed_by_[e] == 0 &&
           (exit.target == Units::kGround || !is_open(exit.target));
  }

  void close(std::uint32_t unit) {
    open_[unit] = 0;
    for (std::uint32_t e = units_.starts[unit]; e < units_.starts[unit + 1]; ++e) {
      for (const std::uint32_t other : crossings_.of(e)) {
        if (--crossed_by_[other] == 0) ready_.push_back(other);
      }
    }
    for (const std::uint32_t e : aimed_at_[unit]) ready_.push_back(e);
  }

  const Units& units_;
  const Crossings& crossings_;
  std::vector<std::uint8_t> open_;
  std::vector<std::uint32_t> crossed_by_;  // exits of open units that cross each exit
  std::vector<std::vector<std::uint32_t>> aimed_at_;
  std::vector<std::uint32_t> ready_;
};

/// Branch and bound over the open units of one component.
class Component {
 public:
  /// `blocked`, `choice`: scratch by exit and by unit, zero and kUnset, and so again afterwards.
  Component(const Units& units, const Crossings& crossings, const Kernel& kernel,
            std::vector<std::uint32_t> members, std::vector<std::uint32_t>& blocked,
            std::vector<std::uint32_t>& choice)
      : units_(units),
        crossings_(crossings),
        kernel_(kernel),
        members_(std::move(members)),
        blocked_(blocked),
        choice_(choice) {
    std::stable_sort(members_.begin(), members_.end(), [&](std::uint32_t a, std::uint32_t b) {
      return units_.of(a).size() < units_.of(b).size();
    });
  }

  /// Most units that can be served at all: in a group of units that only lead to each other one is left over.
  std::uint32_t most() const {
    std::vector<std::uint32_t> sorted = members_;
    std::sort(sorted.begin(), sorted.end());
    const auto place = [&](std::uint32_t unit) {
      return static_cast<std::uint32_t>(std::lower_bound(sorted.begin(), sorted.end(), unit) -
                                        sorted.begin());
    };
    const auto size = static_cast<std::uint32_t>(sorted.size());
    DisjointSets groups(size);
    std::vector<std::uint8_t> drains(size, 0);
    for (std::uint32_t i = 0; i < size; ++i) {
      for (const UnitExit& e : units_.of(sorted[i])) {
        if (leads_away(e)) {
          drains[i] = 1;
        } else {
          groups.join(i, place(e.target));
        }
      }
    }
    std::vector<std::uint8_t> group_drains(size, 0);
    for (std::uint32_t i = 0; i < size; ++i) {
      if (drains[i] != 0) group_drains[groups.find(i)] = 1;
    }
    std::uint32_t result = size;
    for (std::uint32_t i = 0; i < size; ++i) {
      if (groups.find(i) == i && group_drains[i] == 0) --result;
    }
    return result;
  }

  /// Appends the exits of the largest assignment found; returns whether it is known to be a largest one.
  bool solve(std::uint64_t budget, std::vector<std::uint32_t>& chosen) {
    budget_ = budget;
    most_ = most();
    search();
    for (const std::uint32_t e : best_) chosen.push_back(e);
    return best_.size() == most_ || steps_ < budget_;
  }

 private:
  /// One unit's turn: the exits still to try, then going without.
  struct Turn {
    std::uint32_t next;  // next exit to try; past the end: go without; one further: done
    std::uint32_t chosen = kUnset;
  };

  bool leads_away(const UnitExit& e) const noexcept {
    return e.target == Units::kGround || !kernel_.is_open(e.target);
  }

  void search() {
    std::vector<Turn> turns;
    std::uint32_t served = 0;
    turns.push_back({units_.starts[members_[0]]});
    while (!turns.empty() && best_.size() < most_ && steps_ < budget_) {
      ++steps_;
      Turn& turn = turns.back();
      const std::uint32_t unit = members_[turns.size() - 1], end = units_.starts[unit + 1];
      if (turn.chosen != kUnset) {
        release(turn.chosen);
        turn.chosen = kUnset;
        --served;
      }
      const auto left = static_cast<std::uint32_t>(members_.size() - turns.size());
      while (turn.next < end && !can_choose(turn.next)) ++turn.next;
      if (turn.next > end || served + left + (turn.next < end ? 1 : 0) <= best_.size()) {
        turns.pop_back();
        continue;
      }
      if (turn.next < end) {
        turn.chosen = turn.next;
        choose(turn.chosen);
        ++served;
      }
      ++turn.next;
      if (turns.size() == members_.size()) {
        keep();
      } else {
        turns.push_back({units_.starts[members_[turns.size()]]});
      }
    }
    for (const Turn& turn : turns) {
      if (turn.chosen != kUnset) release(turn.chosen);
    }
  }

  bool can_choose(std::uint32_t e) const {
    if (blocked_[e] != 0) return false;
    const std::uint32_t unit = units_.exits[e].unit;
    for (std::uint32_t at = units_.exits[e].target; at != Units::kGround;) {
      if (at == unit) return false;  // round in a circle
      const std::uint32_t onward = choice_[at];
      if (onward == kUnset) break;
      at = units_.exits[onward].target;
    }
    return true;
  }

  void choose(std::uint32_t e) {
    choice_[units_.exits[e].unit] = e;
    for (const std::uint32_t other : crossings_.of(e)) {
      if (kernel_.is_open(units_.exits[other].unit)) ++blocked_[other];
    }
  }

  void release(std::uint32_t e) {
    choice_[units_.exits[e].unit] = kUnset;
    for (const std::uint32_t other : crossings_.of(e)) {
      if (kernel_.is_open(units_.exits[other].unit)) --blocked_[other];
    }
  }

  void keep() {
    std::vector<std::uint32_t> found;
    for (const std::uint32_t unit : members_) {
      if (choice_[unit] != kUnset) found.push_back(choice_[unit]);
    }
    if (found.size() > best_.size()) best_ = std::move(found);
  }

  const Units& units_;
  const Crossings& crossings_;
  const Kernel& kernel_;
  std::vector<std::uint32_t> members_;
  std::vector<std::uint32_t>& blocked_;
  std::vector<std::uint32_t>& choice_;
  std::vector<std::uint32_t> best_;
  std::uint32_t most_ = 0;
  std::uint64_t steps_ = 0;
  std::uint64_t budget_ = 0;
};

/// The open units, grouped by what ties them: exits that cross, and exits that lead from one to the other.
std::vector<std::vector<std::uint32_t>> components_of(const Units& units, const Crossings& crossings,
                                                      const Kernel& kernel) {
  DisjointSets groups(units.count);
  for (std::uint32_t u = 0; u < units.count; ++u) {
    if (!kernel.is_open(u)) continue;
    for (std::uint32_t e = units.starts[u]; e < units.starts[u + 1]; ++e) {
      const std::uint32_t target = units.exits[e].target;
      if (target != Units::kGround && kernel.is_open(target)) groups.join(u, target);
      for (const std::uint32_t other : crossings.of(e)) {
        if (kernel.is_open(units.exits[other].unit)) groups.join(u, units.exits[other].unit);
      }
    }
  }
  std::vector<std::uint32_t> number(units.count, kUnset);
  std::vector<std::vector<std::uint32_t>> components;
  for (std::uint32_t u = 0; u < units.count; ++u) {
    if (!kernel.is_open(u)) continue;
    std::uint32_t& place = number[groups.find(u)];
    if (place == kUnset) {
      place = static_cast<std::uint32_t>(components.size());
      components.emplace_back();
    }
    components[place].push_back(u);
  }
  return components;
}

}  // namespace

Assignment solve_assignment(const Units& units, const Crossings& crossings, unsigned threads) {
  Assignment result;
  Kernel kernel(units, crossings);
  result.chosen = kernel.run();
  auto most = static_cast<std::uint32_t>(result.chosen.size());

  // A component writes only to places of its own units and their exits, so that all can share the scratch
  // arrays.
  struct Solved {
    std::vector<std::uint32_t> chosen;
    std::uint32_t most = 0;
    bool proved = false;
  };
  std::vector<std::vector<std::uint32_t>> components = components_of(units, crossings, kernel);
  std::vector<Solved> solved(components.size());
  const std::uint64_t budget =
      std::min(kComponentBudget, kTotalBudget / std::max<std::size_t>(1, components.size()));
  std::vector<std::uint32_t> blocked(units.exits.size(), 0), choice(units.count, kUnset);
  parallel_chunks(components.size(), 1, threads, [&] {
    return [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        Component component(units, crossings, kernel, std::move(components[i]), blocked, choice);
        solved[i].proved = component.solve(budget, solved[i].chosen);
        solved[i].most =
            solved[i].proved ? static_cast<std::uint32_t>(solved[i].chosen.size()) : component.most();
      }
    };
  });
  for (const Solved& component : solved) {
    result.chosen.insert(result.chosen.end(), component.chosen.begin(), component.chosen.end());
    most += component.most;
    result.complete = result.complete && component.proved;
  }
  std::sort(result.chosen.begin(), result.chosen.end());
  result.bound = units.count - most;
  return result;
}

}  // namespace thalweg::detail
