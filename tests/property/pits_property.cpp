/// Pits against their definition, on random triangulations of degenerate and flat terrains.
#include "thalweg/pits.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <vector>

#include "oracle/terrain.hpp"
#include "support/prepared.hpp"

namespace {

RC_GTEST_PROP(PitsLaws, AreTheDefinition, ()) {
  const auto cloud = *support::clouds(25);
  const auto sites = oracle::sites_of(std::span<const thalweg::Point3>(cloud.points));
  const auto triangles = oracle::any_triangulation(sites);
  const auto mesh = thalweg::Triangulation::from_triangles(support::with_ids(triangles), cloud.size());
  RC_ASSERT(mesh.has_value());

  const std::vector<oracle::Pit> expected = oracle::pits(sites, triangles);
  const thalweg::Pits found = thalweg::find_pits(*mesh, cloud.elevations());
  RC_ASSERT(found.size() == expected.size());
  thalweg::PitCount count;
  for (std::uint32_t i = 0; i < found.size(); ++i) {
    std::vector<std::uint32_t> vertices;
    for (const thalweg::VertexId v : found[i]) vertices.push_back(v.index());
    RC_ASSERT(vertices == expected[i].vertices);
    RC_ASSERT(found.boundary(i) == expected[i].boundary);
    ++count.total;
    ++(expected[i].boundary ? count.boundary : count.interior);
  }
  RC_ASSERT(found.count() == count);
}

}  // namespace
