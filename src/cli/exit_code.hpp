/// The exit codes of the command: a contract with scripts, so every one of them is chosen here and nowhere
/// else.
#pragma once

#include "thalweg/result.hpp"

namespace thalweg::cli {

enum class ExitCode : int {
  done = 0,
  internal = 1,      ///< a bug of ours
  usage = 2,         ///< the command line makes no sense
  bad_input = 3,     ///< an input that is unreadable or invalid
  verification = 4,  ///< `check` found a fault, or pits are left under --fail-on-pits
  resources = 5,     ///< out of memory, or over --max-memory
  output = 6,        ///< an output that exists or cannot be written
  interrupted = 130  ///< SIGINT or SIGTERM
};

/// The exit code that an error of the library or of a file ends the command with.
constexpr ExitCode exit_code_of(ErrorCode code) noexcept {
  switch (code) {
    case ErrorCode::too_few_points:
    case ErrorCode::all_collinear:
    case ErrorCode::not_finite:
    case ErrorCode::duplicate_points:
    case ErrorCode::too_many_points:
    case ErrorCode::unreadable:
    case ErrorCode::malformed:
      return ExitCode::bad_input;
    case ErrorCode::invalid_argument:
      return ExitCode::usage;
    case ErrorCode::invalid_mesh:
      return ExitCode::verification;
    case ErrorCode::cancelled:
      return ExitCode::interrupted;
    case ErrorCode::exists:
    case ErrorCode::unwritable:
      return ExitCode::output;
  }
  return ExitCode::internal;
}

}  // namespace thalweg::cli
