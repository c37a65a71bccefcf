/// The border between C and C++: no exception crosses it, and every failure becomes a status with a message.
#pragma once

#include <new>
#include <optional>
#include <stdexcept>
#include <string>

#include "thalweg/result.hpp"
#include "thalweg/thalweg.h"

namespace thalweg::bindings {

/// Empties the caller's error. Returns whether it can be used at all: null can, a struct too small cannot.
bool clear(thalweg_error* error) noexcept;

/// Notes a failure, if the caller wants to know. Returns its status. Does not allocate.
thalweg_status report(thalweg_error* error, const Error& failure) noexcept;
thalweg_status report(thalweg_error* error, thalweg_status status, const char* message) noexcept;

/// The answer to an argument that makes no sense.
inline Error usage(std::string message) {
  return {ErrorCode::invalid_argument, std::move(message), {}};
}

/// Runs `work`, which returns std::optional<Error>, and turns whatever happens into a status.
template <class Work>
thalweg_status guarded(thalweg_error* error, Work&& work) noexcept {
  if (!clear(error)) return THALWEG_USAGE;
  try {
    const std::optional<Error> failure = work();
    return failure ? report(error, *failure) : THALWEG_OK;
  } catch (const std::bad_alloc&) {
    return report(error, THALWEG_OUT_OF_MEMORY, "out of memory");
  } catch (const std::length_error&) {  // a vector longer than there are addresses
    return report(error, THALWEG_OUT_OF_MEMORY, "out of memory: more than could ever be addressed");
  } catch (const std::exception& bug) {
    return report(error, THALWEG_INTERNAL, bug.what());
  } catch (...) {
    return report(error, THALWEG_INTERNAL, "an unknown exception");
  }
}

}  // namespace thalweg::bindings
