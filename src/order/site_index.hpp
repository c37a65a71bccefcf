/// From a place to a site near it, in O(log n): where walks in a diagram start.
///
/// Levels of Delaunay graphs, each over every 24th site of the one below in spatial order; on each level a
/// walk goes from site to nearer site, until no neighbour is nearer. All in doubles: the answer is a hint,
/// nearly always the nearest site, and nothing depends on it but time.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "thalweg/point.hpp"
#include "thalweg/triangulation.hpp"

namespace thalweg::detail {

class SiteIndex {
 public:
  /// Sites in spatial order, at least one, and their Delaunay triangulation (nullptr if there is none). Keeps
  /// copies of what it needs: 46 bytes a site.
  SiteIndex(std::span<const Point2> sites, const Triangulation* delaunay);

  /// The number of a site near q. Not finite q: any site.
  std::uint32_t near(Point2 q) const noexcept;

  std::span<const Point2> sites() const noexcept { return levels_.front().sites; }
  std::size_t memory_bytes() const noexcept;

 private:
  struct Level {
    std::vector<Point2> sites;
    std::vector<std::uint32_t> starts;  ///< of each site's neighbours
    std::vector<std::uint32_t> neighbors;
    std::vector<std::uint32_t> below;  ///< number of each site one level below; empty on the lowest
  };

  static void join(Level& level, const Triangulation& delaunay);
  static void join_in_line(Level& level);
  static std::uint32_t descend(const Level& level, std::uint32_t site, Point2 q) noexcept;

  std::vector<Level> levels_;  ///< from all sites to few
  Point2 centre_;
  double radius_ = 0;
};

}  // namespace thalweg::detail
