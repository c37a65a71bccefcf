/// A long merge on several threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "kernel/edges_across.hpp"
#include "kernel/seam.hpp"

namespace thalweg::detail {

/// The seam between two parts, cut in pieces at edges that are known to cross it.
///
/// The triangles of a part that such an edge crosses have to go, whatever happens on both sides of it: once
/// they have, the seam can rise from every edge at the same time, to the next one. The arrays become those of
/// a single rise. For the triangles that a merge removes from a part make trees that hang from its hull, by
/// the edges that are removed (else the sites were no longer connected in the part; but each keeps an edge to
/// one that is further from the other part), so each has one edge by which it is opened, and what becomes of
/// its slot does not depend on the order.
///
/// Both ends of each edge are on the hulls of their parts. So it cuts both parts in two, and pieces of the
/// seam have no two triangles with a common side, and nothing that both write to.
class SeamSplit {
 public:
  /// With fewer edges than `least_edges` there is but one piece.
  SeamSplit(const PartArrays& mesh, const TwoParts& parts, unsigned threads, std::size_t least_edges) noexcept
      : mesh_(mesh), parts_(parts), threads_(threads), least_edges_(least_edges) {}

  /// Finds the edges and opens their way. Afterwards the hulls are no longer convex.
  void open();

  /// The seam, raised to the upper common tangent. To be called once.
  Seam rise(const Seam& seam);

 private:
  std::uint32_t facing(std::uint32_t site, std::uint32_t target) const noexcept;
  void open_way(std::uint32_t site, std::uint32_t target, std::vector<std::uint32_t>& exits) const;

  PartArrays mesh_;
  TwoParts parts_;
  unsigned threads_;
  std::size_t least_edges_;
  std::vector<Seam> starts_;  ///< with an edge across as their base
};

}  // namespace thalweg::detail
