/// The binary format of thalweg: what is written reads back bit for bit, and nothing else is taken for it.
#include <gtest/gtest.h>

#include <sys/stat.h>

#include <fstream>
#include <limits>
#include <string>
#include <thread>
#include <vector>

#include "io/mesh_file.hpp"
#include "io/point_table.hpp"
#include "io/readers.hpp"
#include "io/write_mesh.hpp"
#include "kernel/divide_and_conquer.hpp"
#include "support/allocation_watch.hpp"
#include "support/io_support.hpp"

namespace thalweg::io {
namespace {

using test::message_of;

const std::vector<Point3> kPoints = {{0, 0, 1}, {1, 0, -0.0}, {0, 1, 5e-324}, {1e308, 1, -4}};
const std::vector<IndexTriangle> kTriangles = {{0, 1, 2}, {1, 3, 2}};

class Tlw : public testing::Test {
 protected:
  std::string written(const MeshView& mesh) {
    const std::string path = folder_ / "written.tlw";
    auto file = OutputFile::open(path, {.overwrite = true});
    EXPECT_FALSE(write_mesh(*file, mesh, Format::tlw));
    EXPECT_FALSE(file->commit());
    return test::content_of(path);
  }
  std::string good() { return written({kPoints, kTriangles, {}, {}, "EPSG:2056"}); }

  void expect_fault(const std::string& content, const std::string& what,
                    ErrorCode code = ErrorCode::malformed) {
    const std::string path = folder_.put("m.tlw", content);
    const auto mesh = read_mesh(path);
    ASSERT_FALSE(mesh) << what;
    EXPECT_EQ(mesh.error().code, code);
    const std::string message = message_of(mesh, path);
    EXPECT_NE(message.find(what), std::string::npos) << message;
    EXPECT_TRUE(message.starts_with("m.tlw: ")) << message;
  }

