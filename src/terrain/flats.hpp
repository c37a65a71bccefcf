/// Pits asked for locally: is there one at this vertex, how many touch these vertices?
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "terrain/surface.hpp"

namespace thalweg::detail {

/// Floods flats of a changing triangulation of a surface. Holds scratch memory of 4 bytes a site.
class FlatSearch {
 public:
  explicit FlatSearch(const Surface& surface) : surface_(&surface), stamp_(surface.sites().size(), 0u) {}

  /// Whether v lies on a pit of t; if so, `flat()` is that pit. Complexity: O(size of the flat), less if it
  /// drains.
  bool on_pit(const Triangulation& t, VertexId v);

  /// The number of pits of t that have a vertex among `vertices`. An edit that changes no edge but between
  /// these vertices changes the total by as much as it changes this: a flat without any of them keeps its
  /// vertices and neighbours, and every part into which another one falls has one of them.
  std::uint32_t pits_touching(const Triangulation& t, std::span<const VertexId> vertices);

  /// Whether so many vertices have been flooded that whoever searches on should stop: a hundred a site and
  /// some more. Real terrain needs a few a site; with level ground almost everywhere a search could go round
  /// in a huge lake for hours.
  bool exhausted() const noexcept { return visits_ > 2'000'000 + 20 * std::uint64_t{stamp_.size()}; }

  /// The vertices of the pit that `on_pit` has found, in no particular order.
  std::span<const VertexId> flat() const noexcept { return flat_; }

 private:
  void next_epoch();
  bool flood(const Triangulation& t, VertexId v);

  const Surface* surface_;
  Array<std::uint32_t> stamp_;  // epoch: seen; epoch + 1: seen, and it drains
  std::vector<VertexId> flat_;
  std::uint32_t epoch_ = 0;
  std::uint64_t visits_ = 0;
};

}  // namespace thalweg::detail
