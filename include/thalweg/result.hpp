/// How the library reports bad data: a value or an error, never an exception, never a print.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace thalweg {

enum class ErrorCode {
  too_few_points,    ///< fewer than three distinct sites
  all_collinear,     ///< every site on one line: there is no triangle
  not_finite,        ///< a coordinate is NaN or infinite
  duplicate_points,  ///< the same (x, y) twice where the policy forbids it
  too_many_points,   ///< more than ids can number
  invalid_argument,  ///< an option outside its range
  invalid_mesh,      ///< triangles that do not form a triangulation
  cancelled,         ///< the caller asked to stop
  unreadable,        ///< a file that cannot be opened or read
  malformed,         ///< a file whose content is not what its format says
  exists,            ///< an output that is there already and may not be replaced
  unwritable,        ///< an output that cannot be written
};

/// What went wrong, in words for a person, and which of the caller's rows (from 0) are to blame, if any.
struct Error {
  ErrorCode code = ErrorCode::invalid_argument;
  std::string message;
  std::vector<std::uint32_t> rows = {};
};

/// Either a `T` or an `Error`. True in a condition when it holds a value.
/// Requires: `value`, `*`, `->` only when true; `error` only when false.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
  Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

  explicit operator bool() const noexcept { return state_.index() == 0; }

  T& value() & noexcept { return *std::get_if<0>(&state_); }
  const T& value() const& noexcept { return *std::get_if<0>(&state_); }
  T&& value() && noexcept { return std::move(*std::get_if<0>(&state_)); }
  T& operator*() & noexcept { return value(); }
  const T& operator*() const& noexcept { return value(); }
  T&& operator*() && noexcept { return std::move(*this).value(); }
  T* operator->() noexcept { return &value(); }
  const T* operator->() const noexcept { return &value(); }

  const Error& error() const& noexcept { return *std::get_if<1>(&state_); }
  Error&& error() && noexcept { return std::move(*std::get_if<1>(&state_)); }

 private:
  std::variant<T, Error> state_;
};

}  // namespace thalweg
