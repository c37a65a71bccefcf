#include "io/write_svg_map.hpp"

#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/html_text.hpp"
#include "io/map_frame.hpp"
#include "io/number.hpp"
#include "io/row_writer.hpp"
#include "thalweg/order_k_voronoi.hpp"

namespace thalweg::io {
namespace {

constexpr double kSize = 1000, kMargin = 24, kLegendHeight = 96;

// Blue, vermilion and black tell apart what they mark for every kind of colour vision.
constexpr std::string_view kRemoved = "#0072b2", kRemaining = "#d55e00", kBoundary = "#2b2b2b";
constexpr std::string_view kWater = "#3d8fc4", kOld = "#5b5b5b", kNew = "#9b2d86";

using Colour = std::array<double, 3>;

/// From low to high, ever lighter, so that it reads in grey as well.
constexpr std::array<Colour, 6> kTints = {
    {{127, 167, 160}, {169, 194, 168}, {214, 216, 180}, {235, 220, 184}, {239, 230, 212}, {250, 248, 244}}};

using Edge = std::pair<std::uint32_t, std::uint32_t>;

double digits(double value) {
  return std::round(value * 100) / 100;
}

std::string number_text(double value) {
  char buffer[kNumberSize];
  return {buffer, put_number(buffer, value)};
}

class SvgMap {
 public:
  SvgMap(RowWriter& out, const Report& report, const MapLayers& layers)
      : out_(out), report_(report), layers_(layers), frame_(report.points, kSize) {}

  void write() {
    begin();
    if (layers_.shading) write_shading();
    if (layers_.cells) write_cells();
    if (layers_.flow) write_flow();
    if (layers_.edges) write_edges();
    if (layers_.changes) write_changes();
    if (layers_.pits) write_pits();
    out_ << "</g>\n";
    write_legend();
    out_ << "</svg>\n";
  }

 private:
  using Triangles = std::array<const std::vector<IndexTriangle>*, 2>;
  Triangles result() const { return {&report_.common, &report_.after}; }
  Point2 place(std::uint32_t vertex) const { return frame_.place(report_.points[vertex]); }

  RowWriter& at(char command, Point2 p) { return out_ << command << digits(p.x) << ' ' << digits(p.y); }

  void begin() {
    const double width = kSize + 2 * kMargin, height = frame_.height() + 2 * kMargin + kLegendHeight;
    out_ << R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 )" << width << ' ' << digits(height)
         << R"(" font-family="Helvetica, Arial, sans-serif" font-size="13">)"
         << "\n<title>" << markup_text(file_name()) << "</title>\n"
         << R"(<rect width="100%" height="100%" fill="#fff"/>)"
         << "\n<g transform=\"translate(" << digits(kMargin + (kSize - frame_.width()) / 2) << ' ' << kMargin
         << ")\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n";
  }

  /// Triangles of one colour in one path, with a hairline of the same against gaps between neighbours.
  void write_shading() {
    std::map<std::uint32_t, std::vector<const IndexTriangle*>> by_colour;
    for (const auto* triangles : result()) {
      for (const IndexTriangle& t : *triangles) by_colour[colour_of(t)].push_back(&t);
    }
    out_ << "<g stroke-width=\"0.5\">\n";
    for (const auto& [colour, triangles] : by_colour) {
      std::string text = "#";
      for (int shift = 20; shift >= 0; shift -= 4) text += "0123456789abcdef"[colour >> shift & 15];
      out_ << "<path fill=\"" << text << "\" stroke=\"" << text << "\" d=\"";
      for (const IndexTriangle* t : triangles) {
        at('M', place((*t)[0]));
        at('L', place((*t)[1]));
        at('L', place((*t)[2])) << 'Z';
      }
      out_ << "\"/>\n";
    }
    out_ << "</g>\n";
  }

