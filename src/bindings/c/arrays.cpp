/// Checks of arrays, and the words for what is wrong with them.
#include "bindings/c/arrays.hpp"

#include <cmath>
#include <string>

#include "bindings/c/guard.hpp"
#include "thalweg/id.hpp"

namespace thalweg::bindings {

std::optional<Error> check_array(const void* array, std::size_t count, std::size_t alignment,
                                 const char* name) {
  if (count == 0) return std::nullopt;
  if (array == nullptr) return usage(std::string(name) + " is null");
  if (reinterpret_cast<std::uintptr_t>(array) % alignment != 0) {
    return usage(std::string(name) + " is not aligned to its elements");
  }
  return std::nullopt;
}

std::optional<Error> check_output(const void* array, std::size_t capacity, std::size_t needed,
                                  std::size_t alignment, const char* name) {
  if (capacity < needed) {
    return usage(std::string(name) + " has room for " + std::to_string(capacity) + " elements and needs " +
                 std::to_string(needed));
  }
  return check_array(array, needed, alignment, name);
}

std::optional<Error> check_finite(const double* numbers, std::size_t rows, std::size_t width,
                                  const char* what) {
  constexpr std::size_t kNamed = THALWEG_ERROR_ROWS;
  Error error{ErrorCode::not_finite, "", {}};
  for (std::size_t row = 0; row < rows && error.rows.size() < kNamed; ++row) {
    for (std::size_t i = 0; i < width; ++i) {
      if (std::isfinite(numbers[row * width + i])) continue;
      error.rows.push_back(static_cast<std::uint32_t>(row));
      break;
    }
  }
  if (error.rows.empty()) return std::nullopt;
  error.message = std::string(what) + " " + std::to_string(error.rows[0]) + " is NaN or infinite";
  return error;
}

std::optional<Error> check_count(std::size_t count, const char* what) {
  if (count < VertexId::kInvalid) return std::nullopt;
  return Error{ErrorCode::too_many_points,
               std::to_string(count) + " " + what + " are more than 32-bit ids can number",
               {}};
}

}  // namespace thalweg::bindings
