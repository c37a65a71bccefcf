/// The words by which options and reports name methods, policies and reasons.
#include "cli/names.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace thalweg::cli {
namespace {

template <class Value, std::size_t N>
using Names = std::array<std::pair<std::string_view, Value>, N>;

constexpr Names<Method, 5> kMethods = {{{"delaunay", Method::delaunay},
                                        {"flip", Method::flip},
                                        {"hull", Method::hull},
                                        {"best", Method::best},
                                        {"exact", Method::exact}}};

constexpr Names<Counter, 2> kCounters = {{{"crawl", Counter::crawl}, {"voronoi", Counter::voronoi}}};

constexpr Names<DuplicatePolicy, 6> kPolicies = {{{"lowest", DuplicatePolicy::lowest},
                                                  {"highest", DuplicatePolicy::highest},
                                                  {"mean", DuplicatePolicy::mean},
                                                  {"first", DuplicatePolicy::first},
                                                  {"last", DuplicatePolicy::last},
                                                  {"error", DuplicatePolicy::error}}};

constexpr Names<PitReason, 3> kReasons = {
    {{"unremovable", PitReason::unremovable}, {"conflict", PitReason::conflict}, {"kept", PitReason::kept}}};

template <class Value, std::size_t N>
std::string_view name_in(const Names<Value, N>& names, Value value) noexcept {
  const auto found = std::ranges::find(names, value, &std::pair<std::string_view, Value>::second);
  return found == names.end() ? std::string_view("unknown") : found->first;
}

template <class Value, std::size_t N>
std::optional<Value> value_in(const Names<Value, N>& names, std::string_view name) noexcept {
  const auto found = std::ranges::find(names, name, &std::pair<std::string_view, Value>::first);
  return found == names.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace

std::string_view name_of(Method method) noexcept {
  return name_in(kMethods, method);
}
std::optional<Counter> parse_counter(std::string_view name) noexcept {
  return value_in(kCounters, name);
}

std::optional<Method> parse_method(std::string_view name) noexcept {
  return value_in(kMethods, name);
}

std::string_view name_of(DuplicatePolicy policy) noexcept {
  return name_in(kPolicies, policy);
}
std::optional<DuplicatePolicy> parse_policy(std::string_view name) noexcept {
  return value_in(kPolicies, name);
}

std::string_view name_of(PitReason reason) noexcept {
  return name_in(kReasons, reason);
}

}  // namespace thalweg::cli
