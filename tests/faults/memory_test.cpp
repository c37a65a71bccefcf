/// Every allocation of the library fails once, alone or with all that follow: std::bad_alloc reaches the
/// caller or the answer is the same, nothing leaks, and what the caller holds is as it was.
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cstring>
#include <functional>
#include <limits>
#include <new>
#include <vector>

#include "io/parallel.hpp"
#include "kernel/parallel.hpp"
#include "support/failing_new.h"
#include "support/random.hpp"
#include "thalweg/thalweg.hpp"

namespace {

using thalweg::Point2;
using thalweg::Point3;
using thalweg::Triangulation;

/// What a run found out, in one number: keeping it needs no memory.
class Digest {
 public:
  Digest& operator<<(std::uint64_t value) {
    sum_ = (sum_ ^ value) * 0x9e3779b97f4a7c15u;
    sum_ ^= sum_ >> 29;
    return *this;
  }
  Digest& operator<<(const Triangulation& t) {
    for (std::uint32_t i = 0; i < t.halfedge_count(); ++i) *this << t.origin(thalweg::HalfedgeId(i)).index();
    return *this << t.vertex_count();
  }
  std::uint64_t value() const { return sum_; }

 private:
  std::uint64_t sum_ = 1;
};

/// Fails the calls of operator new number 0, step, 2 step ... of `run` until it has no more of them. After
/// each, `intact` tells whether the caller's things are as they were.
void fail_each(const std::function<std::uint64_t()>& run, const std::function<bool()>& intact,
               long step = 1) {
  const std::uint64_t answer = run();  // and whatever is made once and kept is made now
  for (void (*const fail)(long) : {fail_one_allocation, fail_allocations}) {
    for (long after = 0;; after += step) {
      const long live = live_allocations();
      bool answered = false;
      std::uint64_t found = 0;
      fail(after);
      try {
        found = run();
        answered = true;
      } catch (const std::bad_alloc&) {
      }
      const long failures = failed_allocations();
      fail_allocations(-1);
      ASSERT_EQ(live_allocations(), live) << "leak after allocation " << after;
      ASSERT_TRUE(intact()) << "after allocation " << after;
      ASSERT_EQ(answered ? found : answer, answer) << "after allocation " << after;
      if (failures == 0) {
        ASSERT_TRUE(answered);
        break;
      }
    }
  }
  EXPECT_EQ(run(), answer);
}

std::vector<Point3> points_of(std::uint32_t count, int side, int levels) {
  support::Random random(count);
  std::vector<Point3> points;
  for (std::uint32_t i = 0; i < count; ++i) {
    points.push_back({random.whole(0, side), random.whole(0, side), random.whole(0, levels)});
  }
  return points;
}

std::vector<Point2> places_of(const std::vector<Point3>& points) {
  std::vector<Point2> places;
  for (const Point3& p : points) places.push_back({p.x, p.y});
  return places;
}

template <class T>
std::function<bool()> unchanged(const std::vector<T>& values) {
  return [&values, copy = values] {
    return std::memcmp(values.data(), copy.data(), values.size() * sizeof(T)) == 0;
  };
}

class Minimizing : public testing::TestWithParam<thalweg::Method> {};

TEST_P(Minimizing, AtEveryAllocation) {
  const auto points = points_of(60, 12, 20);  // duplicates, lattices and flats among them
  for (const auto counter : {thalweg::Counter::crawl, thalweg::Counter::voronoi}) {
    thalweg::MinimizeOptions options;
    options.order = 3;
    options.method = GetParam();
    options.counter = counter;
    options.threads = 1;
    options.keep_trail = true;
    options.duplicates = thalweg::DuplicatePolicy::mean;
    fail_each(
        [&] {
          const auto result = thalweg::minimize_pits(points, options);
          Digest digest;
          digest << result->triangulation << result->lower_bound << result->pits.total;
          return (digest << result->trail.size()).value();
        },
        unchanged(points));
  }
}

INSTANTIATE_TEST_SUITE_P(Memory, Minimizing,
                         testing::Values(thalweg::Method::delaunay, thalweg::Method::flip,
                                         thalweg::Method::hull, thalweg::Method::best,
                                         thalweg::Method::exact));

TEST(Memory, OfManyThreads) {
  const auto points = points_of(9000, 4000, 500);
  thalweg::MinimizeOptions options;
  options.order = 2;
  options.threads = 5;
  for (const auto method : {thalweg::Method::flip, thalweg::Method::best}) {
    options.method = method;
    fail_each([&] { return (Digest() << thalweg::minimize_pits(points, options)->triangulation).value(); },
              unchanged(points), method == thalweg::Method::flip ? 997 : 499);
  }
}

TEST(Memory, OfDelaunayByManyThreads) {
  const auto places = places_of(points_of(70000, 100000, 0));
  fail_each([&] { return (Digest() << *thalweg::delaunay(places, {.threads = 6})).value(); },
            unchanged(places), 3);
}

/// A helper whose thread cannot be made for want of memory leaves its work to the others.
TEST(Memory, OfTheThreadsThemselves) {
  fail_each(
      [] {
        std::atomic<std::uint64_t> sum = 0;
        thalweg::detail::parallel_chunks(
            40, 1, 4, [&] { return [&](std::size_t begin, std::size_t) { sum += begin; }; });
        return sum.load();
      },
      [] { return true; });
  fail_each(
      [] {
        std::atomic<std::uint64_t> sum = 0;
        thalweg::io::run_all(5, [&](std::size_t i) { sum += i; });
        return sum.load();
      },
      [] { return true; });
}

TEST(Memory, OfSweeping) {
  const auto points = points_of(50, 20, 9);
  fail_each(
      [&] {
        const auto sweep = thalweg::sweep_pits(points, 0, 4, {.threads = 1});
        Digest digest;
        for (const auto& row : sweep->rows) digest << row.flip << row.hull << row.best << row.lower_bound;
        return digest.value();
      },
      unchanged(points));
}

TEST(Memory, OfErrors) {
  std::vector<Point3> points = points_of(40, 100, 9);
  points[7].x = std::numeric_limits<double>::infinity();
  const auto code = [&](std::span<const Point3> some) {
    return static_cast<std::uint64_t>(thalweg::minimize_pits(some, {.threads = 1}).error().code);
  };
  fail_each([&] { return code(points); }, unchanged(points));
  fail_each([&] { return code(std::span(points).first(2)); }, unchanged(points));
  const std::vector<Point3> line = {{0, 0, 1}, {1, 1, 1}, {2, 2, 1}, {3, 3, 1}};
  fail_each([&] { return code(line); }, unchanged(line));
}

TEST(Memory, OfOrdersAndPairs) {
  const auto places = places_of(points_of(60, 15, 0));
  fail_each(
      [&] {
        const auto delaunay = *thalweg::delaunay(places);
        const thalweg::DelaunayGraph graph(places, delaunay);
        Digest digest;
        for (const auto& pair : thalweg::useful_pairs(graph, 3, 1)) digest << pair.u.index() << pair.order;
        for (const std::uint32_t order : thalweg::face_orders(graph, delaunay, 3, 1)) digest << order;
        return digest.value();
      },
      unchanged(places));
}

TEST(Memory, OfVoronoiDiagrams) {
  const auto places = places_of(points_of(40, 9, 0));
  fail_each(
      [&] {
        const auto diagram = *thalweg::order_k_voronoi(places, 3, {.threads = 1});
        Digest digest;
        digest << diagram.cell_count();
        for (const auto v : diagram.nearest({4.5, 3})) digest << v.index();
        for (const auto& [u, v] : diagram.delaunay_edges()) digest << u.index() << v.index();
        return digest.value();
      },
      unchanged(places));
}

TEST(Memory, OfWaterAndPits) {
  const auto points = points_of(60, 12, 6);
  const auto places = places_of(points);
  const auto delaunay = *thalweg::delaunay(places);
  std::vector<double> z;
  for (const Point3& p : points) z.push_back(p.z);
  fail_each(
      [&] {
        Digest digest;
        const thalweg::Pits pits = thalweg::find_pits(delaunay, z);
        digest << pits.size() << thalweg::drain(delaunay, points).basins;
        for (const double level : thalweg::spill_levels(delaunay, points, pits))
          digest << (level < 3 ? 1 : 0);
        return digest.value();
      },
      unchanged(points));
}

TEST(Memory, OfValidating) {
  const auto places = places_of(points_of(60, 12, 6));
  const std::vector<std::array<std::uint32_t, 3>> mess = {{0, 1, 2}, {3, 4, 5},  {0, 3, 6},
                                                          {7, 7, 8}, {9, 60, 1}, {0, 1, 2}};
  fail_each([&] { return thalweg::find_faults(places, mess).size(); }, unchanged(mess));
}

TEST(Memory, OfHardInstances) {
  const std::vector<thalweg::LatticeSegment> segments = {{{0, 0}, {10, 7}}, {{0, 9}, {11, -3}}};
  fail_each([&] { return thalweg::theorem1_instance(segments)->points.size(); }, unchanged(segments));
  fail_each([&] { return thalweg::corollary2_instance(segments)->points.size(); }, unchanged(segments), 7);
}

/// Edits that the caller makes: carried out, or nothing has changed.
class Edits : public testing::Test {
 protected:
  void expect_all_or_nothing(const std::function<void(Triangulation&)>& edit) const {
    for (const bool revision : {false, true}) {
      const Triangulation before = revision ? Triangulation::revision_of(lattice_) : lattice_;
      Triangulation after = before;
      edit(after);
      for (long at = 0;; ++at) {
        Triangulation t = before;
        const long live = live_allocations();
        fail_one_allocation(at);
        try {
          edit(t);
        } catch (const std::bad_alloc&) {
        }
        const long failures = failed_allocations();
        fail_allocations(-1);
        ASSERT_TRUE(t == (failures == 0 ? after : before)) << "allocation " << at;
        if (failures == 0) break;
        edit(t);  // and it can still be edited
        ASSERT_TRUE(t == after) << "allocation " << at;
        ASSERT_GE(live_allocations(), live);
      }
    }
  }

