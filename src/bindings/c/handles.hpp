/// What is behind the opaque handles. Each begins with a tag of its type, so that a handle of another type,
/// which C cannot always refuse, is noticed.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bindings/c/guard.hpp"
#include "thalweg/circle_count.hpp"
#include "thalweg/minimize.hpp"
#include "thalweg/order_k_voronoi.hpp"
#include "thalweg/pits.hpp"
#include "thalweg/thalweg.h"
#include "thalweg/triangulation.hpp"
#include "thalweg/useful_order.hpp"
#include "thalweg/validate.hpp"

struct thalweg_cancel {
  static constexpr std::uint32_t kTag = 0x74430001;
  std::uint32_t tag = kTag;
  std::atomic<bool> flag = false;
};
static_assert(std::atomic<bool>::is_always_lock_free, "thalweg_cancel_request is for signal handlers, too");

struct thalweg_mesh {
  static constexpr std::uint32_t kTag = 0x744d0001;
  std::uint32_t tag = kTag;
  bool borrowed = false;  // belongs to another handle and goes with it
  thalweg::Triangulation triangulation;
};

struct thalweg_pits {
  static constexpr std::uint32_t kTag = 0x74500001;
  std::uint32_t tag = kTag;
  thalweg::Pits pits;
};

struct thalweg_terrain {
  static constexpr std::uint32_t kTag = 0x74540001;
  std::uint32_t tag = kTag;
  thalweg_mesh mesh;
  thalweg::Minimized report;  // without its triangulation, which is in `mesh`
};

struct thalweg_faults {
  static constexpr std::uint32_t kTag = 0x74460001;
  std::uint32_t tag = kTag;
  std::vector<thalweg::Fault> faults;
};

struct thalweg_sites {
  static constexpr std::uint32_t kTag = 0x74530001;
  std::uint32_t tag = kTag;
  std::vector<thalweg::Point2> xy;
  thalweg_mesh mesh;
  std::vector<std::uint32_t> site_of;           // the row that stands for each row; empty if all are distinct
  std::optional<thalweg::DelaunayGraph> graph;  // refers to xy and mesh
};

struct thalweg_pairs {
  static constexpr std::uint32_t kTag = 0x74550001;
  std::uint32_t tag = kTag;
  std::vector<thalweg::UsefulPair> pairs;
};

struct thalweg_voronoi {
  static constexpr std::uint32_t kTag = 0x74560001;
  std::uint32_t tag = kTag;
  thalweg::OrderKVoronoi diagram;
};

namespace thalweg::bindings {

template <class Handle>
bool is_handle(const Handle* handle) noexcept {
  return handle != nullptr && reinterpret_cast<std::uintptr_t>(handle) % alignof(Handle) == 0 &&
         handle->tag == Handle::kTag;
}

/// An error unless it is a handle of that type; `name` is for the message.
template <class Handle>
std::optional<Error> check_handle(const Handle* handle, const char* name) {
  if (is_handle(handle)) return std::nullopt;
  return usage(std::string(name) +
               (handle == nullptr ? " is null" : " is a handle of another type, or none"));
}

/// Sets the place for a handle to null, or says that there is none.
template <class Handle>
std::optional<Error> prepare(Handle** out, const char* name) {
  if (out == nullptr) return usage("the place for " + std::string(name) + " is null");
  *out = nullptr;
  return std::nullopt;
}

/// Null, borrowed and wrong handles are left alone.
template <class Handle>
void free_handle(Handle* handle) noexcept {
  if (!is_handle(handle)) return;
  handle->tag = 0;
  delete handle;
}

}  // namespace thalweg::bindings
