/// The stages of each predicate, cheapest first, each callable alone so that tests can ask which one decides:
///
///     filter   doubles and a bound on their error                      predicates_inline.hpp
///     products doubles, and a bound from every product in the sum      (incircle only)
///     grid     doubles, where no operation rounded: small lattices     (incircle only)
///     words    integers of 64, 128 and 256 bits
///     exact    integers of thousands of bits; always decides
///
/// Departure from Shewchuk 1997, whose expansions this design began with: where the coordinates span at most
/// 61 bits, as nearly all real ones do, integers of four words give the exact sign in a tenth of the time;
/// the rest is rare.
#pragma once

#include <optional>

#include "thalweg/point.hpp"

namespace thalweg::detail {

/// A sign, or nothing where the stage cannot tell. A sign is always the true one.
using MaybeSign = std::optional<int>;

MaybeSign incircle_products(Point2 a, Point2 b, Point2 c, Point2 d) noexcept;
MaybeSign incircle_grid(Point2 a, Point2 b, Point2 c, Point2 d) noexcept;

MaybeSign orient2d_words(Point2 a, Point2 b, Point2 c) noexcept;
MaybeSign incircle_words(Point2 a, Point2 b, Point2 c, Point2 d) noexcept;
MaybeSign compare_distance_words(Point2 a, Point2 b, Point2 c) noexcept;

int orient2d_exact(Point2 a, Point2 b, Point2 c) noexcept;
int incircle_exact(Point2 a, Point2 b, Point2 c, Point2 d) noexcept;
int compare_distance_exact(Point2 a, Point2 b, Point2 c) noexcept;

}  // namespace thalweg::detail