  std::vector<Point2> places_ = {{0, 0}, {4, 0}, {9, 1},  {13, 0}, {0, 5},
                                 {5, 4}, {9, 6}, {12, 5}, {1, 9},  {6, 9}};
  Triangulation lattice_ = *thalweg::delaunay(places_);
};

TEST_F(Edits, FlipIsDoneOrNot) {
  for (std::uint32_t i = 0; i < lattice_.halfedge_count(); ++i) {
    if (lattice_.on_hull(thalweg::HalfedgeId(i))) continue;
    expect_all_or_nothing([&](Triangulation& t) { t.flip(thalweg::HalfedgeId(i)); });
  }
}

TEST_F(Edits, ReplacingIsDoneOrNot) {
  for (std::uint32_t i = 0; i < lattice_.halfedge_count(); ++i) {
    const thalweg::HalfedgeId h(i), twin = lattice_.twin(h);
    if (lattice_.on_hull(h)) continue;
    const auto a = lattice_.origin(h), b = lattice_.dest(h), c = lattice_.apex(h), d = lattice_.apex(twin);
    const std::array olds = {Triangulation::face(h), Triangulation::face(twin)};
    const std::array<thalweg::Triangle, 2> news = {{{d, c, a}, {c, d, b}}};
    expect_all_or_nothing([&](Triangulation& t) { t.replace(olds, news); });
  }
}

TEST_F(Edits, AssigningIsDoneOrNot) {
  const Triangulation other = *thalweg::delaunay(std::span(places_).first(7));
  expect_all_or_nothing([&](Triangulation& t) { t = other; });
}

TEST(Memory, OfAddingAPit) {
  thalweg::Pits pits;
  const std::array vertices = {thalweg::VertexId(3), thalweg::VertexId(8)};
  for (std::uint32_t i = 0; i < 20; ++i) {
    for (long at = 0;; ++at) {
      fail_one_allocation(at);
      bool added = true;
      try {
        pits.add(vertices, i % 2 == 0);
      } catch (const std::bad_alloc&) {
        added = false;
      }
      fail_allocations(-1);
      ASSERT_EQ(pits.size(), added ? i + 1 : i);
      if (added) break;
    }
    for (std::uint32_t j = 0; j <= i; ++j) ASSERT_EQ(pits[j].size(), 2u);
  }
}

/// A counter of circles that ran out of memory counts right afterwards.
TEST(Memory, OfACounterInUse) {
  const auto places = places_of(points_of(400, 1000, 0));
  const auto delaunay = *thalweg::delaunay(places);
  const thalweg::DelaunayGraph graph(places, delaunay);
  for (std::uint32_t f = 0; f < delaunay.face_count(); f += 37) {
    const auto [u, v, w] = delaunay.corners(thalweg::FaceId(f));
    const auto across = delaunay.corners(thalweg::FaceId((f + 200) % delaunay.face_count()))[0];
    if (across == u || across == v ||
        thalweg::orient2d(places[u.index()], places[v.index()], places[across.index()]) <= 0)
      continue;
    thalweg::CircleCounter fresh(graph);
    const unsigned expected = fresh.count_in_circle(u, v, across, 300);
    thalweg::CircleCounter counter(graph);
    for (long at = 0;; ++at) {
      fail_one_allocation(at);
      try {
        static_cast<void>(counter.count_in_circle(u, v, across, 300));
      } catch (const std::bad_alloc&) {
      }
      const long failures = failed_allocations();
      fail_allocations(-1);
      ASSERT_EQ(counter.count_in_circle(u, v, across, 300), expected);
      if (failures == 0) break;
    }
  }
}

}  // namespace
