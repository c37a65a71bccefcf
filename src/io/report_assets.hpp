/// The parts of the page that do not depend on the report: files of src/io/report, which the build turns into
/// C++ (embed.cmake there).
#pragma once

#include <string_view>

namespace thalweg::io {

extern const std::string_view kReportPage;    ///< page.html, with markers @NAME@
extern const std::string_view kReportStyle;   ///< all style sheets
extern const std::string_view kReportScript;  ///< all programs but three.js
extern const std::string_view kThreeScript;   ///< what of three.js the page needs, made by bundle/make.sh
extern const std::string_view kThreeLicence;

}  // namespace thalweg::io
