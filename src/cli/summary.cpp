/// What a build found.
#include "cli/summary.hpp"

#include <algorithm>
#include <array>

#include "cli/names.hpp"
#include "cli/resources.hpp"
#include "cli/text.hpp"
#include "thalweg/version.hpp"

namespace thalweg::cli {
namespace {

Json remaining_to_json(const BuildReport& report) {
  Json list = Json::array();
  for (const RemainingPit& pit : report.result->remaining) {
    const std::uint32_t vertex = report.vertices->vertex_of_row[pit.vertex.index()];
    const Point3& p = report.vertices->points[vertex];
    Json entry = {{"vertex", vertex},
                  {"x", p.x},
                  {"y", p.y},
                  {"z", p.z},
                  {"boundary", pit.boundary},
                  {"reason", name_of(pit.reason)},
                  {"order_needed", nullptr}};
    if (pit.order_needed) entry["order_needed"] = *pit.order_needed;
    list.push_back(std::move(entry));
  }
  return list;
}

Json mesh_to_json(const Minimized& result) {
  const std::vector<std::uint64_t> histogram = order_histogram(result.face_orders);
  return {
      {"triangles", result.triangulation.face_count()},
      {"max_order", histogram.empty() ? 0 : histogram.size() - 1},
      {"order_histogram", histogram},
      {"edges_changed", result.edges_changed},
      {"non_delaunay_edges", result.non_delaunay_edges},
      {"min_angle_deg", {{"before", result.min_angle_before_deg}, {"after", result.min_angle_after_deg}}}};
}

std::string arrow(std::uint64_t before, std::uint64_t after) {
  return std::to_string(before) + " -> " + std::to_string(after);
}

std::string pits_line(const Minimized& result, unsigned order) {
  const std::string proof =
      result.certified ? "; proved: no triangulation of order " + std::to_string(order) + " has fewer"
                       : "; not proved minimal: the lower bound is " + std::to_string(result.lower_bound);
  return "  pits       " + arrow(result.delaunay_pits.total, result.pits.total) + " (interior " +
         arrow(result.delaunay_pits.interior, result.pits.interior) + ", boundary " +
         arrow(result.delaunay_pits.boundary, result.pits.boundary) + ")" + proof;
}

std::string reasons_line(const Minimized& result) {
  std::array<std::uint64_t, 3> counts{};
  for (const RemainingPit& pit : result.remaining) ++counts[static_cast<std::size_t>(pit.reason)];
  const std::array<std::string, 3> words = {" unremovable at this order", " in conflict with others",
                                            " kept by the method"};
  std::string line;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] > 0) line += (line.empty() ? "" : ", ") + std::to_string(counts[i]) + words[i];
  }
  return "  remaining  " + line;
}

std::string mesh_line(const Minimized& result) {
  const std::vector<std::uint64_t> histogram = order_histogram(result.face_orders);
  const std::uint64_t highest = histogram.empty() ? 0 : histogram.size() - 1;
  return "  mesh       " + counted(result.triangulation.face_count(), "triangle", "triangles") +
         ", highest order " + std::to_string(highest) + ", " +
         counted(result.edges_changed, "edge changed", "edges changed") + " (" +
         std::to_string(result.non_delaunay_edges) + " not locally Delaunay), smallest angle " +
         format_fixed(result.min_angle_before_deg, 2) + " -> " + format_fixed(result.min_angle_after_deg, 2) +
         " degrees";
}

std::string time_line(const BuildReport& report) {
  return "  time       " + format_fixed(report.seconds_total, 2) + " s (read " +
         format_fixed(report.seconds_read, 2) + ", delaunay " +
         format_fixed(report.result->seconds_delaunay, 2) + ", minimize " +
         format_fixed(report.result->seconds_minimize, 2) + ", write " +
         format_fixed(report.seconds_write, 2) + "), peak memory " + format_bytes(peak_memory_bytes());
}

}  // namespace

Json new_summary() {
  return {{"tool", "thalweg"}, {"version", version()}};
}

Json to_json(const PitCount& pits) {
  return {{"total", pits.total}, {"interior", pits.interior}, {"boundary", pits.boundary}};
}

std::vector<std::uint64_t> order_histogram(std::span<const std::uint32_t> orders) {
  std::vector<std::uint64_t> histogram;
  for (const std::uint32_t order : orders) {
    if (order >= histogram.size()) histogram.resize(std::size_t{order} + 1, 0);
    ++histogram[order];
  }
  return histogram;
}

Json summarize(const BuildReport& report) {
  const Minimized& result = *report.result;
  Json summary = new_summary();
  summary["input"] = {{"file", report.file},
                      {"points", report.points},
                      {"vertices", result.sites},
                      {"duplicates", result.merged.size()},
                      {"policy", name_of(report.policy)}};
  summary["parameters"] = {
      {"order", report.order}, {"method", name_of(report.method)}, {"threads", report.threads}};
  summary["pits"] = {{"delaunay", to_json(result.delaunay_pits)},
                     {"result", to_json(result.pits)},
                     {"lower_bound", result.lower_bound},
                     {"certified", result.certified},
                     {"remaining", remaining_to_json(report)}};
  summary["mesh"] = mesh_to_json(result);
  summary["work"] = {
      {"flips", result.flips}, {"insertions", result.insertions}, {"circle_counts", result.circle_counts}};
  summary["seconds"] = {{"read", report.seconds_read},
                        {"delaunay", result.seconds_delaunay},
                        {"minimize", result.seconds_minimize},
                        {"write", report.seconds_write},
                        {"total", report.seconds_total}};
  summary["peak_memory_bytes"] = peak_memory_bytes();
  return summary;
}

void describe(const BuildReport& report, Console& console) {
  const Minimized& result = *report.result;
  console.note(report.file + ": " + counted(report.points, "point", "points") + ", " +
               counted(result.sites, "site", "sites") + "; method " + std::string(name_of(report.method)) +
               ", order " + std::to_string(report.order));
  console.note(pits_line(result, report.order));
  if (!result.remaining.empty()) console.note(reasons_line(result));
  console.note(mesh_line(result));
  console.detail("  work       " + counted(result.flips, "flip", "flips") + ", " +
                 counted(result.insertions, "insertion", "insertions") + ", " +
                 counted(result.circle_counts, "circle counted", "circles counted"));
  console.note(time_line(report));
}

std::string to_text(const Json& summary) {
  return summary.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace thalweg::cli
