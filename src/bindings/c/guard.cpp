/// Statuses and messages as C sees them.
#include "bindings/c/guard.hpp"

#include <algorithm>
#include <cstring>

#include "bindings/c/structs.hpp"
#include "cli/exit_code.hpp"
#include "thalweg/version.hpp"

namespace thalweg::bindings {
namespace {

using cli::ExitCode;
static_assert(THALWEG_INTERNAL == static_cast<int>(ExitCode::internal));
static_assert(THALWEG_USAGE == static_cast<int>(ExitCode::usage));
static_assert(THALWEG_BAD_INPUT == static_cast<int>(ExitCode::bad_input));
static_assert(THALWEG_VERIFICATION == static_cast<int>(ExitCode::verification));
static_assert(THALWEG_OUT_OF_MEMORY == static_cast<int>(ExitCode::resources));
static_assert(THALWEG_OUTPUT_REFUSED == static_cast<int>(ExitCode::output));
static_assert(THALWEG_CANCELLED == static_cast<int>(ExitCode::interrupted));

constexpr std::size_t kErrorSize = offsetof(thalweg_error, message) + sizeof(thalweg_error::message);
static_assert(kErrorSize == sizeof(thalweg_error),
              "what is added next must not lie in older callers' padding");

std::int32_t code_of(ErrorCode code) noexcept {
  switch (code) {
    case ErrorCode::too_few_points:
      return THALWEG_ERROR_TOO_FEW_POINTS;
    case ErrorCode::all_collinear:
      return THALWEG_ERROR_ALL_COLLINEAR;
    case ErrorCode::not_finite:
      return THALWEG_ERROR_NOT_FINITE;
    case ErrorCode::duplicate_points:
      return THALWEG_ERROR_DUPLICATE_POINTS;
    case ErrorCode::too_many_points:
      return THALWEG_ERROR_TOO_MANY_POINTS;
    case ErrorCode::invalid_argument:
      return THALWEG_ERROR_INVALID_ARGUMENT;
    case ErrorCode::invalid_mesh:
      return THALWEG_ERROR_INVALID_MESH;
    case ErrorCode::cancelled:
      return THALWEG_ERROR_CANCELLED;
    case ErrorCode::unreadable:
    case ErrorCode::malformed:
    case ErrorCode::exists:
    case ErrorCode::unwritable:
      break;  // of files, which are not read here
  }
  return THALWEG_ERROR_NONE;
}

}  // namespace

bool clear(thalweg_error* error) noexcept {
  if (error == nullptr) return true;
  if (!plausible_size(error->struct_size, kErrorSize)) return false;
  report(error, THALWEG_OK, "");
  return true;
}

thalweg_status report(thalweg_error* error, thalweg_status status, const char* message) noexcept {
  if (error == nullptr) return status;
  error->status = status;
  error->code = THALWEG_ERROR_NONE;
  error->row_count = 0;
  const std::size_t length = std::min<std::size_t>(std::strlen(message), THALWEG_ERROR_MESSAGE - 1);
  std::memcpy(error->message, message, length);
  error->message[length] = '\0';
  return status;
}

thalweg_status report(thalweg_error* error, const Error& failure) noexcept {
  const auto status = static_cast<thalweg_status>(cli::exit_code_of(failure.code));
  report(error, status, failure.message.c_str());
  if (error == nullptr) return status;
  error->code = code_of(failure.code);
  error->row_count = static_cast<std::uint32_t>(std::min<std::size_t>(failure.rows.size(), UINT32_MAX));
  const std::size_t named = std::min<std::size_t>(failure.rows.size(), THALWEG_ERROR_ROWS);
  std::copy_n(failure.rows.begin(), named, error->rows);
  return status;
}

}  // namespace thalweg::bindings

const char* thalweg_status_name(thalweg_status status) {
  switch (status) {
    case THALWEG_OK:
      return "ok";
    case THALWEG_INTERNAL:
      return "internal error";
    case THALWEG_USAGE:
      return "usage";
    case THALWEG_BAD_INPUT:
      return "bad input";
    case THALWEG_VERIFICATION:
      return "verification failed";
    case THALWEG_OUT_OF_MEMORY:
      return "out of memory";
    case THALWEG_OUTPUT_REFUSED:
      return "output refused";
    case THALWEG_CANCELLED:
      return "cancelled";
    default:
      return "unknown";
  }
}

const char* thalweg_version(void) {
  return thalweg::version();
}
