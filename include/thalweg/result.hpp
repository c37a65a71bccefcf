/// How the library reports bad data: a value or an error, never an exception, never a print.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace thalweg {

/// What kind of thing went wrong. The library itself gives those down to `cancelled`; those about files are
/// the command's.
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
  ErrorCode code = ErrorCode::invalid_argument;  ///< what kind of thing
  std::string message;                           ///< one sentence in English, without a full stop
  std::vector<std::uint32_t> rows = {};  ///< the rows to blame, ascending; empty if it is none of them
};

/// Either a `T` or an `Error`. True in a condition when it holds a value.
/// Requires: `value`, `*`, `->` only when true; `error` only when false.
template <class T>
class [[nodiscard]] Result {
 public:
  /// A result that holds a value.
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
  /// A result that holds an error.
  Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

  /// Whether it holds a value.
  explicit operator bool() const noexcept { return state_.index() == 0; }

  /// The value. Requires: it holds one.
  T& value() & noexcept { return *std::get_if<0>(&state_); }
  /// The value. Requires: it holds one.
  const T& value() const& noexcept { return *std::get_if<0>(&state_); }
  /// The value. Requires: it holds one.
  T&& value() && noexcept { return std::move(*std::get_if<0>(&state_)); }
  /// The value. Requires: it holds one.
  T& operator*() & noexcept { return value(); }
  /// The value. Requires: it holds one.
  const T& operator*() const& noexcept { return value(); }
  /// The value. Requires: it holds one.
  T&& operator*() && noexcept { return std::move(*this).value(); }
  /// The value. Requires: it holds one.
  T* operator->() noexcept { return &value(); }
  /// The value. Requires: it holds one.
  const T* operator->() const noexcept { return &value(); }

  /// The error. Requires: it holds one.
  const Error& error() const& noexcept { return *std::get_if<1>(&state_); }
  /// The error. Requires: it holds one.
  Error&& error() && noexcept { return std::move(*std::get_if<1>(&state_)); }

 private:
  std::variant<T, Error> state_;
};

}  // namespace thalweg
