#include "io/write_voronoi.hpp"

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "io/row_writer.hpp"

namespace thalweg::io {
namespace {

void write_sites(RowWriter& out, const VoronoiView& view, CellId cell) {
  const char* separator = "";
  for (const VertexId site : view.diagram->sites(cell)) {
    out << separator << view.names[site.index()];
    separator = ",";
  }
}

/// Calls draw(CellId, polygon) for every cell that has area within the box, and counts them.
template <class Draw>
std::uint32_t for_each_polygon(const RowWriter& out, const VoronoiView& view, Draw&& draw) {
  std::uint32_t drawn = 0;
  for (std::uint32_t c = 0; c < view.diagram->cell_count() && !out.failed(); ++c) {
    const std::vector<Point2> polygon = view.diagram->polygon(CellId(c), view.box);
    if (polygon.empty()) continue;
    draw(CellId(c), polygon);
    ++drawn;
  }
  return drawn;
}

std::uint32_t write_geojson(RowWriter& out, const VoronoiView& view) {
  out << R"({"type":"FeatureCollection","features":[)" << '\n';
  const char* separator = "";
  const std::uint32_t drawn =
      for_each_polygon(out, view, [&](CellId cell, const std::vector<Point2>& polygon) {
        out << separator << R"({"type":"Feature","geometry":{"type":"Polygon","coordinates":[[)";
        for (const Point2 p : polygon) out << '[' << p.x << ',' << p.y << "],";
        out << '[' << polygon[0].x << ',' << polygon[0].y << R"(]]]},"properties":{"cell":)" << cell.index()
            << R"(,"sites":[)";
        write_sites(out, view, cell);
        out << R"(],"unbounded":)" << (view.diagram->unbounded(cell) ? "true" : "false") << "}}";
        separator = ",\n";
      });
  out << "\n]}\n";
  return drawn;
}

constexpr double kPictureWidth = 1000;

constexpr std::array kColours = {"#fbb4ae", "#b3cde3", "#ccebc5", "#decbe4", "#fed9a6", "#ffffcc",
                                 "#e5d8bd", "#fddaec", "#cfe8e6", "#d9d9d9", "#c7d8f0"};

/// From the plane to a picture: y down, three digits after the point.
struct Picture {
  explicit Picture(const Box& b) : box(b), scale(kPictureWidth / (b.high.x - b.low.x)) {}

  double height() const { return digits((box.high.y - box.low.y) * scale); }
  Point2 place(Point2 p) const {
    return {digits((p.x - box.low.x) * scale), digits((box.high.y - p.y) * scale)};
  }
  static double digits(double value) { return std::round(value * 1000) / 1000; }

  Box box;
  double scale;
};

std::uint32_t write_svg(RowWriter& out, const VoronoiView& view) {
  const Picture picture(view.box);
  out << R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 )" << kPictureWidth << ' '
      << picture.height() << "\">\n<g stroke=\"#333\" stroke-width=\"0.5\" stroke-linejoin=\"round\">\n";
  const std::uint32_t drawn =
      for_each_polygon(out, view, [&](CellId cell, const std::vector<Point2>& polygon) {
        out << R"(<path fill=")" << kColours[cell.index() % kColours.size()] << R"(" d=")";
        char command = 'M';
        for (const Point2 p : polygon) {
          const Point2 q = picture.place(p);
          out << command << q.x << ' ' << q.y;
          command = 'L';
        }
        out << "Z\"><title>";
        write_sites(out, view, cell);
        out << "</title></path>\n";
      });
  out << "</g>\n<g fill=\"#000\">\n";
  for (std::uint32_t v = 0; v < view.names.size() && !out.failed(); ++v) {
    const Point2 p = picture.place(view.diagram->point(VertexId(v)));
    out << R"(<circle cx=")" << p.x << R"(" cy=")" << p.y << R"(" r="1.5"><title>)" << view.names[v]
        << "</title></circle>\n";
  }
  out << "</g>\n</svg>\n";
  return drawn;
}

}  // namespace

Result<std::uint32_t> write_voronoi(OutputFile& output, const VoronoiView& view, Format format) {
  if (format != Format::geojson && format != Format::svg) {
    return Error{ErrorCode::invalid_argument,
                 std::string(name_of(format)) + " cannot hold a Voronoi diagram: use geojson or svg"};
  }
  RowWriter out(output);
  const std::uint32_t drawn = format == Format::svg ? write_svg(out, view) : write_geojson(out, view);
  out.flush();
  if (output.error()) return *output.error();
  return drawn;
}

std::optional<Error> write_nearest(OutputFile& output, const OrderKVoronoi& diagram,
                                   std::span<const std::uint32_t> names, std::span<const Point2> queries) {
  RowWriter out(output);
  out << "query";
  for (unsigned i = 0; i < diagram.order(); ++i) out << ",site";
  out << '\n';
  for (std::size_t i = 0; i < queries.size() && !out.failed(); ++i) {
    out << std::uint64_t{i};
    for (const VertexId site : diagram.nearest(queries[i])) out << ',' << names[site.index()];
    out << '\n';
  }
  out.flush();
  return output.error();
}

}  // namespace thalweg::io