  test::ScratchFolder folder_;
};

TEST_F(Tlw, IsWrittenByteByByteAsDocumented) {
  const std::string content = written({std::span(kPoints).first(1), {}, {}, {}, "EPSG:2056"});
  std::string expected("\x89TLW\r\n\x1a\n\1\0\0\0\4\3\2\1\1\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x09\0\0\0\0\0\0\0",
                       40);
  expected += std::string("EPSG:2056\0\0\0\0\0\0\0", 16);
  expected += std::string(16, '\0') + std::string("\0\0\0\0\0\0\xf0\x3f", 8);
  EXPECT_EQ(content, expected);
  EXPECT_EQ(good().size(), 40u + 16 + 4 * 24 + 2 * 12);
}

TEST_F(Tlw, ReadsBackBitForBit) {
  const std::vector<Point3> points = test::nasty_points();
  const std::vector<IndexTriangle> triangles = {{0, 1, 2},
                                                {5, 4, static_cast<std::uint32_t>(points.size() - 1)}};
  const std::string path = folder_.put("m.tlw", written({points, triangles, {}, {}, "EPSG:2056"}));
  const auto mesh = read_mesh(path);
  ASSERT_TRUE(mesh) << message_of(mesh, path);
  EXPECT_TRUE(test::same_bits(mesh->points, points));
  EXPECT_EQ(mesh->triangles, triangles);
  EXPECT_EQ(mesh->crs, "EPSG:2056");
  const auto table = read_points(path);
  ASSERT_TRUE(table);
  EXPECT_TRUE(test::same_bits(table->points, points));
  EXPECT_EQ(table->crs, "EPSG:2056");
}

TEST_F(Tlw, OfManyBlocksAndFromAPipe) {
  std::vector<Point3> points;
  std::vector<IndexTriangle> triangles;
  for (std::uint32_t i = 0; i < 100000; ++i) {
    points.push_back({i * 0.1, i * 0.7, i % 17 * 1.0});
    triangles.push_back({i, (i + 1) % 100000, (i * 7) % 100000});
  }
  const std::string content = written({points, triangles, {}, {}, {}});
  const std::string path = folder_ / "fifo.tlw";
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  const auto through_pipe = [&](const std::string& bytes, auto&& read) {
    std::thread writer([&] { std::ofstream(path, std::ios::binary) << bytes; });
    auto result = read();
    writer.join();
    return result;
  };
  const auto mesh = through_pipe(content, [&] { return read_mesh(path); });
  ASSERT_TRUE(mesh) << message_of(mesh, path);
  EXPECT_EQ(mesh->points, points);
  EXPECT_EQ(mesh->triangles, triangles);
  const auto table = through_pipe(content, [&] { return read_points(path); });
  ASSERT_TRUE(table) << message_of(table, path);
  EXPECT_EQ(table->points, points);
  const auto cut = through_pipe(content.substr(0, 40 + 24 * 70000 + 5), [&] { return read_points(path); });
  EXPECT_EQ(message_of(cut, path), "fifo.tlw: point 70000 (from 0): the file ends here: it is cut short");
  const auto longer = through_pipe(content + "x", [&] { return read_points(path); });
  EXPECT_NE(message_of(longer, path).find("something was appended"), std::string::npos);
}

TEST_F(Tlw, TakesNoMemoryBesideThePoints) {
  const std::vector<Point3> points(200000, Point3{1, 2, 3});
  const std::string path = folder_.put("m.tlw", written({points, {}, {}, {}, {}}));
  test::reset_largest_allocation();
  const auto table = read_points(path);
  ASSERT_TRUE(table);
  EXPECT_EQ(test::largest_allocation(), 24 * points.size());
}

TEST_F(Tlw, FaultsAreNamed) {
  const std::string content = good();
  const auto changed = [&](std::size_t at, const std::string& bytes) {
    std::string out = content;
    return out.replace(at, bytes.size(), bytes);
  };
  const auto number = [](std::uint64_t value) {
    return std::string(reinterpret_cast<const char*>(&value), sizeof value);
  };
  expect_fault("1 2 3\n", "is no thalweg file (.tlw)");
  expect_fault(changed(4, "\n\x1a\n\0"), "was changed as if it were text");
  expect_fault(content.substr(0, 30), "the file ends in its header");
  expect_fault(changed(8, "\2"), "is version 2 of .tlw, and this thalweg reads version 1");
  expect_fault(changed(12, "\1\2\3\4"), "is big endian");
  expect_fault(changed(12, "\7"), "has a damaged header");
  expect_fault(changed(36, "\1"), "has a damaged header");
  expect_fault(changed(40, "\x1b"), "the name of the coordinate system is no line of text");
  expect_fault(content.substr(0, content.size() - 1),
               "take 176 bytes, but the file has 175: it is cut short");
  expect_fault(content + "x", "but the file has 177: it is damaged, or something was appended");
  expect_fault(changed(16, number(5)), "the header promises 5 points and 2 triangles, which take 200 bytes");
  expect_fault(changed(16, number(536870912)), "536870912 points or more, and 32-bit ids allow 536870911",
               ErrorCode::too_many_points);
  expect_fault(changed(16, number(~std::uint64_t{0})), "points or more", ErrorCode::too_many_points);
  expect_fault(changed(24, number(~std::uint64_t{0} / 12)), "split the mesh", ErrorCode::too_many_points);
  expect_fault(changed(content.size() - 4, "\4"),
               "triangle 1 (from 0): point 4 does not exist: there are 4, numbered from 0");
  std::vector<Point3> points = kPoints;
  points[2].y = std::numeric_limits<double>::quiet_NaN();
  expect_fault(written({points, kTriangles, {}, {}, {}}), "point 2 (from 0): y is NaN: correct or remove it");
  points[2].y = -std::numeric_limits<double>::infinity();
  expect_fault(written({points, kTriangles, {}, {}, {}}), "point 2 (from 0): y is infinite");
  expect_fault(written({kPoints, {}, {}, {}, {}}), "has no faces");
}

TEST_F(Tlw, IsToldByItsContentWhereTheNameSaysOtherwise) {
  const std::string path = folder_.put("m.xyz", good());
  EXPECT_EQ(message_of(read_points(path), path), "m.xyz: a .tlw file: say --from tlw");
  EXPECT_TRUE(read_points(path, {.format = "tlw"}));
}

TEST_F(Tlw, LimitIsThatOfTheKernel) {
  EXPECT_EQ(kMostPoints, detail::kMaxSites);
}

TEST_F(Tlw, NodataIsSkipped) {
  const std::string path = folder_.put("m.tlw", good());
  const auto table = read_points(path, {.nodata = 1});
  ASSERT_TRUE(table);
  EXPECT_EQ(table->skipped_nodata, 1u);
  EXPECT_EQ(table->points.size(), 3u);
}

}  // namespace
}  // namespace thalweg::io
