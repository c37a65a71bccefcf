/// The mutant of this run: THALWEG_MUTANT=17 turns one on, THALWEG_MUTANT=record notes all that are reached.
#include <cstdlib>
#include <cstring>

#include "mutant.hpp"
#include "mutant_count.hpp"

namespace mutant {

unsigned char state[MUTANT_COUNT + 2];
unsigned char met[MUTANT_COUNT + 2];  // 1 reached, 2 without meaning

bool asked(int n) noexcept {
  if (state[n] == 1) return true;
  met[n] |= 1;
  state[n] = 0;
  return false;
}

void has_no_meaning(int n) noexcept {
  met[n] |= 2;
  state[n] = 0;
}

namespace {

__attribute__((constructor(101))) void choose() {
  const char* which = std::getenv("THALWEG_MUTANT");
  if (which == nullptr) return;
  if (std::strcmp(which, "record") == 0) {
    std::memset(state, 2, sizeof state);
  } else {
    state[std::atoi(which)] = 1;
  }
}

}  // namespace
}  // namespace mutant
