/// What thalweg computes with. Flags under which a double is not what IEEE 754 says must not compile; flags
/// that only ask for it must not get it.
#include "kernel/numbers.hpp"

/// Not b, but what is left of it.
double rounded(double a, double b) {
  return (a + b) - a;
}
