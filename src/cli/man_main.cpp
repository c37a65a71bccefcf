/// Prints the manual page, for the build: `thalweg_man > thalweg.1`.
#include <cstdio>
#include <string>

#include "cli/man_page.hpp"

int main() {
  const std::string page = thalweg::cli::man_page();
  const bool whole = std::fwrite(page.data(), 1, page.size(), stdout) == page.size();
  return whole && std::fflush(stdout) == 0 ? 0 : 1;
}
