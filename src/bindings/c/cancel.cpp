/// Requests to stop, for C.
#include <new>

#include "bindings/c/handles.hpp"

using thalweg::bindings::free_handle;
using thalweg::bindings::is_handle;

thalweg_cancel* thalweg_cancel_new(void) {
  return new (std::nothrow) thalweg_cancel;
}

void thalweg_cancel_request(thalweg_cancel* cancel) {
  if (is_handle(cancel)) cancel->flag.store(true, std::memory_order_relaxed);
}

void thalweg_cancel_reset(thalweg_cancel* cancel) {
  if (is_handle(cancel)) cancel->flag.store(false, std::memory_order_relaxed);
}

int thalweg_cancel_requested(const thalweg_cancel* cancel) {
  return is_handle(cancel) && cancel->flag.load(std::memory_order_relaxed) ? 1 : 0;
}

void thalweg_cancel_free(thalweg_cancel* cancel) {
  free_handle(cancel);
}
