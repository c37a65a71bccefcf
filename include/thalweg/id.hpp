/// Ids: four bytes each, one type per kind of element, so that a face can never be passed for a vertex.
#pragma once

#include <compare>
#include <cstdint>
#include <functional>

namespace thalweg {

/// The index of one element of kind `Tag`. Default-constructed = invalid. Ordered by index, the invalid id
/// last. Laws: Id(i).index() == i; ids of different tags never convert or compare.
template <class Tag>
class Id {
 public:
  static constexpr std::uint32_t kInvalid = 0xffffffffu;

  constexpr Id() noexcept = default;
  explicit constexpr Id(std::uint32_t index) noexcept : index_(index) {}

  /// The position of the element in the arrays of its owner. Meaningless unless `valid()`.
  constexpr std::uint32_t index() const noexcept { return index_; }
  constexpr bool valid() const noexcept { return index_ != kInvalid; }

  friend constexpr auto operator<=>(Id, Id) noexcept = default;

 private:
  std::uint32_t index_ = kInvalid;
};

using VertexId = Id<struct VertexTag>;
using HalfedgeId = Id<struct HalfedgeTag>;
using FaceId = Id<struct FaceTag>;

}  // namespace thalweg

template <class Tag>
struct std::hash<thalweg::Id<Tag>> {
  std::size_t operator()(thalweg::Id<Tag> id) const noexcept {
    return std::hash<std::uint32_t>{}(id.index());
  }
};
