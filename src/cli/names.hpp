/// The words by which options and reports name methods, policies and reasons: part of the contract.
#pragma once

#include <optional>
#include <string_view>

#include "thalweg/minimize.hpp"

namespace thalweg::cli {

/// delaunay, flip, hull, best, exact.
std::string_view name_of(Method method) noexcept;
std::optional<Method> parse_method(std::string_view name) noexcept;
/// crawl, voronoi.
std::optional<Counter> parse_counter(std::string_view name) noexcept;

/// lowest, highest, mean, first, last, error.
std::string_view name_of(DuplicatePolicy policy) noexcept;
std::optional<DuplicatePolicy> parse_policy(std::string_view name) noexcept;

/// unremovable, conflict, kept.
std::string_view name_of(PitReason reason) noexcept;

/// For messages: every legal name, separated by commas.
inline constexpr std::string_view kMethodNames = "delaunay, flip, hull, best, exact";
inline constexpr std::string_view kPolicyNames = "lowest, highest, mean, first, last, error";

}  // namespace thalweg::cli
