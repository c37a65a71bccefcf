/// Everything a report shows, gathered from a build or from somebody's mesh.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "cli/compact_mesh.hpp"
#include "io/mesh_file.hpp"
#include "io/report.hpp"
#include "thalweg/minimize.hpp"
#include "thalweg/result.hpp"

namespace thalweg::cli {

/// What is known beside the result.
struct ReportSource {
  std::string file;
  std::string crs;
  std::string method;
  unsigned order = 0;
  unsigned threads = 1;
};

/// The report of a build over `rows`.
io::Report report_of_build(const ReportSource& source, std::span<const Point3> rows,
                           const VertexMap& vertices, const Minimized& result);

/// The report of a mesh: what an order as high as its own could do with its vertices, and what it does.
/// Errors: invalid_mesh if it is not sound; those of minimize_pits.
Result<io::Report> report_of_mesh(const ReportSource& source, const io::MeshFile& mesh);

}  // namespace thalweg::cli
