/// Reads the few shapes of JSON that the truth files have: an object of integers and nested arrays of them.
#include "support/truth.hpp"

#include <cstdlib>
#include <fstream>

namespace support {
namespace {

/// The integers of the value of `key`, all brackets ignored.
std::vector<long> integers_of(const std::string& line, const std::string& key) {
  std::vector<long> result;
  const std::size_t at = line.find("\"" + key + "\":");
  if (at == std::string::npos) return result;
  const char* p = line.c_str() + at + key.size() + 3;
  int depth = 0;
  do {
    if (*p == '[') {
      ++depth;
      ++p;
    } else if (*p == ']') {
      --depth;
      ++p;
    } else if (*p == ',' || *p == ' ') {
      ++p;
    } else {
      char* end = nullptr;
      result.push_back(std::strtol(p, &end, 10));
      if (end == p) return {};
      p = end;
    }
  } while (depth > 0);
  return result;
}

}  // namespace

std::vector<Truth> read_truth(const std::string& name) {
  std::vector<Truth> result;
  std::ifstream file(std::string(THALWEG_TEST_DATA) + "/truth/" + name);
  for (std::string line; std::getline(file, line);) {
    Truth truth;
    const auto kind = integers_of(line, "kind"), count = integers_of(line, "triangulations");
    const auto points = integers_of(line, "points"), useful = integers_of(line, "useful");
    if (kind.size() != 1 || count.size() != 1 || points.size() % 3 != 0 || useful.size() % 3 != 0) return {};
    truth.kind = static_cast<int>(kind[0]);
    truth.triangulations = static_cast<std::uint64_t>(count[0]);
    for (std::size_t i = 0; i < points.size(); i += 3) {
      truth.cloud.points.push_back({static_cast<double>(points[i]), static_cast<double>(points[i + 1]),
                                    static_cast<double>(points[i + 2])});
    }
    for (const long pits : integers_of(line, "min_pits")) {
      truth.min_pits.push_back(static_cast<std::uint32_t>(pits));
    }
    for (std::size_t i = 0; i < useful.size(); i += 3) {
      truth.useful.push_back({static_cast<std::uint32_t>(useful[i]),
                              static_cast<std::uint32_t>(useful[i + 1]), static_cast<int>(useful[i + 2])});
    }
    result.push_back(std::move(truth));
  }
  return result;
}

}  // namespace support
