/// The stages of each predicate, cheapest first, each callable alone so that tests can ask which one decides.
#pragma once

#include <optional>

#include "thalweg/point.hpp"

namespace thalweg::detail {

/// A sign, or nothing where the stage cannot tell.
using MaybeSign = std::optional<int>;

int orient2d_exact(Point2 a, Point2 b, Point2 c) noexcept;
int incircle_exact(Point2 a, Point2 b, Point2 c, Point2 d) noexcept;
int compare_distance_exact(Point2 a, Point2 b, Point2 c) noexcept;

}  // namespace thalweg::detail
