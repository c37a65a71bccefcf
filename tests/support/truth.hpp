/// The exhaustive truth of tests/data/truth.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "support/cloud.hpp"

namespace support {

/// One set whose triangulations were all enumerated; see tests/data/truth/README.md.
struct Truth {
  struct Useful {
    std::uint32_t u, v;
    int order;  ///< -1 if a site lies between
  };
  int kind = 0;
  std::uint64_t triangulations = 0;
  Cloud cloud;
  std::vector<std::uint32_t> min_pits;
  std::vector<Useful> useful;
};

/// All sets of one file, for example "exhaustive.jsonl"; empty if it cannot be read or understood.
std::vector<Truth> read_truth(const std::string& name);

}  // namespace support
