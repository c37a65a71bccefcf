#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>
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

std::string header(std::string_view format, std::string_view real = "double",
                   std::string_view index = "int") {
  return "ply\nformat " + std::string(format) + " 1.0\ncomment crs: EPSG:28992\nelement vertex 4\nproperty " +
         std::string(real) + " x\nproperty " + std::string(real) + " y\nproperty " + std::string(real) +
         " z\nelement face 2\nproperty list uchar " + std::string(index) + " vertex_indices\nend_header\n";
}

/// The bytes of a value in the given order.
template <class T>
std::string raw(T value, bool big) {
  std::string out(sizeof(T), '\0');
  std::memcpy(out.data(), &value, sizeof(T));
  if (big) std::reverse(out.begin(), out.end());
  return out;
}

template <class Real, class Index>
std::string body(bool big) {
  std::string out;
  for (const Point3& p : kFour) {
    for (const double v : {p.x, p.y, p.z}) out += raw(static_cast<Real>(v), big);
  }
  for (const IndexTriangle& t : kPair) {
    out += '\3';
    for (const std::uint32_t v : t) out += raw(static_cast<Index>(v), big);
  }
  return out;
}

const std::string kAsciiBody = "0 0 1\n1 0 2\n0 1 3.5\n1 1 -4\n3 0 1 2\n3 1 3 2\n";

class ReadPly : public testing::Test {
 protected:
  Result<MeshFile> read(std::string_view content) {
    path_ = folder_.put("m.ply", content);
    return read_mesh(path_);
  }
  void expect_pair(std::string_view content) {
    const auto mesh = read(content);
    ASSERT_TRUE(mesh) << mesh.error().message;
    EXPECT_EQ(mesh->points, kFour);
    EXPECT_EQ(mesh->triangles, kPair);
  }
  void expect_fault(std::string_view content, const std::string& what) {
    const std::string message = message_of(read(content), path_);
    EXPECT_TRUE(message.starts_with("m.ply" + what)) << message << "\nshould start with m.ply" << what;
  }
  test::ScratchFolder folder_;
  std::string path_;
};

TEST_F(ReadPly, EveryEncodingAndType) {
  expect_pair(header("ascii") + kAsciiBody);
  for (const bool big : {false, true}) {
    const char* format = big ? "binary_big_endian" : "binary_little_endian";
    expect_pair(header(format) + body<double, std::int32_t>(big));
    expect_pair(header(format, "float", "uint") + body<float, std::uint32_t>(big));
    expect_pair(header(format, "float32", "uint16") + body<float, std::uint16_t>(big));
    expect_pair(header(format, "float64", "char") + body<double, std::int8_t>(big));
  }
}

TEST_F(ReadPly, CrsCommentIsKept) {
  EXPECT_EQ(read(header("ascii") + kAsciiBody)->crs, "EPSG:28992");
  EXPECT_EQ(read_points(path_)->crs, "EPSG:28992");
}

TEST_F(ReadPly, OtherElementsAndPropertiesAreSkipped) {
  const std::string head =
      "ply\r\nformat ascii 1.0\r\nobj_info made by hand\r\nelement camera 1\r\nproperty list uchar float "
      "p\r\n"
      "property int n\r\nelement vertex 4\r\nproperty uchar red\r\nproperty float Z\r\nproperty double X\r\n"
      "property list uchar int friends\r\nproperty double Y\r\nelement empty 900000000000\r\nelement face "
      "2\r\n"
      "property int order\r\nproperty list uint8 int32 vertex_index\r\nproperty uchar flag\r\nend_header\r\n";
  expect_pair(head +
              "2 0.5 0.5 7\r\n9 1 0 0 0\r\n9 2 1 2 5 6 0\r\n\r\n9 3.5 0 1 5 1\r\n9 -4 1 0 1\r\n5 3 0 1 2 "
              "0\r\n5 3 1 3 2 1\r\n");
  std::string binary = head;
  binary.replace(binary.find("ascii"), 5, "binary_big_endian");
  binary += '\2' + raw(0.5f, true) + raw(0.5f, true) + raw(7, true);
  for (const Point3& p : kFour) {
    binary +=
        '\x09' + raw(static_cast<float>(p.z), true) + raw(p.x, true) + '\1' + raw(5, true) + raw(p.y, true);
  }
  for (const IndexTriangle& t : kPair) {
    binary += raw(5, true) + '\3';
    for (const std::uint32_t v : t) binary += raw(v, true);
    binary += '\1';
  }
  expect_pair(binary);
}

TEST_F(ReadPly, FacesMayComeFirst) {
  expect_pair(
      "ply\nformat ascii 1.0\nelement face 2\nproperty list uchar int vertex_indices\nelement vertex 4\n"
      "property double x\nproperty double y\nproperty double z\nend_header\n3 0 1 2\n3 1 3 2\n0 0 1\n1 0 2\n"
      "0 1 3.5\n1 1 -4\n");
}

TEST_F(ReadPly, PointCloudHasPointsButIsNoMesh) {
  const std::string cloud =
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float "
      "z\nend_header\n1 2 3\n";
  expect_fault(cloud, ": the header has no element face with a list vertex_indices");
  const auto table = read_points(path_);
  ASSERT_TRUE(table);
  EXPECT_EQ(table->points, (std::vector<Point3>{{1, 2, 3}}));
}

