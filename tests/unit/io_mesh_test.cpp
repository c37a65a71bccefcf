#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "io/mesh_file.hpp"
#include "io/point_table.hpp"
#include "support/io_support.hpp"

namespace thalweg::io {
namespace {

using test::message_of;

const std::vector<Point3> kFour = {{0, 0, 1}, {1, 0, 2}, {0, 1, 3.5}, {1, 1, -4}};
const std::vector<IndexTriangle> kPair = {{0, 1, 2}, {1, 3, 2}};

class MeshReading : public testing::Test {
 protected:
  explicit MeshReading(std::string name) : name_(std::move(name)) {}
  Result<MeshFile> read(std::string_view content) {
    path_ = folder_.put(name_, content);
    return read_mesh(path_);
  }
  void expect_pair(std::string_view content) {
    const auto mesh = read(content);
    ASSERT_TRUE(mesh) << mesh.error().message << "\n" << content;
    EXPECT_EQ(mesh->points, kFour) << content;
    EXPECT_EQ(mesh->triangles, kPair) << content;
    const auto table = read_points(path_);
    ASSERT_TRUE(table);
    EXPECT_EQ(table->points, kFour);
  }
  void expect_fault(std::string_view content, const std::string& what) {
    const std::string message = message_of(read(content), path_);
    EXPECT_TRUE(message.starts_with(name_ + what)) << message << "\nshould start with " << name_ << what;
  }
  test::ScratchFolder folder_;
  std::string name_;
  std::string path_;
};

struct ReadObj : MeshReading {
  ReadObj() : MeshReading("m.obj") {}
};

const std::string kObj = "v 0 0 1\nv 1 0 2\nv 0 1 3.5\nv 1 1 -4\n";

TEST_F(ReadObj, EveryFormOfAFace) {
  expect_pair(kObj + "f 1 2 3\nf 2 4 3\n");
  expect_pair(kObj + "f 1/1 2/2 3/3\nf 2/1/1 4/2/2 3/3/3\n");
  expect_pair(kObj + "f 1//1 2//1 3//1\nf -3 -1 -2\n");
  expect_pair(kObj + "vn 0 0 1\nvt 0 0\no terrain\ng a\ns off\nusemtl m\nf 1 2 3\r\n\n# end\nf 2 4 3");
}

TEST_F(ReadObj, VertexMayFollowTheFaceThatUsesIt) {
  expect_pair("f 1 2 3\nf 2 4 3\n" + kObj);
}

TEST_F(ReadObj, NegativeIndicesCountFromTheVerticesSoFar) {
  const auto mesh = read("v 0 0 1\nv 1 0 2\nv 0 1 3.5\nf -3 -2 -1\nv 1 1 -4\nf -3 -1 -2\n");
  ASSERT_TRUE(mesh);
  EXPECT_EQ(mesh->triangles, kPair);
}

TEST_F(ReadObj, MoreNumbersAfterTheCoordinatesAreSkipped) {
  expect_pair("v 0 0 1 1\nv 1 0 2 0.5 0.5 0.5\nv 0 1 3.5\nv 1 1 -4\nf 1 2 3\nf 2 4 3\n");
}

TEST_F(ReadObj, FaultNamesTheLine) {
  expect_fault(kObj + "f 1 2 3\nf 2 4 5\n", ":6: vertex 5 does not exist: there are 4, numbered from 1");
  expect_fault(kObj + "f 0 2 3\n", ":5: vertex \"0\" does not exist");
  expect_fault(kObj + "f -5 2 3\n", ":5: vertex \"-5\" does not exist");
  expect_fault(kObj + "f 99999999999999999999 2 3\n", ":5: vertex \"99999999999999999999\" does not exist");
  expect_fault(kObj + "f a 2 3\n", ":5: \"a\" is not the number of a vertex");
  expect_fault(kObj + "f 1 2 3.5\n", ":5: \"3.5\" is not the number of a vertex");
  expect_fault(kObj + "f 1 2 4 3\n", ":5: a face with 4 corners: only triangles can be read");
  expect_fault(kObj + "f 1 2\n", ":5: a face with 2 corners");
  expect_fault("v 0 0\n", ":1: z is missing");
  expect_fault("v 0 0 nan\n", ":1: z \"nan\" is NaN");
  expect_fault("v 0 0 1\n\nv 0 1e999 1\n", ":3: y \"1e999\" is too large for a double");
  expect_fault(kObj, ": has no faces: points alone are no mesh");
  expect_fault("hello\n", ": has no vertices: it is no mesh");
  expect_fault(std::string_view("v 0 0 1\nv\0 1 2 3\n", 16), ":2: NUL byte");
}

TEST_F(ReadObj, PolygonsAreNoMatterWhenOnlyPointsAreAskedFor) {
  const auto table = read_points(folder_.put("q.obj", kObj + "f 1 2 4 3\n"));
  ASSERT_TRUE(table);
  EXPECT_EQ(table->points, kFour);
}

struct Read2dm : MeshReading {
  Read2dm() : MeshReading("m.2dm") {}
};

const std::string kNodes = "MESH2D\nND 1 0 0 1\nND 2 1 0 2\nND 3 0 1 3.5\nND 4 1 1 -4\n";

TEST_F(Read2dm, NodesByIdInAnyOrder) {
  expect_pair(kNodes + "E3T 1 1 2 3 1\nE3T 2 2 4 3 1\n");
  expect_pair(
      "MESH2D\nMESHNAME \"a\"\nNUM_MATERIALS_PER_ELEM 1\nE3T 1 70 5 9 1\nE3T 2 5 0 9 1\nND 70 0 0 1\nND 5 1 "
      "0 2\n"
      "ND 9 0 1 3.5\nND 0 1 1 -4\nNS 70 5 -9\nBEGPARAMDEF\n");
}

TEST_F(Read2dm, FaultNamesTheLine) {
  expect_fault(kNodes + "E3T 1 1 2 3 1\nE3T 2 2 7 3 1\n", ":7: node 7 does not exist");
  expect_fault(kNodes + "E4Q 1 1 2 4 3 1\n", ":6: an element E4Q has more than 3 nodes");
  expect_fault(kNodes + "E3T 1 1 2\n", ":6: the id of a corner is missing");
  expect_fault(kNodes + "E3T 1 1 2 x 1\n", ":6: the id of a corner \"x\" is not a whole number");
  expect_fault(kNodes + "ND 2 5 5 5\nE3T 1 1 2 3 1\n", ":6: node 2 is there already");
  expect_fault(kNodes + "ND -2 5 5 5\n", ":6: the id of the node \"-2\" is out of range");
  expect_fault(kNodes + "ND 5 5 inf 5\n", ":6: y \"inf\" is infinite");
  expect_fault(kNodes + "ND 5 5 5\n", ":6: z is missing");
  expect_fault("ND 1 0 0 0\n", ":1: the first word of a 2DM file must be MESH2D");
  expect_fault(kNodes, ": has no faces");
}

TEST(ReadMesh, FilesOfPointsAreNoMesh) {
  const test::ScratchFolder folder;
  const std::string path = folder.put("p.csv", "x,y,z\n1,2,3\n");
  EXPECT_EQ(message_of(read_mesh(path), path),
            "p.csv: has points but no triangles: give a mesh (obj, ply, 2dm, tlw)");
}

}  // namespace
}  // namespace thalweg::io
