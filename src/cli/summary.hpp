/// What a build found, for programs (JSON) and for people (lines on stderr).
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "cli/compact_mesh.hpp"
#include "cli/console.hpp"
#include "thalweg/minimize.hpp"

namespace thalweg::cli {

using Json = nlohmann::ordered_json;

/// Everything there is to tell of a build.
struct BuildReport {
  std::string file;
  std::uint64_t points = 0;
  unsigned order = 0;
  Method method = Method::best;
  DuplicatePolicy policy = DuplicatePolicy::lowest;
  unsigned threads = 1;
  const Minimized* result = nullptr;
  const VertexMap* vertices = nullptr;
  double seconds_read = 0;
  double seconds_write = 0;
  double seconds_total = 0;
};

/// {"tool": "thalweg", "version": ...}: what every summary begins with.
Json new_summary();

/// {"total": ..., "interior": ..., "boundary": ...}
Json to_json(const PitCount& pits);

/// How many faces have each order, from 0 to the largest.
std::vector<std::uint64_t> order_histogram(std::span<const std::uint32_t> orders);

/// The object of `build --json`; its keys are a contract.
Json summarize(const BuildReport& report);

/// The same for a person.
void describe(const BuildReport& report, Console& console);

/// The text of a summary as it is written. Bytes of a file name that are no UTF-8 are replaced.
std::string to_text(const Json& summary);

}  // namespace thalweg::cli
