#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "io/point_table.hpp"
#include "io/write_mesh.hpp"
#include "io/write_pits.hpp"
#include "support/io_support.hpp"

namespace thalweg::io {
namespace {

using test::content_of;
using test::same_bits;
using test::ScratchFolder;

const std::vector<Point3> kFour = {{0, 0, 1}, {1, 0, -0.0}, {0, 1, 3.5}, {400000, 1e300, 0.1}};
const std::vector<IndexTriangle> kPair = {{0, 1, 2}, {1, 3, 2}};
const std::vector<std::uint8_t> kPit = {0, 1, 0, 0};
const std::vector<std::uint32_t> kOrder = {0, 7};

template <class Write>
std::string written(const ScratchFolder& folder, const Write& write) {
  const std::string path = folder / "out";
  auto file = OutputFile::open(path, {.overwrite = true});
  EXPECT_TRUE(file);
  const auto error = write(*file);
  EXPECT_FALSE(error) << error->message;
  EXPECT_FALSE(file->commit());
  return content_of(path);
}

std::string mesh_text(const MeshView& mesh, Format format) {
  return written(ScratchFolder(), [&](OutputFile& file) { return write_mesh(file, mesh, format); });
}

TEST(WritePly, AsciiIsTheDialectOfQgis) {
  EXPECT_EQ(mesh_text({kFour, kPair, kPit, kOrder, "EPSG:28992\nnot a second line"}, Format::ply_ascii),
            "ply\nformat ascii 1.0\ncomment written by thalweg\ncomment crs: EPSG:28992 not a second line\n"
            "element vertex 4\nproperty double x\nproperty double y\nproperty double z\nproperty uchar pit\n"
            "element face 2\nproperty list uchar int vertex_indices\nproperty int order\nend_header\n"
            "0 0 1 0\n1 0 -0 1\n0 1 3.5 0\n400000 1e+300 0.1 0\n3 0 1 2 0\n3 1 3 2 7\n");
}

TEST(WritePly, BinaryHasTheSizesThatItsHeaderSays) {
  const std::string full = mesh_text({kFour, kPair, kPit, kOrder, ""}, Format::ply);
  EXPECT_TRUE(full.starts_with(
      "ply\nformat binary_little_endian 1.0\ncomment written by thalweg\nelement vertex 4\n"));
  EXPECT_EQ(full.size() - full.find("end_header\n") - 11, 4u * (24 + 1) + 2u * (1 + 12 + 4));
  const std::string bare = mesh_text({kFour, kPair, {}, {}, ""}, Format::ply);
  EXPECT_EQ(bare.size() - bare.find("end_header\n") - 11, 4u * 24 + 2u * 13);
  EXPECT_EQ(bare.find("pit"), std::string::npos);
  EXPECT_EQ(bare.find("order"), std::string::npos);
}

TEST(WriteMesh, ObjAnd2dmNumberFromOne) {
  EXPECT_EQ(mesh_text({kFour, kPair, kPit, kOrder, ""}, Format::obj),
            "# thalweg terrain: 4 vertices, 2 triangles\nv 0 0 1\nv 1 0 -0\nv 0 1 3.5\nv 400000 1e+300 0.1\n"
            "f 1 2 3\nf 2 4 3\n");
  EXPECT_EQ(mesh_text({kFour, kPair, kPit, kOrder, ""}, Format::two_dm),
            "MESH2D\nND 1 0 0 1\nND 2 1 0 -0\nND 3 0 1 3.5\nND 4 400000 1e+300 0.1\n"
            "E3T 1 1 2 3 1\nE3T 2 2 4 3 1\n");
}

TEST(WriteMesh, RowsAreTheVertices) {
  EXPECT_EQ(mesh_text({kFour, kPair, kPit, kOrder, ""}, Format::csv),
            "x,y,z,pit\n0,0,1,0\n1,0,-0,1\n0,1,3.5,0\n400000,1e+300,0.1,0\n");
  EXPECT_EQ(mesh_text({kFour, kPair, {}, {}, ""}, Format::xyz),
            "0 0 1\n1 0 -0\n0 1 3.5\n400000 1e+300 0.1\n");
}

TEST(WriteMesh, FormatThatCannotHoldItIsRefused) {
  const ScratchFolder folder;
  auto file = OutputFile::open(folder / "out");
  ASSERT_TRUE(file);
  const auto mesh = write_mesh(*file, {kFour, kPair, {}, {}, ""}, Format::geojson);
  ASSERT_TRUE(mesh);
  EXPECT_EQ(mesh->code, ErrorCode::invalid_argument);
  EXPECT_TRUE(write_points(*file, kFour, Format::ply));
  EXPECT_TRUE(write_pits(*file, {}, Format::obj));
}

// Every mesh format, and every format of points, brings back each double bit for bit.
TEST(RoundTrip, OfNastyDoublesIsExact) {
  const ScratchFolder folder;
  const std::vector<Point3> points = test::nasty_points();
  std::vector<IndexTriangle> triangles;
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 2; i < points.size(); ++i) {
    triangles.push_back({i - 2, i, i - 1});
    order.push_back(i % 9);
  }
  const std::vector<std::uint8_t> pit(points.size(), 1);
  for (const auto& [name, format] : {std::pair{"m.ply", Format::ply},
                                     {"a.ply", Format::ply_ascii},
                                     {"m.obj", Format::obj},
                                     {"m.2dm", Format::two_dm}}) {
    auto file = OutputFile::open(folder / name);
    ASSERT_TRUE(file);
    ASSERT_FALSE(write_mesh(*file, {points, triangles, pit, order, "EPSG:4326"}, format));
    ASSERT_FALSE(file->commit());
    const auto mesh = read_mesh(folder / name);
    ASSERT_TRUE(mesh) << mesh.error().message;
    EXPECT_TRUE(same_bits(mesh->points, points)) << name;
    EXPECT_EQ(mesh->triangles, triangles) << name;
  }
  for (const auto& [name, format] :
       {std::pair{"p.xyz", Format::xyz}, {"p.csv", Format::csv}, {"p.tsv", Format::tsv}}) {
    auto file = OutputFile::open(folder / name);
    ASSERT_TRUE(file);
    ASSERT_FALSE(write_points(*file, points, format));
    ASSERT_FALSE(file->commit());
    const auto table = read_points(folder / name);
    ASSERT_TRUE(table) << table.error().message;
    EXPECT_TRUE(same_bits(table->points, points)) << name;
  }
}

std::string pits_text(const std::vector<PitFeature>& pits, Format format) {
  return written(ScratchFolder(), [&](OutputFile& file) { return write_pits(file, pits, format); });
}

const std::vector<PitFeature> kPits = {
    {1.5, 2, -0.0, 7, true, false, "unremovable", 12, 3},
    {0.1, 1e300, 5, 9, false, true, "a \"quoted\", \\ reason\n", std::nullopt, 1},
};

TEST(WritePits, GeoJsonIsEscapedAndExact) {
  EXPECT_EQ(
      pits_text(kPits, Format::geojson),
      "{\"type\":\"FeatureCollection\",\"features\":[\n"
      R"({"type":"Feature","geometry":{"type":"Point","coordinates":[1.5,2,-0]},"properties":{"vertex":7,"z":-0,)"
      R"("boundary":true,"removed":false,"reason":"unremovable","order_needed":12,"vertices":3}})"
      ",\n"
      R"({"type":"Feature","geometry":{"type":"Point","coordinates":[0.1,1e+300,5]},"properties":{"vertex":9,"z":5,)"
      R"("boundary":false,"removed":true,"reason":"a \"quoted\", \\ reason\u000a","order_needed":null,"vertices":1}})"
      "\n]}\n");
  EXPECT_EQ(pits_text({}, Format::geojson), "{\"type\":\"FeatureCollection\",\"features\":[\n]}\n");
}

TEST(WritePits, CsvQuotesWhatItMust) {
  EXPECT_EQ(pits_text(kPits, Format::csv),
            "x,y,z,vertex,boundary,removed,reason,order_needed,vertices\n"
            "1.5,2,-0,7,true,false,unremovable,12,3\n"
            "0.1,1e+300,5,9,false,true,\"a \"\"quoted\"\", \\ reason\n\",,1\n");
}

}  // namespace
}  // namespace thalweg::io
