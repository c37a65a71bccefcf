/// Arrays of C: looked at before they are used.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "thalweg/point.hpp"
#include "thalweg/result.hpp"

namespace thalweg::bindings {

/// Whether the array can be read at all; `name` is for the message.
std::optional<Error> check_array(const void* array, std::size_t count, std::size_t alignment,
                                 const char* name);

/// Whether `needed` elements can be written into it.
std::optional<Error> check_output(const void* array, std::size_t capacity, std::size_t needed,
                                  std::size_t alignment, const char* name);

/// The same for a typed array.
template <class T>
std::optional<Error> check_input(const T* array, std::size_t count, const char* name) {
  return check_array(array, count, alignof(T), name);
}
template <class T>
std::optional<Error> check_room(const T* array, std::size_t capacity, std::size_t needed, const char* name) {
  return check_output(array, capacity, needed, alignof(T), name);
}

/// An error that names the first rows with a number that is NaN or infinite; a row has `width` numbers.
/// `what` is what a row is called.
std::optional<Error> check_finite(const double* numbers, std::size_t rows, std::size_t width,
                                  const char* what);

/// An error if there are more than ids can number. `what` is what they are called, in the plural.
std::optional<Error> check_count(std::size_t count, const char* what);

/// The caller's doubles as points. Requires: checked by check_input.
static_assert(sizeof(Point2) == 2 * sizeof(double) && alignof(Point2) == alignof(double));
static_assert(sizeof(Point3) == 3 * sizeof(double) && alignof(Point3) == alignof(double));
inline std::span<const Point2> points2(const double* xy, std::size_t n) noexcept {
  return {reinterpret_cast<const Point2*>(xy), n};
}
inline std::span<const Point3> points3(const double* xyz, std::size_t n) noexcept {
  return {reinterpret_cast<const Point3*>(xyz), n};
}

/// The number of threads for a caller's wish. More than this many never help, and each costs memory.
inline constexpr std::uint32_t kMostThreads = 1024;
constexpr unsigned threads_for(std::uint32_t asked) noexcept {
  return asked < kMostThreads ? asked : kMostThreads;
}

}  // namespace thalweg::bindings
