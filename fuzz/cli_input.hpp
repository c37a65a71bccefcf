/// A command line and the file it reads, out of raw bytes.
#pragma once

#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "fuzz_input.hpp"
#include "thalweg/delaunay.hpp"

namespace fuzz {

/// Lines that make sense, IN being the name of the file; bytes then change some of their words.
inline constexpr const char* kLines[] = {
    "build IN -o out.ply -k 3",
    "build IN -o out.obj -m flip",
    "build IN -m hull -k 1 --json sum.json --pits pits.csv",
    "build IN -m exact -k 2 --fail-on-pits -o out.2dm",
    "build - --from xyz -o - --to tlw",
    "build IN --report out.svg -k 0",
    "check IN -k 4",
    "check IN --points IN --json -",
    "edges IN -k 2 -o out.csv",
    "sweep IN -k 0..3 --json -",
    "sample IN -n 3 --seed 1 -o out.xyz",
    "generate fractal -n 9 --seed 2 -o out.npy",
    "generate theorem1 -n 2 -o out.xyz",
    "generate corollary2 -n 2 -o out.csv",
    "generate theorem1 --segments IN -o out.tsv",
    "info IN --json -",
    "voronoi IN -k 2 -o out.geojson",
    "voronoi IN -k 2 --query IN -o out.csv",
    "report IN -o out.svg",
    "report IN -o out.html",
    "--help",
    "--version",
};

inline constexpr const char* kWords[] = {
    "IN",
    "-",
    "-o",
    "-k",
    "-m",
    "-n",
    "-q",
    "-v",
    "--from",
    "--to",
    "--columns",
    "--nodata",
    "--threads",
    "--duplicates",
    "--json",
    "--pits",
    "--report",
    "--overwrite",
    "--progress",
    "--fail-on-pits",
    "--counter",
    "--points",
    "--query",
    "--segments",
    "--seed",
    "--max-memory",
    "--time-limit",
    "--layers",
    "--sweep",
    "--help",
    "--version",
    "--",
    "build",
    "check",
    "edges",
    "sweep",
    "sample",
    "generate",
    "info",
    "voronoi",
    "report",
    "delaunay",
    "flip",
    "hull",
    "best",
    "exact",
    "crawl",
    "lowest",
    "mean",
    "error",
    "bar",
    "none",
    "xyz",
    "csv",
    "ply-ascii",
    "tlw",
    "npy",
    "geojson",
    "out.xyz",
    "out.svg",
    "out.ply",
    "none.xyz",
    "folder",
    "0",
    "1",
    "2",
    "7",
    "0..2",
    "2..1",
    "-1",
    "1e9",
    "nan",
    "1K",
    "1,2,3",
    "x,y,z",
    "3,1",
    "pits,flow",
    "fractal",
    "ridge",
    "plateau",
    "ring",
    "grid",
    "lidar",
    "",
};

struct CommandLine {
  std::vector<std::string> words;  ///< without the command's own name
  std::string file;                ///< the name of the input
  std::string content;             ///< and what it holds
};

inline std::vector<std::string> split(const std::string& line) {
  std::istringstream words(line);
  return {std::istream_iterator<std::string>(words), {}};
}

/// No word may lead out of the folder, nor ask for more work than a moment's: slashes and third digits go.
inline std::string harmless(const std::string& word) {
  std::string result;
  std::size_t digits = 0;
  for (const char c : word) {
    digits = c >= '0' && c <= '9' ? digits + 1 : 0;
    if (c != '/' && digits < 3) result += c;
  }
  return result.find("..") == 0 ? "" : result;
}

/// A word of the list, or up to 8 characters of the input's own.
inline std::string take_word(Input& input) {
  const std::uint8_t choice = input.byte();
  if (choice < 2 * std::size(kWords)) return kWords[choice % std::size(kWords)];
  std::string word;
  for (int length = choice % 9; length > 0; --length) word += static_cast<char>(input.byte());
  return harmless(word.c_str());
}

inline void change_words(Input& input, std::vector<std::string>& words) {
  for (int changes = input.byte() % 4; changes > 0; --changes) {
    const std::uint8_t where = input.byte();
    const auto at = words.begin() + static_cast<std::ptrdiff_t>(where / 2 % (words.size() + 1));
    if (where % 2 == 1 && at != words.end()) {
      *at = take_word(input);
    } else {
      words.insert(at, take_word(input));
    }
  }
}

inline std::string take_rest(Input& input) {
  std::string bytes;
  while (!input.empty()) bytes += static_cast<char>(input.byte());
  // A summary names a file to be read: none beyond the folder.
  if (bytes.find('{') != std::string::npos) std::erase(bytes, '/');
  return bytes;
}

inline std::string rows_of(const std::vector<thalweg::Point3>& points, const char* before) {
  std::string rows;
  for (const thalweg::Point3& p : points) {
    char row[100];
    std::snprintf(row, sizeof row, "%s%.17g %.17g %.17g\n", before, p.x, p.y, p.z);
    rows += row;
  }
  return rows;
}

/// The points' Delaunay triangulation, if they have one, as an OBJ file.
inline std::string mesh_of(const std::vector<thalweg::Point3>& points) {
  std::string text = rows_of(points, "v ");
  std::vector<thalweg::Point2> places;
  for (const thalweg::Point3& p : points) places.push_back({p.x, p.y});
  const auto mesh = thalweg::delaunay(places);
  for (std::uint32_t f = 0; mesh && f < mesh->face_count(); ++f) {
    text += "f";
    for (const thalweg::VertexId v : mesh->corners(thalweg::FaceId(f)))
      text += " " + std::to_string(v.index() + 1);
    text += "\n";
  }
  return text;
}

inline std::string grid_of(Input& input) {
  const int columns = 1 + input.byte() % 6, rows = 1 + input.byte() % 6;
  std::string text = "ncols " + std::to_string(columns) + "\nnrows " + std::to_string(rows) +
                     "\nxllcorner 0\nyllcorner 0\ncellsize 1\n";
  for (int i = 0; i < columns * rows; ++i) text += std::to_string(input.byte() % 16) + "\n";
  return text;
}

/// Of text, the first line's length chooses the command, and the whole is its file of points.
inline CommandLine take_command_line(Input& input) {
  if (input.is_text()) {
    std::string first = input.line();
    const char* line = kLines[first.size() % std::size(kLines)];
    return {split(line), "in.xyz", first + "\n" + take_rest(input)};
  }
  constexpr const char* kRawNames[] = {"in.xyz", "in.csv", "in.tsv", "in.asc", "in.obj",
                                       "in.ply", "in.2dm", "in.tlw", "in.npy", "in.json"};
  CommandLine result;
  result.words = split(kLines[input.byte() % std::size(kLines)]);
  change_words(input, result.words);
  const std::uint8_t kind = input.byte();
  if (kind % 4 == 0) {
    result.file = kRawNames[kind / 4 % std::size(kRawNames)];
    result.content = take_rest(input);
  } else if (kind % 4 == 1) {
    result.file = kind < 128 ? "in.xyz" : "in.csv";
    result.content = rows_of(take_terrain(input, 24), "");
  } else if (kind % 4 == 2) {
    result.file = "in.obj";
    result.content = mesh_of(take_terrain(input, 24));
  } else {
    result.file = "in.asc";
    result.content = grid_of(input);
  }
  return result;
}

}  // namespace fuzz
