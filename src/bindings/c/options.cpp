/// Options of the main job: defaults, checks, callbacks.
#include "bindings/c/options.hpp"

#include <cmath>
#include <string>

#include "bindings/c/arrays.hpp"
#include "bindings/c/handles.hpp"
#include "bindings/c/structs.hpp"

namespace thalweg::bindings {
namespace {

static_assert(THALWEG_METHOD_DELAUNAY == static_cast<int>(Method::delaunay));
static_assert(THALWEG_METHOD_FLIP == static_cast<int>(Method::flip));
static_assert(THALWEG_METHOD_HULL == static_cast<int>(Method::hull));
static_assert(THALWEG_METHOD_BEST == static_cast<int>(Method::best));
static_assert(THALWEG_METHOD_EXACT == static_cast<int>(Method::exact));
static_assert(THALWEG_DUPLICATES_LOWEST == static_cast<int>(DuplicatePolicy::lowest));
static_assert(THALWEG_DUPLICATES_HIGHEST == static_cast<int>(DuplicatePolicy::highest));
static_assert(THALWEG_DUPLICATES_MEAN == static_cast<int>(DuplicatePolicy::mean));
static_assert(THALWEG_DUPLICATES_FIRST == static_cast<int>(DuplicatePolicy::first));
static_assert(THALWEG_DUPLICATES_LAST == static_cast<int>(DuplicatePolicy::last));
static_assert(THALWEG_DUPLICATES_ERROR == static_cast<int>(DuplicatePolicy::error));
static_assert(THALWEG_COUNTER_CRAWL == static_cast<int>(Counter::crawl));
static_assert(THALWEG_COUNTER_VORONOI == static_cast<int>(Counter::voronoi));

// The last member of the first version.
constexpr std::size_t kOptionsSize = offsetof(thalweg_build_options, cancel) + sizeof(void*);
static_assert(kOptionsSize == sizeof(thalweg_build_options), "no padding at the end, see guard.cpp");

thalweg_build_options defaults() noexcept {
  const MinimizeOptions ours;
  thalweg_build_options options = {};
  options.order = ours.order;
  options.method = static_cast<int32_t>(ours.method);
  options.duplicates = static_cast<int32_t>(ours.duplicates);
  options.counter = static_cast<int32_t>(ours.counter);
  options.threads = ours.threads;
  options.keep_trail = ours.keep_trail ? 1 : 0;
  options.time_limit = ours.time_limit;
  return options;
}

std::optional<Error> check_choice(int32_t value, int32_t last, const char* name) {
  if (value >= 0 && value <= last) return std::nullopt;
  return usage(std::string(name) + " has the unknown value " + std::to_string(value));
}

std::optional<Error> check_values(const thalweg_build_options& options) {
  if (auto wrong = check_choice(options.method, THALWEG_METHOD_EXACT, "method")) return wrong;
  if (auto wrong = check_choice(options.duplicates, THALWEG_DUPLICATES_ERROR, "duplicates")) return wrong;
  if (auto wrong = check_choice(options.counter, THALWEG_COUNTER_VORONOI, "counter")) return wrong;
  if (std::isnan(options.time_limit) || options.time_limit < 0) {
    return usage("time_limit is not a number of seconds from 0");
  }
  if (options.cancel != nullptr) return check_handle(options.cancel, "cancel");
  return std::nullopt;
}

/// The caller's struct as this version has it: what the caller does not know has its default.
Result<thalweg_build_options> read_struct(const thalweg_build_options* theirs) {
  thalweg_build_options options = defaults();
  if (theirs == nullptr) return options;
  if (!plausible_size(theirs->struct_size, kOptionsSize)) {
    return usage("options->struct_size is " + std::to_string(theirs->struct_size) +
                 ": thalweg_build_options_init was not called");
  }
  if (!asks_for_nothing_new(theirs)) {
    return usage("the options ask for something that is newer than this library, version " +
                 std::string(thalweg_version()));
  }
  std::memcpy(&options, theirs, std::min(theirs->struct_size, sizeof options));
  return options;
}

}  // namespace

Result<MinimizeOptions> read_options(const thalweg_build_options* theirs, std::atomic<bool>& stop) {
  const Result<thalweg_build_options> read = read_struct(theirs);
  if (!read) return read.error();
  if (auto wrong = check_values(*read)) return *std::move(wrong);
  MinimizeOptions options;
  options.order = read->order;
  options.method = static_cast<Method>(read->method);
  options.duplicates = static_cast<DuplicatePolicy>(read->duplicates);
  options.counter = static_cast<Counter>(read->counter);
  options.threads = threads_for(read->threads);
  options.keep_trail = read->keep_trail != 0;
  options.time_limit = read->time_limit;
  std::atomic<bool>* flag = read->cancel != nullptr ? &read->cancel->flag : &stop;
  options.cancel = flag;
  if (read->progress != nullptr) {
    options.progress = [call = read->progress, data = read->progress_data, flag](const char* stage,
                                                                                 double fraction) {
      if (call(data, stage, fraction) != 0) flag->store(true, std::memory_order_relaxed);
    };
  }
  return options;
}

}  // namespace thalweg::bindings

thalweg_status thalweg_build_options_init(thalweg_build_options* options, size_t struct_size) {
  using namespace thalweg::bindings;
  if (options == nullptr || !plausible_size(struct_size, kOptionsSize)) return THALWEG_USAGE;
  give(options, defaults(), struct_size);
  return THALWEG_OK;
}
