/// Large terrains, made small enough to be drawn.
#pragma once

#include "io/report.hpp"

namespace thalweg::cli {

/// If the report has more triangles than a page draws at ease, takes vertices out of what is drawn, but none
/// of a changed triangle, none of a pit, and few near one; paths of water then lead to the next vertex that
/// is left. Figures are not touched.
void thin_report(io::Report& report);

}  // namespace thalweg::cli
