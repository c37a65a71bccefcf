#include "io/write_report.hpp"

#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/deflate.hpp"
#include "io/html_text.hpp"
#include "io/report_assets.hpp"
#include "io/report_payload.hpp"
#include "io/row_writer.hpp"
#include "thalweg/version.hpp"

namespace thalweg::io {
namespace {

void put(RowWriter& out, double value) {
  std::isfinite(value) ? out << value : out << "null";
}
template <std::unsigned_integral T>
void put(RowWriter& out, T value) {
  out << value;
}
void put(RowWriter& out, bool value) {
  out << (value ? "true" : "false");
}
void put(RowWriter& out, const std::string& text) {
  out << script_string(text);
}
void put(RowWriter& out, const std::optional<unsigned>& value) {
  value ? out << *value : out << "null";
}

/// "name":value
template <class T>
RowWriter& field(RowWriter& out, std::string_view name, const T& value) {
  out << '"' << name << "\":";
  put(out, value);
  return out;
}

/// "name":[...], one entry for each of `items`.
template <class Item, class Value>
RowWriter& column(RowWriter& out, std::string_view name, std::span<const Item> items, Value&& value) {
  out << '"' << name << "\":[";
  const char* separator = "";
  for (const Item& item : items) {
    out << separator;
    put(out, value(item));
    separator = ",";
  }
  return out << ']';
}

void put_axis(RowWriter& out, std::string_view name, const PackedAxis& axis) {
  field(out << '"' << name << "\":{", "origin", axis.frame.origin) << ',';
  field(out, "unit", axis.frame.unit) << ',';
  field(out, "steps", axis.steps) << ',';
  field(out, "bytes", axis.residual_bytes) << '}';
}

void put_pits(RowWriter& out, std::string_view name, std::span<const ReportPit> pits, const Report& report,
              const Payload& payload) {
  const auto point = [&](const ReportPit& pit) -> const Point3& { return report.points[pit.vertex]; };
  out << '"' << name << "\":{";
  column(out, "vertex", pits, [&](const ReportPit& p) { return payload.position[p.vertex]; }) << ",\n";
  column(out, "x", pits, [&](const ReportPit& p) { return point(p).x; }) << ",\n";
  column(out, "y", pits, [&](const ReportPit& p) { return point(p).y; }) << ",\n";
  column(out, "z", pits, [&](const ReportPit& p) { return point(p).z; }) << ",\n";
  column(out, "spill", pits, [](const ReportPit& p) { return p.spill_level; }) << ",\n";
  column(out, "boundary", pits, [](const ReportPit& p) { return p.boundary; }) << ",\n";
  column(out, "vertices", pits, [](const ReportPit& p) { return p.vertices; }) << ",\n";
  column(out, "reason", pits, [](const ReportPit& p) { return p.reason; }) << ",\n";
  column(out, "need", pits, [](const ReportPit& p) { return p.order_needed; }) << '}';
}

void put_pit_counts(RowWriter& out, std::span<const PitCount> counts) {
  const auto counted = [&](std::string_view name, auto value) -> RowWriter& {
    return column(out, name, counts, value);
  };
  out << "\"pits\":{";
  counted("total", [](const PitCount& c) { return c.total; }) << ',';
  counted("interior", [](const PitCount& c) { return c.interior; }) << ',';
  counted("boundary", [](const PitCount& c) { return c.boundary; }) << '}';
}

void put_water(RowWriter& out, const Report& report, const Payload& payload) {
  const std::span<const ReportWater> water = report.water;
  const auto start = [&](const ReportWater& w) {
    return w.longest_from == kNoVertex ? kNoVertex : payload.position[w.longest_from];
  };
  out << "\"water\":{";
  column(out, "basins", water, [](const ReportWater& w) { return w.basins; }) << ',';
  column(out, "from", water, start) << ',';
  column(out, "edges", water, [](const ReportWater& w) { return w.longest_edges; }) << ',';
  column(out, "length", water, [](const ReportWater& w) { return w.longest_length; }) << '}';
}

void put_sweep(RowWriter& out, std::span<const SweepRow> rows) {
  out << "\"sweep\":{";
  column(out, "order", rows, [](const SweepRow& r) { return r.order; }) << ',';
  column(out, "flip", rows, [](const SweepRow& r) { return r.flip; }) << ',';
  column(out, "hull", rows, [](const SweepRow& r) { return r.hull; }) << ',';
  column(out, "best", rows, [](const SweepRow& r) { return r.best; }) << ',';
  column(out, "bound", rows, [](const SweepRow& r) { return r.lower_bound; }) << ',';
  column(out, "certified", rows, [](const SweepRow& r) { return r.certified; }) << '}';
}

void put_drawn(RowWriter& out, const Report& report, const Payload& payload) {
  out << "\"drawn\":{";
  field(out, "vertices", report.points.size()) << ',';
  field(out, "common", report.common.size()) << ',';
  field(out, "before", report.before.size()) << ',';
  field(out, "after", report.after.size()) << ',';
  field(out, "changed_flows", payload.changed_flows) << ",\n";
  put_axis(out, "x", payload.x);
  put_axis(out << ',', "y", payload.y);
  put_axis(out << ',', "z", payload.z);
  out << '}';
}

void put_data(RowWriter& out, const Report& report, const Payload& payload) {
  field(out << '{', "version", std::string(version())) << ',';
  field(out, "file", report.file) << ',';
  field(out, "crs", report.crs) << ',';
  field(out, "method", report.method) << ',';
  field(out, "order", report.order) << ",\n";
  field(out, "rows", report.rows) << ',';
  field(out, "vertices", report.vertices) << ',';
  field(out, "triangles", report.triangles) << ',';
  field(out, "merged", report.merged) << ",\n";
  put_pit_counts(out, report.pits);
  field(out << ",\n", "lower_bound", report.lower_bound) << ',';
  field(out, "certified", report.certified) << ',';
  field(out, "order_searched", report.order_searched) << ",\n";
  field(out, "edges_changed", report.edges_changed) << ',';
  field(out, "non_delaunay_edges", report.non_delaunay_edges) << ',';
  column(out, "order_histogram", std::span<const std::uint64_t>(report.order_histogram),
         [](std::uint64_t count) { return count; })
      << ',';
  column(out, "min_angle_deg", std::span<const double>(report.min_angle_deg), [](double a) { return a; })
      << ",\n";
  field(out, "hash_in", report.hash_in) << ",\n";
  field(out, "hash_out", report.hash_out) << ",\n";
  put_water(out, report, payload);
  put_sweep(out << ",\n", report.sweep);
  put_drawn(out << ",\n", report, payload);
  put_pits(out << ",\n", "removed", report.removed, report, payload);
  put_pits(out << ",\n", "remaining", report.remaining, report, payload);
  out << "}\n";
}

std::string compressed(std::span<const std::uint8_t> bytes) {
  return base64(deflate(bytes));
}

std::span<const std::uint8_t> bytes_of(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

/// What stands for a marker of page.html.
void put_part(RowWriter& out, std::string_view name, const Report& report, const Payload& payload) {
  if (name == "TITLE") {
    out << markup_text(report.file);
  } else if (name == "STYLE") {
    out << kReportStyle;
  } else if (name == "SCRIPT") {
    out << kReportScript;
  } else if (name == "DATA") {
    put_data(out, report, payload);
  } else if (name == "PAYLOAD") {
    out << compressed(payload.bytes);
  } else if (name == "THREE") {
    out << compressed(bytes_of(kThreeScript));
  } else if (name == "LICENCE") {
    out << markup_text(kThreeLicence);
  }
}

}  // namespace

std::optional<Error> write_report(OutputFile& output, const Report& report) {
  const Payload payload = pack(report);
  RowWriter out(output);
  std::string_view page = kReportPage;
  while (!out.failed()) {
    const std::size_t from = page.find('@');
    out << page.substr(0, from);
    if (from == std::string_view::npos) break;
    const std::size_t to = page.find('@', from + 1);
    put_part(out, page.substr(from + 1, to - from - 1), report, payload);
    page.remove_prefix(to + 1);
  }
  out.flush();
  return output.error();
}

}  // namespace thalweg::io
