#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "io/grid.hpp"
#include "io/point_table.hpp"
#include "support/io_support.hpp"

namespace thalweg::io {
namespace {

using test::message_of;

const std::string kHead = "ncols 3\nnrows 2\nxllcorner 100\nyllcorner 200\ncellsize 10\n";

class ReadGrid : public testing::Test {
 protected:
  Result<Grid> read(std::string_view content, const ReadOptions& options = {}) {
    path_ = folder_.put("g.asc", content);
    return read_grid(path_, options);
  }
  void expect_fault(std::string_view content, std::string_view start) {
    const std::string message = message_of(read(content), path_);
    EXPECT_TRUE(message.starts_with(start)) << message << "\nshould start with " << start;
  }
  test::ScratchFolder folder_;
  std::string path_;
};

TEST_F(ReadGrid, CellsAreWhereTheirCentresAre) {
  const auto grid = read(kHead + "NODATA_value -1\n1 2 3\n4 -1 6\n");
  ASSERT_TRUE(grid) << grid.error().message;
  EXPECT_EQ(grid->columns, 3u);
  EXPECT_EQ(grid->rows, 2u);
  EXPECT_EQ(grid->x, (std::vector<double>{105, 115, 125}));
  EXPECT_EQ(grid->y, (std::vector<double>{215, 205}));
  EXPECT_EQ(grid->values, (std::vector<double>{1, 2, 3, 4, -1, 6}));
  EXPECT_TRUE(grid->is_nodata(grid->value(1, 1)));
  const auto table = read_points(path_);
  ASSERT_TRUE(table);
  EXPECT_EQ(table->points,
            (std::vector<Point3>{{105, 215, 1}, {115, 215, 2}, {125, 215, 3}, {105, 205, 4}, {125, 205, 6}}));
  EXPECT_EQ(table->skipped_nodata, 1u);
}

TEST_F(ReadGrid, KeysInAnyCaseAndOrderAndBothKindsOfOrigin) {
  const auto grid = read(
      "NROWS 1\r\nNCOLS 2\r\nDX 2\r\nDY 4\r\nyllCenter 8\r\nXLLCENTER 1\r\nnodata_value -9999\r\n5\r\n6\r\n");
  ASSERT_TRUE(grid) << grid.error().message;
  EXPECT_EQ(grid->x, (std::vector<double>{1, 3}));
  EXPECT_EQ(grid->y, (std::vector<double>{8}));
  EXPECT_EQ(grid->values, (std::vector<double>{5, 6}));
}

TEST_F(ReadGrid, NodataIsTheDefaultTheHeaderOrTheOption) {
  EXPECT_EQ(read(kHead + "1 2 3 4 5 6")->nodata, -9999);
  EXPECT_EQ(read(kHead + "1 2 3 4 5 6", {.nodata = 4})->nodata, 4);
  ASSERT_TRUE(read(kHead + "NODATA_value nan\n1 2 nan\n4 5 NaN\n"));
  const auto table = read_points(path_);
  ASSERT_TRUE(table);
  EXPECT_EQ(table->points.size(), 4u);
  EXPECT_EQ(table->skipped_nodata, 2u);
}

TEST_F(ReadGrid, ValueThatIsNoneIsNamed) {
  expect_fault(kHead + "1 2 3\n4 x 6\n", "g.asc:7: the value of row 2, column 2 \"x\" is not a number");
  expect_fault(kHead + "1 nan 3\n4 5 6\n", "g.asc:6: the value of row 1, column 2 \"nan\" is NaN");
  expect_fault(kHead + "1 2 3\n4 5 inf\n", "g.asc:7: the value of row 2, column 3 \"inf\" is infinite");
  expect_fault(kHead + "1 2 3\n4 5 1e999\n", "g.asc:7: the value of row 2, column 3 \"1e999\" is too large");
  expect_fault(kHead + "1,5 2 3\n4 5 6\n", "g.asc:6: \"1,5\" is no header");
  expect_fault(kHead + "1 2,5 3\n4 5 6\n",
               "g.asc:6: the value of row 1, column 2 \"2,5\" has a decimal comma");
}

TEST_F(ReadGrid, TooFewAndTooManyValuesAreRefused) {
  expect_fault(kHead + "1 2 3\n4 5\n",
               "g.asc:7: the file ends after 5 of the 6 values that 3 columns times 2 rows need");
  expect_fault(kHead + "1 2 3\n4 5 6\n7\n", "g.asc:8: more values than the 6 of 3 columns times 2 rows");
  expect_fault(kHead, "g.asc:5: the file ends after 0 of the 6 values");
}

TEST_F(ReadGrid, HeaderThatMakesNoGridIsRefused) {
  expect_fault("nrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2\n", "g.asc:5: the header has no ncols");
  expect_fault("ncols 2\nnrows 2\nyllcorner 0\ncellsize 1\n1 2\n",
               "g.asc:5: the header has no xllcorner or xllcenter");
  expect_fault("ncols 2\nnrows 1\nxllcorner 0\nyllcorner 0\n1 2\n", "g.asc:5: the header has no cellsize");
  expect_fault("ncols 0\nnrows 1\n", "g.asc:1: ncols \"0\" is out of range");
  expect_fault("ncols -3\nnrows 1\n", "g.asc:1: ncols \"-3\" is out of range");
  expect_fault("ncols 2.5\nnrows 1\n", "g.asc:1: ncols \"2.5\" is not a whole number");
  expect_fault("ncols\nnrows 1\n", "g.asc:1: ncols is missing");
  expect_fault("ncols 99999999999999999999\n", "g.asc:1: ncols \"99999999999999999999\" is out of range");
  expect_fault("ncols 2\nnrows 1\nxllcorner here\n", "g.asc:3: xllcorner \"here\" is not a number");
  expect_fault("ncols 2\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 0\n1 2\n", "g.asc: the size of a cell");
  expect_fault("ncols 2\nnrows 1\nxllcorner 1e300\nyllcorner 0\ncellsize 1\n1 2\n",
               "g.asc: the centres of the cells");
  expect_fault("DSAA\n2 2\n", "g.asc:1: \"DSAA\" is no header of an ESRI ASCII grid");
  expect_fault("1 2\n3 4\n", "g.asc:1: the header has no ncols");
}

TEST_F(ReadGrid, AbsurdSizeTakesNoMemory) {
  expect_fault("ncols 2000000000\nnrows 2000000000\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2 3\n",
               "g.asc:6: the file ends after 3 of the 4000000000000000000 values");
}

TEST_F(ReadGrid, OtherFormatsAreNoGrid) {
  const std::string path = folder_.put("p.xyz", "1 2 3\n");
  EXPECT_EQ(message_of(read_grid(path), path),
            "p.xyz: is no grid: give an ESRI ASCII grid (.asc), or say --from asc");
}

}  // namespace
}  // namespace thalweg::io
