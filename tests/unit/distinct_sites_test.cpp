/// DistinctSites: each site once, in the order in which they came, however many.
#include "order/distinct_sites.hpp"

#include <gtest/gtest.h>

#include <span>

namespace {

using thalweg::VertexId;
using thalweg::detail::DistinctSites;

VertexId site(std::uint32_t i) {
  return VertexId(7 * i);
}

DistinctSites list_of(std::uint32_t count) {
  DistinctSites list;
  for (std::uint32_t i = 0; i < count; ++i) list.add(site(i));
  return list;
}

/// The list holds the first `count` sites and no others.
void expect_first(const DistinctSites& list, std::uint32_t count) {
  ASSERT_EQ(list.size(), count);
  EXPECT_EQ(std::span<const VertexId>(list).size(), count);
  for (std::uint32_t i = 0; i < 50; ++i) EXPECT_EQ(list.contains(site(i)), i < count) << i << " of " << count;
  for (std::uint32_t i = 0; i < count; ++i) EXPECT_EQ(list[i], site(i));
}

TEST(DistinctSites, HoldsEachSiteOnce) {
  for (std::uint32_t count = 0; count <= 40; ++count) {
    DistinctSites list = list_of(count);
    expect_first(list, count);
    for (std::uint32_t i = 0; i < count; ++i) list.add(site(i));
    expect_first(list, count);
  }
}

TEST(DistinctSites, ForgetsWhatIsCutOff) {
  for (std::uint32_t count = 0; count <= 40; ++count) {
    DistinctSites list = list_of(40);
    list.shrink(count);
    expect_first(list, count);
    list.add(site(count));
    expect_first(list, count + 1);
  }
}

TEST(DistinctSites, RestartsWithOneSite) {
  DistinctSites list = list_of(20);
  list.restart(site(0));
  expect_first(list, 1);
}

}  // namespace