  /// Red, green, blue in steps of 4, so that few paths are needed.
  std::uint32_t colour_of(const IndexTriangle& t) const {
    double level = 0;
    for (const std::uint32_t v : t) level += frame_.level(report_.points[v].z) / 3;
    const double place = level * (kTints.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(place), kTints.size() - 2);
    const double part = place - static_cast<double>(below), light = brightness(t);
    std::uint32_t colour = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const double tint = kTints[below][c] + part * (kTints[below + 1][c] - kTints[below][c]);
      const double lit = std::clamp(tint * light, 0.0, 255.0);
      colour = colour << 8 | std::min(255u, static_cast<std::uint32_t>(std::round(lit / 4) * 4));
    }
    return colour;
  }

  /// Of light from the north-west, 45 degrees high, on a terrain a seventh as high as wide.
  double brightness(const IndexTriangle& t) const {
    std::array<Point3, 3> p;
    for (std::size_t i = 0; i < 3; ++i) {
      const Point2 q = place(t[i]);
      p[i] = {q.x, -q.y, frame_.level(report_.points[t[i]].z) * kSize / 7};
    }
    const Point3 u{p[1].x - p[0].x, p[1].y - p[0].y, p[1].z - p[0].z};
    const Point3 v{p[2].x - p[0].x, p[2].y - p[0].y, p[2].z - p[0].z};
    const Point3 n{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
    const double length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
    if (!(length > 0)) return 1;
    const double cosine = (-0.5 * n.x + 0.5 * n.y + std::sqrt(0.5) * n.z) / length;
    return 0.62 + 0.5 * std::max(cosine, 0.0);
  }

  void write_cells() {
    std::vector<Point2> sites;
    for (const Point3& p : report_.points) sites.push_back({p.x, p.y});
    const Box box{{frame_.low().x, frame_.low().y}, {frame_.high().x, frame_.high().y}};
    if (!std::isfinite(box.high.x - box.low.x) || !std::isfinite(box.high.y - box.low.y)) return;
    const Result<OrderKVoronoi> diagram = order_k_voronoi(sites, 1);
    if (!diagram) return;
    out_ << R"(<path fill="none" stroke="#7a6f9b" stroke-width="0.6" d=")";
    for (std::uint32_t c = 0; c < diagram->cell_count() && !out_.failed(); ++c) {
      char command = 'M';
      for (const Point2 p : diagram->polygon(CellId(c), box)) {
        at(command, frame_.place({p.x, p.y, 0}));
        command = 'L';
      }
      if (command == 'L') out_ << 'Z';
    }
    out_ << "\"/>\n";
  }

  /// Steps of paths where at least a few come together, by classes of width.
  void write_flow() {
    const std::vector<std::uint32_t>& next = report_.downstream[1];
    const std::vector<std::uint32_t> sources = upstream(next);
    constexpr std::array<std::uint32_t, 5> kLeast = {3, 8, 24, 72, 216};
    out_ << "<g fill=\"none\" stroke=\"" << kWater << "\">\n";
    for (std::size_t i = 0; i < kLeast.size(); ++i) {
      out_ << "<path stroke-width=\"" << 0.8 + 0.7 * static_cast<double>(i) << "\" d=\"";
      for (std::uint32_t v = 0; v < next.size(); ++v) {
        const bool in_class =
            sources[v] >= kLeast[i] && (i + 1 == kLeast.size() || sources[v] < kLeast[i + 1]);
        if (next[v] != kNoVertex && in_class) put_line({v, next[v]});
      }
      out_ << "\"/>\n";
    }
    out_ << "</g>\n";
  }

  /// How many vertices drain through each, itself included.
  static std::vector<std::uint32_t> upstream(const std::vector<std::uint32_t>& next) {
    std::vector<std::uint32_t> waiting(next.size(), 0), count(next.size(), 1), ready;
    for (const std::uint32_t to : next) {
      if (to != kNoVertex) ++waiting[to];
    }
    for (std::uint32_t v = 0; v < next.size(); ++v) {
      if (waiting[v] == 0) ready.push_back(v);
    }
    for (std::size_t head = 0; head < ready.size(); ++head) {
      const std::uint32_t to = next[ready[head]];
      if (to == kNoVertex) continue;
      count[to] += count[ready[head]];
      if (--waiting[to] == 0) ready.push_back(to);
    }
    return count;
  }

  void put_line(Edge edge) {
    at('M', place(edge.first));
    at('L', place(edge.second));
  }

  /// Each edge of the triangles once, but none of `except`.
  static std::set<Edge> edges_of(const std::vector<IndexTriangle>& triangles) {
    std::set<Edge> edges;
    for (const IndexTriangle& t : triangles) {
      for (std::size_t i = 0; i < 3; ++i) edges.insert(std::minmax({t[i], t[(i + 1) % 3]}));
    }
    return edges;
  }

  void write_edges() {
    std::vector<Edge> edges;
    for (const auto* triangles : result()) {
      for (const IndexTriangle& t : *triangles) {
        for (std::size_t i = 0; i < 3; ++i) edges.push_back(std::minmax({t[i], t[(i + 1) % 3]}));
      }
    }
    std::ranges::sort(edges);
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    out_ << R"(<path fill="none" stroke="#6f6a62" stroke-opacity="0.7" stroke-width="0.5" d=")";
    for (const Edge& edge : edges) put_line(edge);
    out_ << "\"/>\n";
  }

  void write_changes() {
    const std::set<Edge> old = edges_of(report_.before), now = edges_of(report_.after);
    const auto put_missing = [&](const std::set<Edge>& edges, const std::set<Edge>& others) {
      for (const Edge& edge : edges) {
        if (!others.contains(edge)) put_line(edge);
      }
    };
    out_ << "<path fill=\"none\" stroke=\"" << kOld
         << "\" stroke-width=\"1.1\" stroke-dasharray=\"3 3\" d=\"";
    put_missing(old, now);
    out_ << "\"/>\n<path fill=\"none\" stroke=\"" << kNew << "\" stroke-width=\"1.6\" d=\"";
    put_missing(now, old);
    out_ << "\"/>\n";
  }

  /// Areas grow with depth; the deepest that is finite has radius 9.
  double radius(const ReportPit& pit, double deepest) const {
    const double depth = frame_.level(pit.spill_level) - frame_.level(report_.points[pit.vertex].z);
    const double part = std::isfinite(depth) && deepest > 0 ? std::clamp(depth / deepest, 0.0, 1.0) : 1;
    return 2.5 + 6.5 * std::sqrt(part);
  }

  double deepest_pit() const {
    double deepest = 0;
    for (const auto* pits : {&report_.removed, &report_.remaining}) {
      for (const ReportPit& pit : *pits) {
        const double depth = frame_.level(pit.spill_level) - frame_.level(report_.points[pit.vertex].z);
        if (std::isfinite(depth)) deepest = std::max(deepest, depth);
      }
    }
    return deepest;
  }

  void write_pits() {
    const double deepest = deepest_pit();
    const auto circles = [&](const std::vector<ReportPit>& pits, int boundary, std::string_view style) {
      out_ << "<g " << style << ">\n";
      for (const ReportPit& pit : pits) {
        if (boundary >= 0 && pit.boundary != (boundary == 1)) continue;
        const Point2 p = place(pit.vertex);
        out_ << "<circle cx=\"" << digits(p.x) << "\" cy=\"" << digits(p.y) << "\" r=\""
             << digits(radius(pit, deepest)) << "\"/>\n";
      }
      out_ << "</g>\n";
    };
    circles(report_.removed, -1, style_of(kRemoved, false));
    circles(report_.remaining, 1, style_of(kBoundary, true));
    circles(report_.remaining, 0, style_of(kRemaining, true));
  }

  static std::string style_of(std::string_view colour, bool filled) {
    const std::string name(colour);
    return filled ? "fill=\"" + name + "\" fill-opacity=\"0.85\" stroke=\"#fff\" stroke-width=\"0.8\""
                  : "fill=\"#fff\" fill-opacity=\"0.6\" stroke=\"" + name + "\" stroke-width=\"1.6\"";
  }

  void write_legend() {
    const double top = frame_.height() + 2 * kMargin;
    out_ << "<g transform=\"translate(" << kMargin << ' ' << digits(top) << ")\" fill=\"#222\">\n";
    double x = 0;
    const auto label = [&](const std::string& text, double room) {
      out_ << "<text x=\"" << x + 16 << "\" y=\"14\">" << text << "</text>\n";
      x += room;
    };
    const auto circle = [&](std::string_view colour, bool filled) {
      out_ << "<circle cx=\"" << x + 6 << "\" cy=\"9.5\" r=\"5\" " << style_of(colour, filled) << "/>";
    };
    const auto line = [&](std::string_view colour, std::string_view more) {
      out_ << "<path d=\"M" << x - 2 << " 9.5H" << x + 13 << "\" stroke=\"" << colour << "\" " << more
           << "/>";
    };
    if (layers_.pits) {
      std::array<std::size_t, 2> left = {};
      for (const ReportPit& pit : report_.remaining) ++left[pit.boundary ? 1 : 0];
      circle(kRemoved, false);
      label(std::to_string(report_.removed.size()) + " pits removed", 150);
      circle(kRemaining, true);
      label(std::to_string(left[0]) + " remaining", 130);
      circle(kBoundary, true);
      label(std::to_string(left[1]) + " on the boundary", 160);
    }
    if (layers_.changes) {
      line(kOld, "stroke-width=\"1.1\" stroke-dasharray=\"3 3\"");
      label("Delaunay edge given up", 192);
      line(kNew, "stroke-width=\"1.6\"");
      label("new edge", 90);
    }
    if (layers_.flow) {
      line(kWater, "stroke-width=\"2\"");
      label("flow", 60);
    }
    write_scale_bar();
    out_ << "<text x=\"0\" y=\"42\" fill=\"#666\">" << markup_text(file_name()) << ", order " << report_.order
         << ": " << report_.pits[0].total << " pits in the Delaunay triangulation, " << report_.pits[1].total
         << " here" << (layers_.pits ? "; circles are larger the deeper the pit" : "") << "</text>\n</g>\n";
  }

  void write_scale_bar() {
    const double units = frame_.units();
    if (!std::isfinite(units * kSize) || !(units > 0)) return;
    const double length = round_length(units * kSize / 5), drawn = digits(length / units);
    out_ << "<g transform=\"translate(0 62)\"><path d=\"M0 0v6H" << drawn
         << "v-6\" fill=\"none\" stroke=\"#222\"/><text x=\"" << drawn + 8 << "\" y=\"7\">"
         << number_text(length) << "</text></g>\n";
  }

  /// Without the folders it is in.
  std::string_view file_name() const {
    const std::string_view path = report_.file;
    return path.substr(path.rfind('/') + 1);
  }

  RowWriter& out_;
  const Report& report_;
  const MapLayers& layers_;
  MapFrame frame_;
};

}  // namespace

std::optional<Error> write_svg_map(OutputFile& output, const Report& report, const MapLayers& layers) {
  RowWriter out(output);
  SvgMap(out, report, layers).write();
  out.flush();
  return output.error();
}

}  // namespace thalweg::io
