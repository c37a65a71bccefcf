/// The degenerate corpus: tests/corpus/*.txt, a case a file. The first line says why the case is there; then
/// rows `x y z`, from none to 64.
#pragma once

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

#include "thalweg/point.hpp"

namespace support {

struct CorpusCase {
  std::string name;  ///< of the file, without .txt
  std::string path;
  std::string why;
  std::vector<thalweg::Point3> points;

  std::vector<thalweg::Point2> places() const {
    std::vector<thalweg::Point2> result;
    for (const thalweg::Point3& p : points) result.push_back({p.x, p.y});
    return result;
  }
};

/// What gtest prints of a failed case.
inline void PrintTo(const CorpusCase& c, std::ostream* out) {
  *out << c.name << ": " << c.why;
}

inline CorpusCase read_corpus_case(const std::filesystem::path& path) {
  CorpusCase result{path.stem().string(), path.string(), {}, {}};
  std::ifstream stream(path);
  std::string line;
  std::getline(stream, line);
  if (line.starts_with("# ")) result.why = line.substr(2);
  while (std::getline(stream, line)) {
    std::istringstream row(line);
    std::string x, y, z;
    row >> x >> y >> z;
    const auto number = [](const std::string& text) { return std::strtod(text.c_str(), nullptr); };
    result.points.push_back({number(x), number(y), number(z)});
  }
  return result;
}

/// All cases of the folder, by name.
inline std::vector<CorpusCase> corpus(const std::string& folder) {
  std::vector<CorpusCase> result;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".txt") result.push_back(read_corpus_case(entry.path()));
  }
  std::sort(result.begin(), result.end(),
            [](const CorpusCase& a, const CorpusCase& b) { return a.name < b.name; });
  return result;
}

}  // namespace support
