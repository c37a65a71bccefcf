/// Memory that runs out when a test wants it to, and a count of what was not given back.
#ifndef THALWEG_TESTS_FAILING_NEW_H
#define THALWEG_TESTS_FAILING_NEW_H

#ifdef __cplusplus
extern "C" {
#endif

/// From now on the call of C++'s operator new that is `after` calls away fails, and all that follow; 0 means
/// the next. Negative: none fails.
void fail_allocations(long after);

/// The same, but those that follow succeed.
void fail_one_allocation(long after);

/// How many calls have failed since the last call of one of the two above.
long failed_allocations(void);

/// How many allocations there are that were not given back.
long live_allocations(void);

#ifdef __cplusplus
}
#endif

#endif
