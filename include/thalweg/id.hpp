/// Ids: four bytes each, one type per kind of element, so that a face can never be passed for a vertex.
#pragma once

#include <compare>
#include <cstdint>
#include <functional>

namespace thalweg {

/// The index of one element of kind `Tag`. Default-constructed = invalid. Ordered by index, the invalid id
/// last; hashable. Laws: Id(i).index() == i; ids of different tags never convert or compare. All is O(1).
template <class Tag>
class Id {
 public:
  /// The index of the invalid id.
  static constexpr std::uint32_t kInvalid = 0xffffffffu;

  /// The invalid id.
  constexpr Id() noexcept = default;
  /// The id of the element at this position; invalid for kInvalid.
  explicit constexpr Id(std::uint32_t index) noexcept : index_(index) {}

  /// The position of the element in the arrays of its owner. Meaningless unless `valid()`.
  constexpr std::uint32_t index() const noexcept { return index_; }
  /// Whether it names an element: false for the invalid id alone.
  constexpr bool valid() const noexcept { return index_ != kInvalid; }

  /// By index, the invalid id last.
  friend constexpr auto operator<=>(Id, Id) noexcept = default;

 private:
  std::uint32_t index_ = kInvalid;
};

using VertexId = Id<struct VertexTag>;      ///< a vertex: in all results the index of the caller's point
using HalfedgeId = Id<struct HalfedgeTag>;  ///< a half-edge of a Triangulation
using FaceId = Id<struct FaceTag>;          ///< a triangle of a Triangulation

}  // namespace thalweg

/// @cond
template <class Tag>
struct std::hash<thalweg::Id<Tag>> {
  std::size_t operator()(thalweg::Id<Tag> id) const noexcept {
    return std::hash<std::uint32_t>{}(id.index());
  }
};
/// @endcond
