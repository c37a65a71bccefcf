/// A cloud with everything the library and the oracle derive from it.
#pragma once

#include <span>
#include <vector>

#include "oracle/terrain.hpp"
#include "support/cloud.hpp"
#include "support/ids.hpp"
#include "thalweg/thalweg.hpp"

namespace support {

/// The faces as the oracle writes them.
inline std::vector<oracle::Tri> triangles_of(const thalweg::Triangulation& t) {
  std::vector<oracle::Tri> result;
  for (std::uint32_t f = 0; f < t.face_count(); ++f) {
    const thalweg::Triangle c = t.corners(thalweg::FaceId(f));
    result.push_back({c[0].index(), c[1].index(), c[2].index()});
  }
  return result;
}

inline std::vector<thalweg::Triangle> with_ids(std::span<const oracle::Tri> triangles) {
  std::vector<thalweg::Triangle> result;
  for (const oracle::Tri& t : triangles) result.push_back(tri(t[0], t[1], t[2]));
  return result;
}

/// The Delaunay triangulation of a cloud and its graph. Stays where it is: the graph refers to its siblings.
struct Prepared {
  explicit Prepared(const Cloud& cloud)
      : places(cloud.places()),
        z(cloud.elevations()),
        sites(oracle::sites_of(std::span<const thalweg::Point3>(cloud.points))),
        delaunay(thalweg::delaunay(places).value()),
        graph(places, delaunay) {}
  Prepared(const Prepared&) = delete;
  Prepared& operator=(const Prepared&) = delete;

  std::uint32_t size() const { return static_cast<std::uint32_t>(places.size()); }

  std::vector<thalweg::Point2> places;
  std::vector<double> z;
  std::vector<oracle::Site> sites;
  thalweg::Triangulation delaunay;
  thalweg::DelaunayGraph graph;
};

}  // namespace support
