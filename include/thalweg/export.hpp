/// THALWEG_EXPORT, before every public function and class: what a shared library lets others see. Everything
/// else is hidden.
#pragma once

// Only the shared library itself is compiled with THALWEG_SHARED; users never need it.
#if defined(THALWEG_SHARED) && defined(__GNUC__)
/// Marks what a shared library shows.
#define THALWEG_EXPORT __attribute__((visibility("default")))
#else
/// Nothing, outside of the shared library.
#define THALWEG_EXPORT
#endif
