/// Checking somebody's mesh, for C.
#include "thalweg/validate.hpp"

#include <array>
#include <memory>

#include "bindings/c/arrays.hpp"
#include "bindings/c/handles.hpp"

namespace thalweg::bindings {
namespace {

static_assert(THALWEG_FAULT_INDEX_OUT_OF_RANGE == static_cast<int>(FaultKind::index_out_of_range));
static_assert(THALWEG_FAULT_DEGENERATE == static_cast<int>(FaultKind::degenerate));
static_assert(THALWEG_FAULT_CLOCKWISE == static_cast<int>(FaultKind::clockwise));
static_assert(THALWEG_FAULT_DUPLICATE_VERTEX == static_cast<int>(FaultKind::duplicate_vertex));
static_assert(THALWEG_FAULT_UNUSED_VERTEX == static_cast<int>(FaultKind::unused_vertex));
static_assert(THALWEG_FAULT_DUPLICATE_TRIANGLE == static_cast<int>(FaultKind::duplicate_triangle));
static_assert(THALWEG_FAULT_NON_MANIFOLD == static_cast<int>(FaultKind::non_manifold));
static_assert(THALWEG_FAULT_CROSSING == static_cast<int>(FaultKind::crossing));
static_assert(THALWEG_FAULT_OVERLAP == static_cast<int>(FaultKind::overlap));
static_assert(THALWEG_FAULT_HOLE == static_cast<int>(FaultKind::hole));

using IndexTriangle = std::array<std::uint32_t, 3>;
static_assert(sizeof(IndexTriangle) == 3 * sizeof(std::uint32_t));

const Fault* fault_at(const thalweg_faults* faults, std::size_t i) noexcept {
  return is_handle(faults) && i < faults->faults.size() ? &faults->faults[i] : nullptr;
}

Error summary_of(const Fault& first) {
  std::string message = std::string(fault_name(first.kind)) + ": " + std::to_string(first.count);
  if (!first.examples.empty()) message += " (" + first.examples.front() + ")";
  return {ErrorCode::invalid_mesh, std::move(message), {}};
}

}  // namespace
}  // namespace thalweg::bindings

using namespace thalweg;
using namespace thalweg::bindings;

thalweg_status thalweg_validate(const double* xy, size_t n, const uint32_t* triangles, size_t m,
                                thalweg_faults** faults, thalweg_error* error) {
  if (faults != nullptr) *faults = nullptr;
  return guarded(error, [&]() -> std::optional<Error> {
    if (auto wrong = check_input(xy, n, "xy")) return wrong;
    if (auto wrong = check_input(triangles, m, "triangles")) return wrong;
    if (auto wrong = check_count(n, "points")) return wrong;
    if (auto wrong = check_count(m, "triangles")) return wrong;
    if (auto wrong = check_finite(xy, n, 2, "point")) return wrong;
    auto made = std::make_unique<thalweg_faults>();
    made->faults = find_faults(points2(xy, n), {reinterpret_cast<const IndexTriangle*>(triangles), m});
    std::optional<Error> verdict;
    if (!made->faults.empty()) verdict = summary_of(made->faults.front());
    if (faults != nullptr) *faults = made.release();
    return verdict;
  });
}

size_t thalweg_faults_count(const thalweg_faults* faults) {
  return is_handle(faults) ? faults->faults.size() : 0;
}

int32_t thalweg_faults_kind(const thalweg_faults* faults, size_t i) {
  const Fault* fault = fault_at(faults, i);
  return fault != nullptr ? static_cast<int32_t>(fault->kind) : -1;
}

uint64_t thalweg_faults_occurrences(const thalweg_faults* faults, size_t i) {
  const Fault* fault = fault_at(faults, i);
  return fault != nullptr ? fault->count : 0;
}

const char* thalweg_faults_example(const thalweg_faults* faults, size_t i, size_t j) {
  const Fault* fault = fault_at(faults, i);
  return fault != nullptr && j < fault->examples.size() ? fault->examples[j].c_str() : nullptr;
}

const char* thalweg_fault_name(int32_t kind) {
  const bool known = kind >= 0 && kind <= THALWEG_FAULT_HOLE;
  return known ? fault_name(static_cast<FaultKind>(kind)) : "unknown";
}

void thalweg_faults_free(thalweg_faults* faults) {
  free_handle(faults);
}
