#include "cli/thin_report.hpp"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "cli/mesh_measures.hpp"
#include "terrain/thin_out.hpp"

namespace thalweg::cli {
namespace {

/// A page with so many opens within a few seconds and stays fluid.
constexpr std::size_t kMostTriangles = 1'000'000;
/// How far, in edges, everything is kept around pits and changes, if there is room for it.
constexpr int kRings = 3;

/// Marks all vertices of triangles that have a marked one.
void grow(std::span<const io::IndexTriangle> triangles, std::vector<std::uint8_t>& marked) {
  const std::vector<std::uint8_t> before = marked;
  for (const io::IndexTriangle& t : triangles) {
    if ((before[t[0]] | before[t[1]] | before[t[2]]) == 0) continue;
    for (const std::uint32_t v : t) marked[v] = 1;
  }
}

std::size_t count(const std::vector<std::uint8_t>& marked) {
  return static_cast<std::size_t>(std::ranges::count(marked, 1));
}

/// Vertices that stay: of changes, of pits, where the longest paths begin, and around them as far as about
/// half of all that may be drawn lasts.
std::vector<std::uint8_t> vertices_to_keep(const io::Report& report) {
  std::vector<std::uint8_t> keep(report.points.size(), 0);
  for (const auto* triangles : {&report.before, &report.after}) {
    for (const io::IndexTriangle& t : *triangles) {
      for (const std::uint32_t v : t) keep[v] = 1;
    }
  }
  for (const auto* pits : {&report.removed, &report.remaining}) {
    for (const io::ReportPit& pit : *pits) keep[pit.vertex] = 1;
  }
  for (std::size_t which = 0; which < 2; ++which) {
    // Sinks that are listed as pits of the other terrain alone are kept all the same.
    for (std::uint32_t v = 0; v < keep.size(); ++v) {
      if (report.downstream[which][v] == io::kNoVertex) keep[v] = 1;
    }
    if (report.water[which].longest_from != io::kNoVertex) keep[report.water[which].longest_from] = 1;
  }
  for (int ring = 0; ring < kRings; ++ring) {
    std::vector<std::uint8_t> more = keep;
    grow(report.common, more);
    if (2 * count(more) > kMostTriangles / 2) break;
    keep = std::move(more);
  }
  return keep;
}

/// For each vertex the first of its path, itself included, that is left.
std::vector<std::uint32_t> first_left(std::span<const std::uint32_t> downstream,
                                      std::span<const std::uint8_t> left) {
  std::vector<std::uint32_t> first(downstream.size(), io::kNoVertex);
  std::vector<std::uint32_t> path;
  for (std::uint32_t start = 0; start < first.size(); ++start) {
    std::uint32_t v = start;
    for (; v != io::kNoVertex && first[v] == io::kNoVertex && left[v] == 0; v = downstream[v])
      path.push_back(v);
    const std::uint32_t end = v == io::kNoVertex ? v : left[v] != 0 ? v : first[v];
    if (v != io::kNoVertex && left[v] != 0) first[v] = v;
    for (; !path.empty(); path.pop_back()) first[path.back()] = end;
  }
  return first;
}

void rename(std::vector<io::IndexTriangle>& triangles, std::span<const std::uint32_t> number) {
  for (io::IndexTriangle& t : triangles) {
    for (std::uint32_t& v : t) v = number[v];
  }
}

/// Drops all vertices that are not left, and gives the others new numbers.
void drop_vertices(io::Report& report, std::span<const std::uint8_t> left) {
  std::vector<std::uint32_t> number(left.size(), io::kNoVertex), old;
  for (std::uint32_t v = 0; v < left.size(); ++v) {
    if (left[v] == 0) continue;
    number[v] = static_cast<std::uint32_t>(old.size());
    old.push_back(v);
  }
  for (std::vector<std::uint32_t>& downstream : report.downstream) {
    const std::vector<std::uint32_t> first = first_left(downstream, left);
    std::vector<std::uint32_t> shorter;
    for (const std::uint32_t v : old) {
      const std::uint32_t next = downstream[v] == io::kNoVertex ? io::kNoVertex : first[downstream[v]];
      shorter.push_back(next == io::kNoVertex ? next : number[next]);
    }
    downstream = std::move(shorter);
  }
  std::vector<Point3> points;
  std::vector<std::uint32_t> names;
  for (const std::uint32_t v : old) {
    points.push_back(report.points[v]);
    names.push_back(report.names[v]);
  }
  report.points = std::move(points);
  report.names = std::move(names);
  for (auto* triangles : {&report.common, &report.before, &report.after}) rename(*triangles, number);
  for (auto* pits : {&report.removed, &report.remaining}) {
    for (io::ReportPit& pit : *pits) pit.vertex = number[pit.vertex];
  }
  for (io::ReportWater& water : report.water) {
    if (water.longest_from != io::kNoVertex) water.longest_from = number[water.longest_from];
  }
}

}  // namespace

void thin_report(io::Report& report) {
  const std::size_t changed = std::max(report.before.size(), report.after.size());
  if (report.common.size() + changed <= kMostTriangles) return;
  const std::vector<std::uint8_t> keep = vertices_to_keep(report);
  std::vector<io::IndexTriangle> mesh = report.common;
  mesh.insert(mesh.end(), report.after.begin(), report.after.end());
  mesh = detail::thin_out(places_of(report.points), std::move(mesh), keep, kMostTriangles);

  // Triangles of kept vertices alone are never taken out, so those of the result are the same as before.
  std::vector<io::IndexTriangle> changes = report.after;
  const auto normal = [](io::IndexTriangle t) {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    return t;
  };
  for (io::IndexTriangle& t : changes) t = normal(t);
  std::ranges::sort(changes);
  std::erase_if(mesh,
                [&](const io::IndexTriangle& t) { return std::ranges::binary_search(changes, normal(t)); });
  report.common = std::move(mesh);

  std::vector<std::uint8_t> left = keep;
  for (const io::IndexTriangle& t : report.common) {
    for (const std::uint32_t v : t) left[v] = 1;
  }
  drop_vertices(report, left);
}

}  // namespace thalweg::cli
