/// Running minimize_pits in tests, and what must hold for every result.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "oracle/terrain.hpp"
#include "support/prepared.hpp"

namespace support {

inline constexpr thalweg::Method kMethods[] = {thalweg::Method::delaunay, thalweg::Method::flip,
                                               thalweg::Method::hull, thalweg::Method::best,
                                               thalweg::Method::exact};

inline const char* method_name(thalweg::Method method) {
  switch (method) {
    case thalweg::Method::delaunay:
      return "delaunay";
    case thalweg::Method::flip:
      return "flip";
    case thalweg::Method::hull:
      return "hull";
    case thalweg::Method::best:
      return "best";
    case thalweg::Method::exact:
      return "exact";
  }
  return "?";
}

inline thalweg::Minimized minimize(const Cloud& cloud, thalweg::Method method, unsigned order,
                                   unsigned threads = 1) {
  thalweg::MinimizeOptions options;
  options.order = order;
  options.method = method;
  options.threads = threads;
  options.keep_trail = true;
  return thalweg::minimize_pits(cloud.points, options).value();
}

inline thalweg::PitCount count_of(const std::vector<oracle::Pit>& pits) {
  thalweg::PitCount count;
  for (const oracle::Pit& pit : pits) {
    ++count.total;
    ++(pit.boundary ? count.boundary : count.interior);
  }
  return count;
}

/// Elevation order: (z, x, y).
inline bool lower(const oracle::Site& a, const oracle::Site& b) {
  if (a.z != b.z) return a.z < b.z;
  if (a.x != b.x) return a.x < b.x;
  return a.y < b.y;
}

/// The first of a pit in elevation order.
inline std::uint32_t name_of(const std::vector<oracle::Site>& s, const oracle::Pit& pit) {
  return *std::min_element(pit.vertices.begin(), pit.vertices.end(),
                           [&](std::uint32_t a, std::uint32_t b) { return lower(s[a], s[b]); });
}

/// What is wrong with a result at order k by the definitions, or nothing. The cloud has no duplicates.
inline std::optional<std::string> find_lie(const Cloud& cloud, const thalweg::Minimized& m, unsigned k) {
  const auto sites = oracle::sites_of(std::span<const thalweg::Point3>(cloud.points));
  const auto triangles = triangles_of(m.triangulation);
  if (m.triangulation.find_fault()) return "broken links: " + *m.triangulation.find_fault();
  if (!oracle::is_triangulation(sites, triangles)) return "not a triangulation of the rows";
  if (!thalweg::find_faults(cloud.places(), triangles).empty()) return "find_faults disagrees";
  if (m.face_orders.size() != triangles.size()) return "one order a face";
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const unsigned order = oracle::triangle_order(sites, triangles[i]);
    if (order > k) return "a triangle of order " + std::to_string(order);
    if (m.face_orders[i] != order) return "face_orders: " + std::to_string(m.face_orders[i]) + " is wrong";
  }
  const auto pits = oracle::pits(sites, triangles);
  if (m.pits != count_of(pits)) return "pits are " + std::to_string(pits.size());
  const auto before_triangles = triangles_of(thalweg::delaunay(cloud.places()).value());
  const auto before = oracle::pits(sites, before_triangles);
  if (m.delaunay_pits != count_of(before)) return "Delaunay pits are " + std::to_string(before.size());
  if (m.pits.total > m.delaunay_pits.total) return "more pits than before";
  if (m.lower_bound > m.pits.total) return "lower bound above the result";
  if (m.certified != (m.lower_bound == m.pits.total)) return "certified is not bound == pits";
  if (m.sites != cloud.size() || !m.merged.empty() || !m.mean_elevations.empty()) return "merged nothing";

