/// Distinct points in the kernel's order, and what divide and conquer makes of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "kernel/divide_and_conquer.hpp"
#include "kernel/spatial_order.hpp"

namespace support {

inline std::vector<thalweg::Point2> sites_in_order(const std::vector<thalweg::Point2>& points,
                                                   const thalweg::detail::SpatialOrder& order) {
  std::vector<thalweg::Point2> sites;
  for (std::uint32_t s = 0; s < order.site_count(); ++s) sites.push_back(points[order.first_row(s)]);
  return sites;
}

struct OrderedSites {
  std::vector<thalweg::Point2> sites;
  thalweg::detail::Array<std::uint32_t> keys;

  explicit OrderedSites(const std::vector<thalweg::Point2>& points) {
    auto order = thalweg::detail::spatial_order(points, 1);
    sites = sites_in_order(points, order);
    keys = std::move(order.keys);
  }
};

/// As many pieces as can be, and every merge in as many.
inline thalweg::detail::Sharing shared_everywhere(unsigned threads) {
  return {.threads = threads, .least_piece = 6, .least_edges = 1};
}

/// All words of the arrays that mean something. Requires: 2 sites or more.
inline std::vector<std::uint32_t> words_of(const OrderedSites& ordered,
                                           const thalweg::detail::Sharing& sharing) {
  const auto mesh = thalweg::detail::divide_and_conquer(ordered.sites, ordered.keys, sharing);
  std::vector<std::uint32_t> words;
  for (std::size_t i = 0; i < mesh.origin.size(); ++i) {
    if (i % 4 == 3) continue;
    words.push_back(mesh.origin[i]);
    words.push_back(mesh.twin[i]);
  }
  return words;
}

}  // namespace support
