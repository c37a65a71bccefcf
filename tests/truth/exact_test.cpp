/// Every method against the enumeration of all triangulations, on random sets of 5 to 11 sites at every
/// order.
///
/// More sets, or other ones:
///     THALWEG_EXACT_SETS=40000 THALWEG_EXACT_SEED=2 nice -n 10 test_truth --gtest_filter='Exhaustive.Exact*'
/// That run took 122 s on half a shared core and saw 257,397 cases, a set at an order each: `best` attained
/// the optimum in all and proved it in all but the 4,453 traps; `exact` attained and proved it in all, in at
/// most 0.3 ms.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdio>
#include <ctime>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "support/run.hpp"
#include "support/truth.hpp"
#include "truth/drawn_set.hpp"

namespace {

using oracle::EdgeSet;
using oracle::Enumeration;
using oracle::Relief;
using support::DrawnSet;
using support::printed;
using thalweg::Method;
using thalweg::Minimized;

EdgeSet edges_of(std::span<const oracle::Tri> triangles) {
  EdgeSet edges = 0;
  for (const oracle::Tri& t : triangles) edges |= Enumeration::sides_of(t);
  return edges;
}

/// What is wrong with a result, whatever its method, or nothing.
std::optional<std::string> find_wrong(const Enumeration& all, const Relief& relief, const Minimized& m,
                                      unsigned k, unsigned optimum) {
  const auto triangles = support::triangles_of(m.triangulation);
  const Enumeration::Entry* entry = all.find(edges_of(triangles));
  if (entry == nullptr) return "its edges are no triangulation";
  std::set<EdgeSet> faces;
  for (const oracle::Tri& t : triangles) {
    if (!all.is_face(t)) return "a face is clockwise or holds a site";
    faces.insert(Enumeration::sides_of(t));
  }
  // Euler's formula, without the outer face.
  const std::size_t expected = static_cast<std::size_t>(std::popcount(entry->edges)) + 1 - all.size();
  if (faces.size() != expected || triangles.size() != expected) return "wrong number of faces";
  if (entry->order > k) return "order " + std::to_string(entry->order);
  const auto order = std::max_element(m.face_orders.begin(), m.face_orders.end());
  if (m.face_orders.size() != triangles.size() || *order != entry->order) return "wrong face orders";
  if (relief.pits(entry->edges) != m.pits.total) return "pits are not " + std::to_string(m.pits.total);
  if (m.pits.total < optimum) return "the enumeration misses a triangulation";
  if (m.lower_bound > optimum) return "lower bound " + std::to_string(m.lower_bound);
  if (m.certified != (m.lower_bound == m.pits.total)) return "certified is not bound == pits";
  return std::nullopt;
}

/// What has been seen of one kind of sets.
struct Tally {
  std::uint64_t sets = 0;
  std::uint64_t cases = 0;  ///< a set at an order
  std::uint64_t traps = 0;  ///< cases in which choosing ways down alone promises fewer pits than there can be
  std::uint64_t best_worse = 0, best_open = 0;
  std::uint64_t exact_worse = 0, exact_open = 0, invalid = 0;
  double slowest_exact = 0;
};

void print(const char* name, const Tally& t) {
  std::printf(
      "%-20s %6llu sets %7llu cases %6llu traps; best: %llu not optimal, %llu not certified; exact: %llu not "
      "optimal, %llu not certified; %llu invalid; slowest exact %.4f s of processor time\n",
      name, static_cast<unsigned long long>(t.sets), static_cast<unsigned long long>(t.cases),
      static_cast<unsigned long long>(t.traps), static_cast<unsigned long long>(t.best_worse),
      static_cast<unsigned long long>(t.best_open), static_cast<unsigned long long>(t.exact_worse),
      static_cast<unsigned long long>(t.exact_open), static_cast<unsigned long long>(t.invalid),
      t.slowest_exact);
}

/// Runs every method at every order; `misses` gets the cases in which best is not optimal. The bound of all
/// methods but `exact` is the assignment bound, which is neither less nor more than what ways down that do
/// not cross could do regardless of the order of triangles.
void judge(const DrawnSet& set, Tally& tally, std::vector<std::string>& misses) {
  const Enumeration& all = *set.enumeration;
  const Relief relief(set.cloud.elevations());
  const auto fewest = all.fewest_pits(relief);
  const auto regardless = support::fewest_pits_regardless(all, relief);
  ++tally.sets;
  for (unsigned k = 0; k < fewest.size(); ++k) {
    ++tally.cases;
    tally.traps += regardless[k] < fewest[k] ? 1u : 0u;
    for (const Method method : support::kMethods) {
      const std::string name = std::string(support::method_name(method)) + ", order " + std::to_string(k) +
                               ", optimum " + std::to_string(fewest[k]) + ": ";
      const std::clock_t start = std::clock();
      const Minimized m = support::minimize(set.cloud, method, k);
      const double taken = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
      if (const auto wrong = find_wrong(all, relief, m, k, fewest[k])) {
        ++tally.invalid;
        ADD_FAILURE() << name << *wrong << '\n' << printed(set.cloud);
      }
      if (method != Method::exact && m.lower_bound != regardless[k]) {
        ++tally.invalid;
        ADD_FAILURE() << name << "bound " << m.lower_bound << ", not " << regardless[k] << '\n'
                      << printed(set.cloud);
      }
      if (method == Method::best) {
        tally.best_open += m.certified ? 0u : 1u;
        if (m.pits.total != fewest[k]) {
          ++tally.best_worse;
          misses.push_back(name + std::to_string(m.pits.total) + " pits\n" + printed(set.cloud));
        }
      }
      if (method == Method::exact) {
        tally.slowest_exact = std::max(tally.slowest_exact, taken);
        tally.exact_worse += m.pits.total != fewest[k] ? 1u : 0u;
        tally.exact_open += m.certified ? 0u : 1u;
        if (m.pits.total == fewest[k] && m.certified) continue;
        ADD_FAILURE() << name << m.pits.total << " pits, bound " << m.lower_bound << '\n'
                      << printed(set.cloud);
      }
    }
  }
}

/// `exact` attains and proves the optimum always. `best` does so where the sets were not made to trap it, and
/// in all but one case of two thousand where they were.
TEST(Exhaustive, ExactIsOptimalAndCertified) {
  const std::uint64_t sets = support::from_environment("THALWEG_EXACT_SETS", 1500);
  const std::uint64_t seed = support::from_environment("THALWEG_EXACT_SEED", 20090601);
  std::array<Tally, support::kSetKinds> tallies;
  std::vector<std::string> misses;
  std::uint64_t adversarial_cases = 0, adversarial_misses = 0, other_misses = 0;
  for (std::uint64_t i = 0; i < sets && !testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE("THALWEG_EXACT_SEED=" + std::to_string(seed) + ", set " + std::to_string(i));
    const DrawnSet set = support::draw_set(seed, i);
    judge(set, tallies[static_cast<std::size_t>(set.kind)], misses);
  }
  for (std::uint32_t kind = 0; kind < support::kSetKinds; ++kind) {
    const Tally& tally = tallies[kind];
    print(support::set_kind_name(static_cast<support::SetKind>(kind)), tally);
    const bool adversarial = support::is_adversarial(static_cast<support::SetKind>(kind));
    (adversarial ? adversarial_misses : other_misses) += tally.best_worse;
    adversarial_cases += adversarial ? tally.cases : 0;
  }
  for (const std::string& miss : misses) std::printf("%s\n", miss.c_str());
  EXPECT_EQ(other_misses, 0u);
  EXPECT_LE(adversarial_misses, adversarial_cases / 2000);
}

/// Three pits of equal elevation lead to each other round a ring: one of them is left over.
TEST(Exhaustive, LevelPitsDoNotDrainInARing) {
  const support::Cloud cloud{{{0, 1, 3},
                              {1, 0, 0},
                              {3, 0, 5},
                              {0, 4, 4},
                              {2, 4, 6},
                              {4, 3, 3},
                              {4, 1, 1},
                              {0, 2, 5},
                              {3, 4, 0},
                              {4, 2, 0}}};
  const auto sites = oracle::sites_of(std::span<const thalweg::Point3>(cloud.points));
  DrawnSet set{support::SetKind::grid5, cloud, std::make_shared<const Enumeration>(sites)};
  Tally tally;
  std::vector<std::string> misses;
  judge(set, tally, misses);
  EXPECT_EQ(tally.best_worse, 0u);
  EXPECT_EQ(tally.best_open, 0u);
}

template <class Visit>
void for_each_trap(Visit&& visit) {
  const auto first = static_cast<std::uint64_t>(support::SetKind::trap);
  for (std::uint64_t i = 0; i < 10; ++i) {
    const DrawnSet set = support::draw_set(1, first + i * support::kSetKinds);
    SCOPED_TRACE(printed(set.cloud));
    const Relief relief(set.cloud.elevations());
    visit(set, relief);
  }
}

/// They are worth drawing only if choosing ways down alone promises too much on them.
TEST(Exhaustive, TrapsAreTraps) {
  for_each_trap([](const DrawnSet& set, const Relief& relief) {
    EXPECT_NE(support::fewest_pits_regardless(*set.enumeration, relief),
              set.enumeration->fewest_pits(relief));
  });
}

/// Out of time, `exact` has what `best` has; a limit of 0 is none, nor is one that no clock counts to.
TEST(Exhaustive, ExactStopsAtItsTimeLimit) {
  for_each_trap([](const DrawnSet& set, const Relief& relief) {
    const auto fewest = set.enumeration->fewest_pits(relief);
    const auto regardless = support::fewest_pits_regardless(*set.enumeration, relief);
    for (unsigned k = 0; k < fewest.size(); ++k) {
      if (regardless[k] == fewest[k]) continue;
      thalweg::MinimizeOptions options;
      options.order = k;
      options.method = Method::exact;
      options.threads = 1;
      options.time_limit = 1e-9;
      const Minimized cut_short = thalweg::minimize_pits(set.cloud.points, options).value();
      EXPECT_EQ(find_wrong(*set.enumeration, relief, cut_short, k, fewest[k]), std::nullopt);
      EXPECT_FALSE(cut_short.certified);
      for (const double limit : {0.0, 1000.0, 1e10, 1e300}) {
        options.time_limit = limit;
        EXPECT_TRUE(thalweg::minimize_pits(set.cloud.points, options)->certified) << limit;
      }
    }
  });
}

/// Catalan numbers for convex sites.
TEST(Enumeration, CountsTriangulationsOfPolygons) {
  std::vector<oracle::Site> sites;
  std::vector<std::size_t> counts;
  for (std::int64_t i = 0; i < 11; ++i) {
    sites.push_back({i, i * i, 0});
    if (i >= 2) counts.push_back(Enumeration(sites).all().size());
  }
  EXPECT_EQ(counts, (std::vector<std::size_t>{1, 2, 5, 14, 42, 132, 429, 1430, 4862}));
}

/// The truth files came from another enumeration, written apart from this one.
TEST(Enumeration, AgreesWithTheFiles) {
  for (const char* file : {"exhaustive.jsonl", "adversarial.jsonl"}) {
    for (const support::Truth& truth : support::read_truth(file)) {
      SCOPED_TRACE(printed(truth.cloud));
      const auto sites = oracle::sites_of(std::span<const thalweg::Point3>(truth.cloud.points));
      const Enumeration all(sites);
      ASSERT_EQ(all.all().size(), truth.triangulations);
      const auto fewest = all.fewest_pits(Relief(truth.cloud.elevations()));
      ASSERT_EQ(fewest, (std::vector<unsigned>(truth.min_pits.begin(), truth.min_pits.end())));
      for (const support::Truth::Useful& pair : truth.useful) {
        const unsigned order = all.least_order(oracle::edge(pair.u, pair.v));
        ASSERT_EQ(order == oracle::kNoOrder ? -1 : static_cast<int>(order), pair.order);
      }
    }
  }
}

}  // namespace