  const auto edges = oracle::edges_of(triangles), edges_before = oracle::edges_of(before_triangles);
  std::vector<oracle::Pair> fresh;
  std::set_difference(edges.begin(), edges.end(), edges_before.begin(), edges_before.end(),
                      std::back_inserter(fresh));
  if (m.edges_changed != fresh.size()) return "edges changed: " + std::to_string(fresh.size());
  std::uint32_t bad = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t j = 0; j < triangles.size(); ++j) {
      const auto shared = std::count_if(triangles[j].begin(), triangles[j].end(), [&](auto v) {
        return std::count(triangles[i].begin(), triangles[i].end(), v) > 0;
      });
      if (i >= j || shared != 2) continue;
      const auto& t = triangles[i];
      bad += std::any_of(triangles[j].begin(), triangles[j].end(),
                         [&](auto v) {
                           return oracle::in_circle(sites[t[0]], sites[t[1]], sites[t[2]], sites[v]) > 0;
                         })
                 ? 1u
                 : 0u;
    }
  }
  if (m.non_delaunay_edges != bad) return "non-Delaunay edges: " + std::to_string(bad);
  return std::nullopt;
}

/// What is wrong with the reasons of the remaining pits and the list of removed ones, or nothing.
inline std::optional<std::string> find_wrong_reason(const Cloud& cloud, const thalweg::Minimized& m,
                                                    unsigned k) {
  const auto sites = oracle::sites_of(std::span<const thalweg::Point3>(cloud.points));
  auto pits = oracle::pits(sites, triangles_of(m.triangulation));
  std::sort(pits.begin(), pits.end(), [&](const oracle::Pit& a, const oracle::Pit& b) {
    return name_of(sites, a) < name_of(sites, b);
  });
  if (m.remaining.size() != pits.size()) return "remaining is not the list of pits";
  for (std::size_t i = 0; i < pits.size(); ++i) {
    const thalweg::RemainingPit& r = m.remaining[i];
    const std::string name = "pit at " + std::to_string(r.vertex.index()) + ": ";
    if (r.vertex.index() != name_of(sites, pits[i])) return name + "wrong vertex";
    if (r.vertices != pits[i].vertices.size() || r.boundary != pits[i].boundary) return name + "wrong extent";
    std::optional<unsigned> needed;  // least order of a pair to lower, or other equal, ground
    for (const std::uint32_t u : pits[i].vertices) {
      for (std::uint32_t v = 0; v < sites.size(); ++v) {
        if (std::binary_search(pits[i].vertices.begin(), pits[i].vertices.end(), v)) continue;
        if (sites[v].z > sites[u].z) continue;
        const auto order = oracle::useful_order(sites, u, v);
        if (order && (!needed || *order < *needed)) needed = order;
      }
    }
    const bool possible = needed && *needed <= k;
    if ((r.reason == thalweg::PitReason::unremovable) == possible) return name + "wrong reason";
    if (r.order_needed && r.order_needed != needed) {
      return name + "needs order " + (needed ? std::to_string(*needed) : "none") + ", not " +
             std::to_string(*r.order_needed);
    }
    if (!r.order_needed && needed && *needed <= m.order_searched) {
      return name + "needs order " + std::to_string(*needed) + ", within what was searched";
    }
  }
  const auto before = oracle::pits(sites, triangles_of(thalweg::delaunay(cloud.places()).value()));
  std::vector<std::uint32_t> gone, reported;
  for (const oracle::Pit& pit : before) {
    const bool left = std::any_of(pits.begin(), pits.end(), [&](const oracle::Pit& after) {
      return std::any_of(after.vertices.begin(), after.vertices.end(), [&](std::uint32_t v) {
        return std::binary_search(pit.vertices.begin(), pit.vertices.end(), v);
      });
    });
    if (!left) gone.push_back(name_of(sites, pit));
  }
  std::sort(gone.begin(), gone.end());
  for (const thalweg::RemovedPit& pit : m.removed) reported.push_back(pit.vertex.index());
  if (gone != reported) return "removed is not the list of Delaunay pits that are gone";
  return std::nullopt;
}

}  // namespace support
