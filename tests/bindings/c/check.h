/// What the C tests share: a check that goes on after a failure, and points.
#ifndef THALWEG_TESTS_CHECK_H
#define THALWEG_TESTS_CHECK_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include "thalweg/thalweg.h"

static int check_failures = 0;

#define CHECK(condition)                                              \
  do {                                                                \
    if (!(condition)) {                                               \
      ++check_failures;                                               \
      fprintf(stderr, "%s:%d: %s\n", __FILE__, __LINE__, #condition); \
    }                                                                 \
  } while (0)

/// For calls: the status, and the message if it is not the one expected.
#define CHECK_STATUS(expected, call, error)                                                         \
  do {                                                                                              \
    const thalweg_status got_ = (call);                                                             \
    if (got_ != (expected)) {                                                                       \
      ++check_failures;                                                                             \
      fprintf(stderr, "%s:%d: %s: %s (%s)\n", __FILE__, __LINE__, #call, thalweg_status_name(got_), \
              (error).message);                                                                     \
    }                                                                                               \
  } while (0)

/// What main returns.
static inline int check_result(void) {
  if (check_failures == 0) return 0;
  fprintf(stderr, "%d checks failed\n", check_failures);
  return 1;
}

static inline thalweg_error fresh_error(void) {
  thalweg_error error;
  error.struct_size = sizeof error;
  error.message[0] = '\0';
  return error;
}

/// Fills n rows of `width` numbers: whole ones from 0 to `range`, the same for the same seed. Small ranges
/// make duplicates, collinear and cocircular points.
static inline void fill_points(double* numbers, size_t n, size_t width, uint32_t range, uint64_t seed) {
  uint64_t state = seed * UINT64_C(2862933555777941757) + 3037000493;
  for (size_t i = 0; i < n * width; ++i) {
    state = state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    numbers[i] = (double)((uint32_t)(state >> 33) % (range + 1));
  }
}

#endif
