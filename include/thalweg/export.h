/// THALWEG_API, before every public function and class: what a shared library lets others see. Everything
/// else is hidden. The preprocessor alone, so that C can include it.
#pragma once

/* Only the shared library itself is compiled with THALWEG_SHARED; users never need it. */
#if defined(THALWEG_SHARED) && defined(__GNUC__)
/// Marks what a shared library shows.
#define THALWEG_API __attribute__((visibility("default")))
#else
#define THALWEG_API
#endif
