/// Triangulations that are far from Delaunay, made by random flips that the oracle has judged.
#pragma once

#include <rapidcheck.h>

#include <optional>
#include <vector>

#include "oracle/terrain.hpp"
#include "support/prepared.hpp"
#include "thalweg/triangulation.hpp"

namespace support {

/// A number in [0, size), whatever the size parameter. Requires: size > 0.
inline std::uint32_t random_index(std::uint32_t size) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<std::uint32_t>(0, size));
}

/// Whether h can be flipped: the two triangles at it form a strictly convex quadrilateral.
inline bool flippable(std::span<const oracle::Site> s, const thalweg::Triangulation& t,
                      thalweg::HalfedgeId h) {
  if (t.on_hull(h)) return false;
  return oracle::cross(s[t.origin(h).index()], s[t.dest(h).index()], s[t.apex(h).index()],
                       s[t.apex(t.twin(h)).index()]);
}

/// Flips a random half-edge, if it can be flipped; returns whether it was.
inline bool flip_somewhere(std::span<const oracle::Site> s, thalweg::Triangulation& t) {
  const thalweg::HalfedgeId h(random_index(t.halfedge_count()));
  if (!flippable(s, t, h)) return false;
  t.flip(h);
  return true;
}

inline thalweg::Triangulation triangulation_of(std::span<const oracle::Site> s) {
  const auto triangles = oracle::any_triangulation(s);
  return thalweg::Triangulation::from_triangles(with_ids(triangles), static_cast<std::uint32_t>(s.size()))
      .value();
}

/// A triangulation of the sites after `flips` attempts to flip something.
inline thalweg::Triangulation random_triangulation(std::span<const oracle::Site> s, int flips) {
  thalweg::Triangulation t = triangulation_of(s);
  for (int i = 0; i < flips; ++i) flip_somewhere(s, t);
  return t;
}

}  // namespace support
