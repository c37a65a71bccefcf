/// Memory that runs out when a test wants it to.
#ifndef THALWEG_TESTS_FAILING_NEW_H
#define THALWEG_TESTS_FAILING_NEW_H

#ifdef __cplusplus
extern "C" {
#endif

/// From now on the call of C++'s operator new that is `after` calls away fails, and all that follow; 0 means
/// the next. Negative: none fails.
void fail_allocations(long after);

#ifdef __cplusplus
}
#endif

#endif
