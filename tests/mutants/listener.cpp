/// Linked to each test executable of a planted tree: after each test, a line to the file THALWEG_MUTANT_LOG
/// with its name, its time in milliseconds and the mutants that it reached (with a minus sign: that have no
/// meaning).
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "mutant.hpp"
#include "mutant_count.hpp"

namespace mutant {

extern unsigned char met[];

namespace {

class Listener : public testing::EmptyTestEventListener {
  void OnTestEnd(const testing::TestInfo& test) override {
    std::FILE* log = std::fopen(std::getenv("THALWEG_MUTANT_LOG"), "a");
    std::fprintf(log, "%s.%s %ld", test.test_suite_name(), test.name(),
                 static_cast<long>(test.result()->elapsed_time()));
    for (int n = 0; n < MUTANT_COUNT; ++n) {
      if ((met[n] & 1) != 0) std::fprintf(log, " %d", n);
      if ((met[n] & 2) != 0) std::fprintf(log, " -%d", n);
    }
    std::fprintf(log, test.result()->Passed() ? " passed\n" : " failed\n");
    std::fclose(log);
    std::memset(met, 0, MUTANT_COUNT);
    std::memset(state, 2, MUTANT_COUNT);
  }
};

[[maybe_unused]] const bool added = [] {
  if (std::getenv("THALWEG_MUTANT_LOG") != nullptr)
    testing::UnitTest::GetInstance()->listeners().Append(new Listener);
  return true;
}();

}  // namespace
}  // namespace mutant
