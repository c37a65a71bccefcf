/// Depth-first branch and bound on pits.
#include "terrain/exact.hpp"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "terrain/completion.hpp"
#include "terrain/crossings.hpp"

namespace thalweg::detail {
namespace {

constexpr std::uint64_t kNoBudget = std::numeric_limits<std::uint64_t>::max();

bool same_pair(VertexId a, VertexId b, const RequiredEdge& e) noexcept {
  return (a == e.u && b == e.v) || (a == e.v && b == e.u);
}

class ExactSearch {
 public:
  ExactSearch(const Surface& surface, const Plan& plan, Outcome best, unsigned k, const Watch& watch)
      : surface_(surface), plan_(plan), watch_(watch), best_(std::move(best)), completion_(surface, k) {}

  /// Returns whether the search came to its end, so that nothing better than `best()` exists.
  bool run() {
    // Nodes still to visit are kept as marks: how many required and forbidden edges of the current path they
    // share, and what they add. Depth-first, the child with most promise on top.
    stack_.push_back({0, 0, {}, {}});
    while (!stack_.empty() && best_.pits > plan_.bound) {
      if (watch_.stopped()) return false;
      Node node = std::move(stack_.back());
      stack_.pop_back();
      required_.resize(node.required_before);
      forbidden_.resize(node.forbidden_before);
      required_.insert(required_.end(), node.requires_more.begin(), node.requires_more.end());
      forbidden_.insert(forbidden_.end(), node.forbids_more.begin(), node.forbids_more.end());
      if (!visit()) return false;
    }
    return true;
  }

  Outcome take_best() { return std::move(best_); }

 private:
  struct Node {
    std::size_t required_before, forbidden_before;
    std::vector<RequiredEdge> requires_more, forbids_more;
  };

  /// Looks at the node of the current path and puts its children on the stack; false if the watch has
  /// stopped.
  bool visit() {
    if (bound_by_assignment() >= best_.pits) return true;
    switch (completion_.find(required_, kNoBudget, watch_)) {
      case Completion::Answer::unknown:
        return false;
      case Completion::Answer::impossible:
        return true;
      case Completion::Answer::found:
        break;
    }
    const Pits pits = find_pits(completion_.triangulation(), surface_.z());
    if (pits.size() < best_.pits) keep(pits.size());
    branch(pits);
    return true;
  }

  void keep(std::uint32_t pits) {
    Outcome found;
    found.triangulation = completion_.triangulation();
    found.pits = pits;
    found.circle_counts = best_.circle_counts;
    for (const RequiredEdge& e : required_) found.note_insertion(0, e.u, e.v, VertexId(), watch_.keep_trail);
    best_ = std::move(found);
  }

  /// Branches on the pit with the fewest ways out, unless the stuck ones alone are too many.
  void branch(const Pits& pits) {
    std::uint32_t stuck = 0;
    std::vector<RequiredEdge> fewest;
    for (std::uint32_t i = 0; i < pits.size(); ++i) {
      std::vector<RequiredEdge> ways = ways_out(pits[i]);
      if (ways.empty()) {
        ++stuck;
      } else if (fewest.empty() || ways.size() < fewest.size()) {
        fewest = std::move(ways);
      }
    }
    if (stuck >= best_.pits || fewest.empty()) return;
    // Last on the stack, and so first to be visited: the first way out.
    stack_.push_back({required_.size(), forbidden_.size(), {}, fewest});
    for (std::size_t i = fewest.size(); i-- > 0;) {
      stack_.push_back({required_.size(),
                        forbidden_.size(),
                        {fewest[i]},
                        {fewest.begin(), fewest.begin() + static_cast<std::ptrdiff_t>(i)}});
    }
  }

  /// The pairs that lead out of the pit and are still open in this node, in elevation order of their ends.
  std::vector<RequiredEdge> ways_out(std::span<const VertexId> pit) {
    std::vector<RequiredEdge> ways;
    for (const VertexId p : pit) {
      for (const VertexId q : completion_.partners(p)) {
        const bool leads_out =
            surface_.z(q) < surface_.z(p) ||
            (surface_.z(q) == surface_.z(p) && !std::binary_search(pit.begin(), pit.end(), q));
        if (leads_out && is_open(p, q)) ways.push_back({p, q});
      }
    }
    std::sort(ways.begin(), ways.end(), [&](const RequiredEdge& a, const RequiredEdge& b) {
      return a.v != b.v ? surface_.lower(a.v, b.v) : surface_.lower(a.u, b.u);
    });
    return ways;
  }

  /// Whether the pair is not forbidden and crosses no required edge.
  bool is_open(VertexId p, VertexId q) const {
    const auto at = [&](VertexId v) { return surface_.sites()[v.index()]; };
    return std::none_of(forbidden_.begin(), forbidden_.end(),
                        [&](const RequiredEdge& e) { return same_pair(p, q, e); }) &&
           std::none_of(required_.begin(), required_.end(), [&](const RequiredEdge& e) {
             return cross_properly(at(p), at(q), at(e.u), at(e.v));
           });
  }

  /// The assignment bound over the exits that are still open: fewer exits, a larger bound, valid for this
  /// node.
  std::uint32_t bound_by_assignment() const {
    Units units;
    units.count = plan_.units.count;
    for (const UnitExit& e : plan_.units.exits) {
      if (is_open(e.exit.from, e.exit.to)) units.exits.push_back(e);
    }
    units.starts.assign(units.count + std::size_t{1}, 0);
    for (const UnitExit& e : units.exits) ++units.starts[e.unit + std::size_t{1}];
    for (std::uint32_t i = 0; i < units.count; ++i) units.starts[i + std::size_t{1}] += units.starts[i];
    const Crossings crossings(surface_, units.exits);
    return crossings.complete() ? solve_assignment(units, crossings).bound : 0;
  }

  const Surface& surface_;
  const Plan& plan_;
  const Watch& watch_;
  Outcome best_;
  Completion completion_;
  std::vector<Node> stack_;
  std::vector<RequiredEdge> required_, forbidden_;
};

}  // namespace

ExactOutcome exact_pits(const Surface& surface, const Plan& plan, Outcome best, unsigned k,
                        const Watch& watch) {
  if (best.pits == plan.bound) return {std::move(best), plan.bound};
  ExactSearch search(surface, plan, std::move(best), k, watch);
  const bool complete = search.run();
  ExactOutcome result{search.take_best(), plan.bound};
  if (complete) result.bound = result.outcome.pits;
  return result;
}

}  // namespace thalweg::detail
