/// Arrays of NumPy: every type, order and version that it writes, and faults by name.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "io/mesh_file.hpp"
#include "io/point_table.hpp"
#include "io/write_mesh.hpp"
#include "support/allocation_watch.hpp"
#include "support/io_support.hpp"

namespace thalweg::io {
namespace {

using test::message_of;

const std::vector<Point3> kTwo = {{1, 2, 3}, {4, 60, 7}};

std::string header(const std::string& dict, char major = 1) {
  std::string out = std::string("\x93NUMPY") + major + '\0';
  const std::string text = dict + "   \n";
  out += static_cast<char>(text.size());
  out += std::string(major == 1 ? 1 : 3, '\0');
  return out + text;
}

std::string dict(const std::string& descr, const std::string& shape = "(2, 3)", bool fortran = false) {
  return "{'descr': '" + descr + "', 'fortran_order': " + (fortran ? "True" : "False") +
         ", 'shape': " + shape + ", }";
}

template <class T>
std::string bytes_of(const std::vector<double>& values, bool big = false) {
  std::string out;
  for (const double value : values) {
    const T typed = static_cast<T>(value);
    std::string bytes(reinterpret_cast<const char*>(&typed), sizeof(T));
    if (big) std::reverse(bytes.begin(), bytes.end());
    out += bytes;
  }
  return out;
}

const std::vector<double> kRows = {1, 2, 3, 4, 60, 7};
const std::vector<double> kColumns = {1, 4, 2, 60, 3, 7};

class Npy : public testing::Test {
 protected:
  Result<PointTable> read(const std::string& content, const ReadOptions& options = {}) {
    path_ = folder_.put("a.npy", content);
    return read_points(path_, options);
  }
  void expect_two(const std::string& content) {
    const auto table = read(content);
    ASSERT_TRUE(table) << message_of(table, path_);
    EXPECT_EQ(table->points, kTwo);
  }
  void expect_fault(const std::string& content, const std::string& what,
                    ErrorCode code = ErrorCode::malformed) {
    const auto table = read(content);
    ASSERT_FALSE(table) << what;
    EXPECT_EQ(table.error().code, code);
    const std::string message = message_of(table, path_);
    EXPECT_NE(message.find(what), std::string::npos) << message;
  }
  template <class T>
  void expect_type(const std::string& name) {
    for (const bool big : {false, true}) {
      const std::string descr = (sizeof(T) == 1 ? "|" : big ? ">" : "<") + name;
      expect_two(header(dict(descr)) + bytes_of<T>(kRows, big));
      expect_two(header(dict(descr, "(2, 3)", true)) + bytes_of<T>(kColumns, big));
    }
  }