TEST_F(ReadPly, AsciiFaultNamesTheLine) {
  const std::string head = header("ascii");  // 10 lines
  expect_fault(head + "0 0 1\n1 0 x\n0 1 3.5\n1 1 -4\n3 0 1 2\n3 1 3 2\n", ":12: z \"x\" is not a number");
  expect_fault(head + "0 0 1\n1 0\n0 1 3.5\n1 1 -4\n3 0 1 2\n3 1 3 2\n", ":12: z is missing");
  expect_fault(head + "0 0 1\n1 0 2\n0 nan 3.5\n1 1 -4\n3 0 1 2\n3 1 3 2\n", ":13: y \"nan\" is NaN");
  expect_fault(head + "0 0 1\n1 0 2 9\n0 1 3.5\n1 1 -4\n3 0 1 2\n3 1 3 2\n", ":12: more values on the line");
  expect_fault(head + "0 0 1\n1 0 2\n0 1 3.5\n1 1 -4\n3 0 1 2\n3 1 4 2\n",
               ":16: vertex 4 does not exist: there are 4");
  expect_fault(head + "0 0 1\n1 0 2\n0 1 3.5\n1 1 -4\n3 0 1 2\n3 1 -1 2\n", ":16: vertex -1 does not exist");
  expect_fault(head + "0 0 1\n1 0 2\n0 1 3.5\n1 1 -4\n4 0 1 3 2\n3 1 3 2\n", ":15: a face with 4 corners");
  expect_fault(head + "0 0 1\n1 0 2\n0 1 3.500000000000000\n1 1 -4\n3 0 1 2\n",
               ":15: the file ends before face 1");
  expect_fault(head + kAsciiBody + "1 2 3\n", ":17: more lines than the header promises");
  expect_fault(head + "0 0 1\n", ": the header promises 4 elements \"vertex\"");
}

TEST_F(ReadPly, BinaryFaultNamesTheElement) {
  const std::string head = header("binary_little_endian");
  const std::string good = body<double, std::int32_t>(false);
  expect_fault(head + good.substr(0, good.size() - 1),
               ": face 1 (from 0): the file ends here: it is cut short");
  expect_fault(head + good.substr(0, 50),
               ": the header promises 4 elements \"vertex\", but the file is too short");
  expect_fault(head + good + "tail", ": 4 bytes more than the header promises");
  std::string nan = good;
  nan.replace(24 + 8, 8, raw(std::numeric_limits<double>::quiet_NaN(), false));
  expect_fault(head + nan, ": vertex 1 (from 0): y is NaN");
  nan.replace(24 + 8, 8, raw(std::numeric_limits<double>::infinity(), false));
  expect_fault(head + nan, ": vertex 1 (from 0): y is infinite");
  std::string corner = good;
  corner.replace(4 * 24 + 1, 4, raw(4, false));
  expect_fault(head + corner, ": face 0 (from 0): vertex 4 does not exist: there are 4, numbered from 0");
  std::string square = good;
  square[4 * 24] = '\4';
  expect_fault(head + square, ": face 0 (from 0): a face with 4 corners: only triangles can be read");
}

TEST_F(ReadPly, HeaderFaultNamesTheLine) {
  expect_fault("plyx\n", ":1: the first line of a PLY file must be `ply`");
  expect_fault("ply\nformat xml 1.0\n", ":2: \"xml\" is no format of PLY");
  expect_fault("ply\nformat ascii 2.0\n", ":2: version \"2.0\" of PLY is not known");
  expect_fault("ply\nformat ascii 1.0\nelement vertex many\n",
               ":3: the count of the element \"many\" is not a whole number");
  expect_fault("ply\nformat ascii 1.0\nelement vertex -1\n",
               ":3: the count of the element \"-1\" is out of range");
  expect_fault("ply\nformat ascii 1.0\nproperty float x\n", ":3: a property before the first element");
  expect_fault("ply\nformat ascii 1.0\nelement vertex 1\nproperty quad x\n",
               ":4: \"quad\" is no type of PLY");
  expect_fault("ply\nformat ascii 1.0\nelement vertex 1\nproperty list float int x\n",
               ":4: the length of a list");
  expect_fault("ply\nformat ascii 1.0\nelement ver\x1btex 1\n", ":3: an element called \"ver\\x1btex\"");
  expect_fault("ply\nformat ascii 1.0\nelement vertex 1\nproperty int\n", ":4: a property called \"\"");
  expect_fault("ply\nformat ascii 1.0\nwhat\n", ":3: \"what\" is no keyword of a PLY header");
  expect_fault("ply\nformat ascii 1.0\nelement vertex 1\n", ":3: the file ends in its header");
  expect_fault("ply\nelement vertex 0\nend_header\n", ":3: the header has no format");
  expect_fault("ply\nformat ascii 1.0\nelement vertex 1\nelement vertex 1\n",
               ":4: a second element \"vertex\"");
  expect_fault("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n",
               ": vertices need properties");
}

TEST_F(ReadPly, AbsurdCountsTakeNoMemory) {
  for (const char* format : {"ascii", "binary_little_endian"}) {
    for (const char* count : {"4000000000", "9223372036854775807"}) {
      std::string many = header(format);
      many.replace(many.find("face 2") + 5, 1, count);
      expect_fault(many + kAsciiBody + std::string(200, ' '), ": the header promises " + std::string(count));
      many = header(format);
      many.replace(many.find("vertex 4") + 7, 1, count);
      EXPECT_FALSE(read(many + kAsciiBody));
    }
  }
  std::string list = header("binary_little_endian");
  list.replace(list.find("list uchar"), 10, "list int");
  expect_fault(list + body<double, std::int32_t>(false).substr(0, 96) + raw(-1, false) + std::string(40, 'x'),
               ": face 0 (from 0): a face with -1 corners");
}

}  // namespace
}  // namespace thalweg::io
