/// What a report shows: two triangulations of the same vertices, and what was found out about them. Filled in
/// by the command, drawn by write_report (HTML) and write_svg_map (SVG).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/mesh_file.hpp"
#include "thalweg/minimize.hpp"
#include "thalweg/pits.hpp"
#include "thalweg/point.hpp"

namespace thalweg::io {

inline constexpr std::uint32_t kNoVertex = 0xffffffffu;

/// A pit, by its first vertex in elevation order.
struct ReportPit {
  std::uint32_t vertex = 0;    ///< index into Report::points
  std::uint32_t vertices = 1;  ///< how many it has
  bool boundary = false;
  std::string reason = {};  ///< of a remaining pit: unremovable, conflict, kept
  std::optional<unsigned> order_needed = {};
  double spill_level = 0;  ///< to which water must rise in it to find lower ground; infinite for the lowest
};

/// Headline figures of the water of one terrain.
struct ReportWater {
  std::uint32_t basins = 0;
  std::uint32_t longest_from = kNoVertex;  ///< index into Report::points
  std::uint32_t longest_edges = 0;
  double longest_length = 0;
};

struct Report {
  std::string file;  ///< as the user named it: any bytes
  std::string crs;
  std::string method;  ///< empty if it is not known
  unsigned order = 0;

  // What is drawn. `names` are the numbers that vertices have in mesh files; of a mesh that was thinned out
  // for the screen only some are left.
  std::vector<Point3> points;
  std::vector<std::uint32_t> names;
  std::vector<IndexTriangle> common;                     ///< triangles of both
  std::vector<IndexTriangle> before;                     ///< of the Delaunay triangulation alone
  std::vector<IndexTriangle> after;                      ///< of the result alone
  std::vector<std::uint32_t> after_order;                ///< one for each of `after`; all others have order 0
  std::array<std::vector<std::uint32_t>, 2> downstream;  ///< before, after: the next vertex, or kNoVertex
  std::vector<ReportPit> removed, remaining;

  // What is told.
  std::uint64_t rows = 0;      ///< of the input; 0 if only a mesh is known
  std::uint64_t vertices = 0;  ///< of the whole mesh
  std::uint64_t triangles = 0;
  std::uint64_t merged = 0;
  std::array<PitCount, 2> pits = {};
  std::uint32_t lower_bound = 0;
  bool certified = false;
  unsigned order_searched = 0;
  std::uint64_t edges_changed = 0;
  std::uint64_t non_delaunay_edges = 0;
  std::vector<std::uint64_t> order_histogram;
  std::array<double, 2> min_angle_deg = {};
  std::string hash_in, hash_out;  ///< of the sites; hash_in is empty if only a mesh is known
  std::array<ReportWater, 2> water = {};
  std::vector<SweepRow> sweep;
};

}  // namespace thalweg::io
