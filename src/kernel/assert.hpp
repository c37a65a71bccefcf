/// THALWEG_ASSERT: a caller's bug, or ours, stops the program in debug, test and sanitizer builds and costs
/// nothing else.
#pragma once

#if defined(THALWEG_CHECKED) && THALWEG_CHECKED
#include <cassert>
#undef NDEBUG
#include <cassert>
#define THALWEG_ASSERT(condition) assert(condition)
#else
#define THALWEG_ASSERT(condition) static_cast<void>(0)
#endif
