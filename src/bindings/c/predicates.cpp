/// Predicates for C.
#include "thalweg/predicates.hpp"

#include <initializer_list>

#include "bindings/c/arrays.hpp"
#include "bindings/c/guard.hpp"

namespace thalweg::bindings {
namespace {

/// Calls test() if all points can be taken and there is a place for the sign.
template <class Test>
thalweg_status decide(std::initializer_list<const double*> points, int* sign, thalweg_error* error,
                      Test&& test) noexcept {
  return guarded(error, [&]() -> std::optional<Error> {
    if (sign == nullptr) return usage("the place for the sign is null");
    for (const double* p : points) {
      if (auto wrong = check_input(p, 2, "a point")) return wrong;
      if (auto wrong = check_finite(p, 1, 2, "a point, row")) return wrong;
    }
    *sign = test();
    return std::nullopt;
  });
}

Point2 at(const double* p) noexcept {
  return {p[0], p[1]};
}

}  // namespace
}  // namespace thalweg::bindings

using namespace thalweg;
using namespace thalweg::bindings;

thalweg_status thalweg_orient2d(const double* a, const double* b, const double* c, int* sign,
                                thalweg_error* error) {
  return decide({a, b, c}, sign, error, [&] { return orient2d(at(a), at(b), at(c)); });
}

thalweg_status thalweg_incircle(const double* a, const double* b, const double* c, const double* d, int* sign,
                                thalweg_error* error) {
  return decide({a, b, c, d}, sign, error, [&] { return incircle(at(a), at(b), at(c), at(d)); });
}

thalweg_status thalweg_compare_distance(const double* a, const double* b, const double* c, int* sign,
                                        thalweg_error* error) {
  return decide({a, b, c}, sign, error, [&] { return compare_distance(at(a), at(b), at(c)); });
}