  test::ScratchFolder folder_;
  std::string path_;
};

TEST_F(Npy, EveryTypeAndOrderIsRead) {
  expect_type<double>("f8");
  expect_type<float>("f4");
  expect_type<std::int8_t>("i1");
  expect_type<std::uint8_t>("u1");
  expect_type<std::int16_t>("i2");
  expect_type<std::uint16_t>("u2");
  expect_type<std::int32_t>("i4");
  expect_type<std::uint32_t>("u4");
  expect_type<std::int64_t>("i8");
  expect_type<std::uint64_t>("u8");
}

TEST_F(Npy, EveryVersionAndSpellingOfTheHeaderIsRead) {
  const std::string body = bytes_of<double>(kRows);
  for (const char version : {'\1', '\2', '\3'}) expect_two(header(dict("<f8"), version) + body);
  expect_two(header("{'shape': (2L, 3L), 'fortran_order': False, 'descr': '<f8'}") + body);
  expect_two(header("{\"descr\":\"<f8\",\"fortran_order\":False,\"shape\":(2,3,),}") + body);
}

TEST_F(Npy, ReadsBackBitForBit) {
  const std::vector<Point3> points = test::nasty_points();
  const std::string path = folder_ / "w.npy";
  auto file = OutputFile::open(path);
  ASSERT_FALSE(write_points(*file, points, Format::npy));
  ASSERT_FALSE(file->commit());
  EXPECT_EQ(test::content_of(path).size() % 64, 24 * points.size() % 64);
  test::reset_largest_allocation();
  const auto table = read_points(path);
  EXPECT_LE(test::largest_allocation(), std::max<std::size_t>(24 * points.size(), 1 << 18));
  ASSERT_TRUE(table);
  EXPECT_TRUE(test::same_bits(table->points, points));
}

TEST_F(Npy, TrianglesOfAMeshAreAnArrayOfNumbers) {
  const std::string path = folder_ / "t.npy";
  const std::vector<IndexTriangle> triangles = {{1, 2, 3}, {4, 60, 7}};
  auto file = OutputFile::open(path);
  ASSERT_FALSE(write_mesh(*file, {kTwo, triangles, {}, {}, {}}, Format::npy));
  ASSERT_FALSE(file->commit());
  const std::string content = test::content_of(path);
  const std::string text = "{'descr': '<u4', 'fortran_order': False, 'shape': (2, 3), }";
  EXPECT_EQ(content.substr(0, 10), std::string("\x93NUMPY\1\0\x76\0", 10));
  EXPECT_EQ(content.substr(10, 118), text + std::string(117 - text.size(), ' ') + "\n");
  expect_two(content);
}

TEST_F(Npy, WholeNumbersThatNoDoubleEqualsAreRefused) {
  const auto array = [](std::int64_t value, const std::string& descr) {
    std::string body(2 * 24, '\0');
    std::memcpy(body.data() + 32, &value, sizeof value);
    return header(dict(descr)) + body;
  };
  expect_fault(array((std::int64_t{1} << 53) + 1, "<i8"), "row 1 (from 0): y is beyond 2^53");
  expect_fault(array(std::numeric_limits<std::int64_t>::max(), "<i8"), "y is beyond 2^53");
  expect_fault(array(-1, "<u8"), "y is beyond 2^53");
  ASSERT_TRUE(read(array(std::numeric_limits<std::int64_t>::min(), "<i8")));
  ASSERT_TRUE(read(array(std::int64_t{1} << 53, "<u8")));
}

TEST_F(Npy, NanIsRefusedUnlessItIsNoData) {
  std::vector<double> values = kRows;
  values[5] = std::numeric_limits<double>::quiet_NaN();
  for (const std::string& content : {header(dict("<f8")) + bytes_of<double>(values),
                                     header(dict(">f4")) + bytes_of<float>(values, true)}) {
    expect_fault(content, "row 1 (from 0): z is NaN: correct or remove it");
    const auto table = read(content, {.nodata = values[5]});
    ASSERT_TRUE(table);
    EXPECT_EQ(table->points.size(), 1u);
    EXPECT_EQ(table->skipped_nodata, 1u);
  }
  values[5] = std::numeric_limits<double>::infinity();
  expect_fault(header(dict("<f8")) + bytes_of<double>(values), "row 1 (from 0): z is infinite");
}

TEST_F(Npy, BadHeadersAreNamed) {
  const std::string body = bytes_of<double>(kRows);
  expect_fault("1 2 3\n", "is no array of NumPy");
  expect_fault(std::string("\x93NUMPY\4\0\6\0{}   \n", 16), "is version 4.0 of .npy");
  expect_fault(header(dict("<f8")).substr(0, 40), "the file ends in its header");
  expect_fault(std::string("\x93NUMPY\2\0\xff\xff\xff\x7f", 12) + body, "has a header of 2147483647 bytes");
  expect_fault(header("{'descr': '<f8', 'fortran_order': False}") + body,
               "has a header that NumPy does not write");
  expect_fault(header("hello") + body, "has a header that NumPy does not write");
  expect_fault(
      header("{'descr': [('x', '<f8'), ('y', '<f8')], 'fortran_order': False, 'shape': (2,), }") + body,
      "holds rows of named fields");
  for (const char* descr : {"|O", "<c16", "<f2", "|b1", "|i4", "<U8", "f8"})
    expect_fault(header(dict(descr)) + body, "holds values of type \"" + std::string(descr) + "\"");
  expect_fault(header(dict("<f8", "(3, 2)")) + body,
               "is an array of shape (3, 2): points are of shape (n, 3)");
  expect_fault(header(dict("<f8", "(6,)")) + body, "is an array of shape (6)");
  expect_fault(header(dict("<f8", "()")) + body, "is an array of shape ()");
  expect_fault(header(dict("<f8", "(0, 3)")), "has no points");
  expect_fault(header(dict("<f8", "(3, 3)")) + body, "it is cut short or damaged");
  expect_fault(header(dict("<f8", "(1, 3)")) + body, "holds more than one array");
  expect_fault(header(dict("<f8", "(536870912, 3)")) + body, "32-bit ids allow 536870911",
               ErrorCode::too_many_points);
  expect_fault(header(dict("<f8", "(99999999999999999999, 3)")) + body,
               "has a header that NumPy does not write");
}

TEST_F(Npy, IsNoMeshAndToldByItsContent) {
  const std::string content = header(dict("<f8")) + bytes_of<double>(kRows);
  const std::string path = folder_.put("a.npy", content);
  EXPECT_NE(message_of(read_mesh(path), path).find("has points but no triangles"), std::string::npos);
  const std::string other = folder_.put("a.xyz", content);
  EXPECT_EQ(message_of(read_points(other), other), "a.xyz: a NumPy array: say --from npy");
}

}  // namespace
}  // namespace thalweg::io
