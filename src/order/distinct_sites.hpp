/// A short list of sites, each once: one side of a sleeve.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "thalweg/id.hpp"

namespace thalweg::detail {

/// Appends, asks and shrinks; a walk does one of these at every step, with a handful of sites in the list.
class DistinctSites {
 public:
  std::size_t size() const noexcept { return size_; }
  VertexId operator[](std::size_t i) const noexcept { return sites_[i]; }
  operator std::span<const VertexId>() const noexcept { return std::span(sites_).first(size_); }

  /// Whether v is in the list. Complexity: O(size), eight sites at a time.
  bool contains(VertexId v) const noexcept {
    for (std::size_t i = 0; i < size_; i += kBlock) {
      std::uint32_t found = 0;  // as wide as an id, so that compilers compare four at a time
      for (std::size_t j = 0; j < kBlock; ++j) found |= sites_[i + j].index() == v.index() ? 1u : 0u;
      if (found != 0) return true;
    }
    return false;
  }

  void add(VertexId v) {
    if (contains(v)) return;
    if (size_ == sites_.size()) sites_.resize(2 * sites_.size());
    sites_[size_++] = v;
  }

  /// Keeps the first `size` sites.
  void shrink(std::size_t size) noexcept {
    std::fill(sites_.begin() + static_cast<std::ptrdiff_t>(size),
              sites_.begin() + static_cast<std::ptrdiff_t>(size_), VertexId());
    size_ = size;
  }

  /// Holds v alone.
  void restart(VertexId v) noexcept {
    shrink(0);
    sites_[size_++] = v;
  }

 private:
  static constexpr std::size_t kBlock = 8;
  std::vector<VertexId> sites_ = std::vector<VertexId>(2 * kBlock);  // whole blocks; invalid beyond size_
  std::size_t size_ = 0;
};

}  // namespace thalweg::detail
