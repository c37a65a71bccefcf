#include <gtest/gtest.h>

#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>
#include <thread>
#include <vector>

#include "io/format.hpp"
#include "io/point_table.hpp"
#include "support/io_support.hpp"

namespace thalweg::io {
namespace {

using test::message_of;
using test::ScratchFolder;

const std::vector<Point3> kTwo = {{1, 2, 3}, {4.5, -6, 7e2}};

class ReadXyz : public testing::Test {
 protected:
  Result<PointTable> read(std::string_view content, const ReadOptions& options = {}) {
    path_ = folder_.put("p.xyz", content);
    return read_points(path_, options);
  }
  std::vector<Point3> points(std::string_view content, const ReadOptions& options = {}) {
    const auto table = read(content, options);
    EXPECT_TRUE(table) << message_of(table, path_);
    return table ? table->points : std::vector<Point3>{};
  }
  std::string fault(std::string_view content, const ReadOptions& options = {}) {
    return message_of(read(content, options), path_);
  }
  void expect_fault(std::string_view content, std::string_view start, const ReadOptions& options = {}) {
    const std::string message = fault(content, options);
    EXPECT_TRUE(message.starts_with(start)) << message << "\nshould start with " << start;
  }

  ScratchFolder folder_;
  std::string path_;
};

TEST_F(ReadXyz, EveryDelimiterIsFound) {
  for (const char* text :
       {"1 2 3\n4.5 -6 7e2\n", "1,2,3\n4.5,-6,7e2\n", "1;2;3\n4.5;-6;7e2\n", "1\t2\t3\n4.5\t-6\t7e2\n",
        "  1   2  3  \n\t4.5 \t -6   7e2\n", "1, 2, 3\n4.5 ,-6 , 7e2\n", "1 \t2 \t3\n4.5\t -6\t7e2\n"}) {
    EXPECT_EQ(points(text), kTwo) << text;
  }
}

TEST_F(ReadXyz, EveryOddityOfTextFilesIsAccepted) {
  for (const char* text :
       {"1 2 3\r\n4.5 -6 7e2\r\n",  // CRLF
        "\xef\xbb\xbf"
        "1 2 3\n4.5 -6 7e2\n",  // byte order mark
        "1 2 3\n4.5 -6 7e2",    // no last line end
        "# hello\n\n1 2 3\n\n  # 9 9 9\n// x\n4.5 -6 7e2\n\n",
        "1,2,3,\n4.5,-6,7e2,\n",                  // delimiter at the end
        "1,2,3\n,,\n4.5,-6,7e2\n,,,\n",           // what spreadsheets leave
        "\"1\",\"2\",\" 3 \"\n4.5,\"-6\",7e2\n",  // quotes
        "+1 +2 +3\n4.5 -6 +7E+2\n", "1 2 3 # good\n4.5 -6 7e2 # bad\n", "1,2,3 # good\n4.5,-6,7e2 # bad\n",
        "1 2 3 9 9 label\n4.5 -6 7e2 8 8 x\n",  // more columns
        "1,2,3,\"a, b\"\n4.5,-6,7e2,c;d;e;f\n"}) {
    EXPECT_EQ(points(text), kTwo) << text;
  }
}

TEST_F(ReadXyz, HeaderSaysWhichColumnsInAnyOrder) {
  for (const char* text :
       {"x,y,z\n1,2,3\n4.5,-6,7e2\n", "X Y Z\n1 2 3\n4.5 -6 7e2\n", "y,z,x\n2,3,1\n-6,7e2,4.5\n",
        "id;Easting;Northing;Elevation\na;1;2;3\nb;4.5;-6;7e2\n",
        "\"lat\",\"lon\",\"height\"\n2,1,3\n-6,4.5,7e2\n",
        "Point ID,X [m],Y [m],Z [m]\nP1,1,2,3\nP2,4.5,-6,7e2\n", "# y x z\n2 1 3\n-6 4.5 7e2\n",
        "//X,Y,Z\n1 2 3\n4.5 -6 7e2\n", "lon,lat,x,y,h\n9,9,1,2,3\n8,8,4.5,-6,7e2\n",
        "x,y,z\n1 2 3\n4.5 -6 7e2\n", "x\ty\televation\tnote\n1\t2\t3\t\n4.5\t-6\t7e2\tok\n",
        "#points\n#x\ty\tz\n1\t2\t3\n4.5\t-6\t7e2\n"}) {
    EXPECT_EQ(points(text), kTwo) << text;
  }
}

TEST_F(ReadXyz, ColumnsOptionTakesNamesAndNumbers) {
  EXPECT_EQ(points("a b c d\n9 1 2 3\n9 4.5 -6 7e2\n", {.columns = "b,c,d"}), kTwo);
  EXPECT_EQ(points("a b c d\n9 1 2 3\n9 4.5 -6 7e2\n", {.columns = "2,3,4"}), kTwo);
  EXPECT_EQ(points("9 3 2 1\n9 7e2 -6 4.5\n", {.columns = "4,3,2"}), kTwo);
  EXPECT_EQ(points("x,y,z,depth\n1,2,0,3\n4.5,-6,0,7e2\n", {.columns = "X, y ,depth"}), kTwo);
  EXPECT_EQ(points("P1 1 2 3\n# 9 9 9 9\nP2 4.5 -6 7e2\n", {.columns = "2,3,4"}), kTwo);
  EXPECT_EQ(points("\"x\" \"y\" \"z\"\n\"1\" 1 2 3\n\"2\" 4.5 -6 7e2\n", {.columns = "2,3,4"}), kTwo);
}

TEST_F(ReadXyz, ColumnsOptionThatMakesNoSenseIsRefused) {
  for (const char* columns : {"1,2", "1,2,3,4", "1,1,2", "0,1,2", "a,,c", "x,y,X", "1,2,99999999999"}) {
    const auto table = read("x y z\n1 2 3\n", {.columns = columns});
    ASSERT_FALSE(table) << columns;
    EXPECT_EQ(table.error().code, ErrorCode::invalid_argument) << columns;
  }
  expect_fault("x y z\n1 2 3\n", "p.xyz:1: no column is called \"h\": there are \"x\", \"y\", \"z\"",
               {.columns = "x,y,h"});
  expect_fault("1 2 3\n", "p.xyz:1: no header", {.columns = "x,y,z"});
  expect_fault("1 2 3\n", "p.xyz:1: column 7 (z) is missing: there are only 3 columns here",
               {.columns = "1,2,7"});
}

TEST_F(ReadXyz, HeaderThatLeavesDoubtIsRefused) {
  expect_fault("x,y,depth\n1,2,3\n",
               "p.xyz:1: no column for z in the header (\"x\", \"y\", \"depth\"): say which");
  expect_fault("\n# c\nx,y,z,X\n1,2,3,4\n", "p.xyz:3: two columns could be x");
  expect_fault("x y z\n\"1\" 1 2 3\n", "p.xyz:2: one column more than the header names");
  expect_fault("hello world\n", "p.xyz:1: no column for x in the header");
}

TEST_F(ReadXyz, FaultNamesLineColumnAndToken) {
  expect_fault("1 2 3\n4 5 n/a\n", "p.xyz:2: column 3 (z) \"n/a\" is not a number");
  expect_fault("# c\n\n1,2,3\r\n\r\n4,oops,6\r\n", "p.xyz:5: column 2 (y) \"oops\" is not a number");
  expect_fault("x,y,z\n1,2,3\n4,5,\n", "p.xyz:3: column 3 (z) has no value");
  expect_fault("1,2,3\n4,5\n", "p.xyz:2: column 3 (z) is missing: there are only 2 columns here");
  expect_fault("1 2 3\n4\n", "p.xyz:2: column 2 (y) is missing: there is only 1 column here");
  expect_fault("1 2\n3 4\n", "p.xyz:1: column 3 (z) is missing");
  expect_fault("1 2 3\n4 nan 6\n", "p.xyz:2: column 2 (y) \"nan\" is NaN");
  expect_fault("1 2 3\n-inf 5 6\n", "p.xyz:2: column 1 (x) \"-inf\" is infinite");
  expect_fault("1 2 3\n4 5 1e999\n", "p.xyz:2: column 3 (z) \"1e999\" is too large for a double");
  expect_fault("y x z\n1 2 3\n4 bad 6\n", "p.xyz:3: column 2 (x) \"bad\"");
  expect_fault("1 2 3\n4 5 \x1b[2J\n", "p.xyz:2: column 3 (z) \"\\x1b[2J\" is not a number");
  expect_fault("1 2 3\n4 5 " + std::string(5000, 'q') + "\n",
               "p.xyz:2: column 3 (z) \"" + std::string(40, 'q') + "...\"");
  expect_fault("1 2 3\n4 5 6\r7 8 9\n", "p.xyz:2: column 3 (z) \"6\\x0d7\" is not a number");
  expect_fault("1 2 3\n4 5 6x\n", "p.xyz:2: column 3 (z) \"6x\"");
}

TEST_F(ReadXyz, DecimalCommaIsRefusedWithAdvice) {
  expect_fault("1,5;2,5;3,5\n",
               "p.xyz:1: column 1 (x) \"1,5\" has a decimal comma: write it with a decimal point");
  expect_fault("1,5 2,5 3,5\n", "p.xyz:1: column 1 (x) \"1,5\" has a decimal comma");
  expect_fault("1;2;3\n1;2;3,25\n", "p.xyz:2: column 3 (z) \"3,25\" has a decimal comma");
}

TEST_F(ReadXyz, FileWithoutPointsIsRefused) {
  EXPECT_EQ(fault(""), "p.xyz: is empty: there is nothing to read in it");
  EXPECT_EQ(fault("\xef\xbb\xbf"), "p.xyz: is empty: there is nothing to read in it");
  expect_fault("\n\n# only\n", "p.xyz: has no points: there are only blank lines and comments");
  expect_fault("x,y,z\n", "p.xyz: has no points: there is only a header");
  EXPECT_EQ(fault("1 2 5\n3 4 5\n", {.nodata = 5}), "p.xyz: has no points: every z is the no-data value");
}

TEST_F(ReadXyz, NodataRowsAreSkippedAndCounted) {
  const auto table = read("1 2 3\n8 8 -9999\n4.5 -6 7e2\n7 7 -9999.0\n", {.nodata = -9999});
  ASSERT_TRUE(table);
  EXPECT_EQ(table->points, kTwo);
  EXPECT_EQ(table->skipped_nodata, 2u);
  const auto nan = read("1 2 3\n8 8 NaN\n4.5 -6 7e2\n", {.nodata = std::numeric_limits<double>::quiet_NaN()});
  ASSERT_TRUE(nan);
  EXPECT_EQ(nan->points, kTwo);
  EXPECT_EQ(nan->skipped_nodata, 1u);
}

TEST_F(ReadXyz, BinaryJunkIsRefused) {
  expect_fault(std::string_view("1 2 3\n4 5\0 6\n", 13), "p.xyz:2: NUL byte");
  expect_fault(
      "\xff\xfe"
      "1 2 3",
      "p.xyz: UTF-16 text");
  expect_fault("1 2 3\r4 5 6\r", "p.xyz: lines end in CR alone");
}

TEST_F(ReadXyz, ForeignFormatsAreRefusedWithAdvice) {
  const std::pair<std::string_view, std::string_view> cases[] = {
      {"\x1f\x8b\x08", "gzip-compressed: unpack it first: gunzip -c FILE | thalweg ... -"},
      {"LASF", "LAS or LAZ"},
      {std::string_view("II*\0", 4), "a TIFF"},
      {"PK\x03\x04", "a zip archive"},
      {std::string_view("\0\0\x27\x0a", 4), "a shapefile"}};
  for (const auto& [magic, advice] : cases) {
    path_ = folder_.put("p.whatever", std::string(magic) + "tail");
    const auto table = read_points(path_);
    ASSERT_FALSE(table);
    EXPECT_EQ(table.error().code, ErrorCode::unreadable);
    EXPECT_TRUE(message_of(table, path_).starts_with("p.whatever: " + std::string(advice)));
  }
}

TEST_F(ReadXyz, FileThatCannotBeReadIsRefusedWithTheReason) {
  const auto code_and_message = [](const std::string& path) {
    const auto table = read_points(path);
    EXPECT_FALSE(table);
    EXPECT_EQ(table.error().code, ErrorCode::unreadable);
    return message_of(table, path);
  };
  EXPECT_EQ(code_and_message(folder_ / "none.xyz"), "none.xyz: cannot be opened: No such file or directory");
  ::mkdir((folder_ / "d.xyz").c_str(), 0700);
  EXPECT_EQ(code_and_message(folder_ / "d.xyz"),
            "d.xyz: is a directory: give a file of points, a grid or a mesh");
  const std::string locked = folder_.put("locked.xyz", "1 2 3\n");
  ::chmod(locked.c_str(), 0);
  if (::geteuid() == 0) return;  // to root nothing is locked
  EXPECT_EQ(code_and_message(locked), "locked.xyz: cannot be opened: Permission denied");
}

TEST_F(ReadXyz, UnknownSuffixIsRefusedUnlessTheFormatIsSaid) {
  path_ = folder_.put("p.foo", "1 2 3\n4.5 -6 7e2\n");
  const auto table = read_points(path_);
  ASSERT_FALSE(table);
  EXPECT_EQ(table.error().code, ErrorCode::invalid_argument);
  EXPECT_NE(table.error().message.find("xyz, csv, tsv, asc, obj, ply, ply-ascii, 2dm"), std::string::npos);
  const auto forced = read_points(path_, {.format = "xyz"});
  ASSERT_TRUE(forced);
  EXPECT_EQ(forced->points, kTwo);
  EXPECT_FALSE(read_points(path_, {.format = "geojson"}));
}

TEST_F(ReadXyz, StdinIsReadAndNamed) {
  const int saved = ::dup(STDIN_FILENO);
  const auto read_stdin = [&](std::string_view content, const ReadOptions& options = {}) {
    const std::string path = folder_.put("stdin", content);
    EXPECT_NE(std::freopen(path.c_str(), "rb", stdin), nullptr);
    return read_points("-", options);
  };
  const auto plain = read_stdin("1 2 3\n4.5 -6 7e2\n");
  const auto grid = read_stdin("ncols 1\nnrows 1\nxllcenter 1\nyllcenter 2\ncellsize 1\n3\n");
  const auto bad = read_stdin("1 2 3\n4 5 x\n", {.format = "xyz"});
  ::dup2(saved, STDIN_FILENO);
  ::close(saved);
  ASSERT_TRUE(plain);
  EXPECT_EQ(plain->points, kTwo);
  ASSERT_TRUE(grid);
  EXPECT_EQ(grid->points, (std::vector<Point3>{{1, 2, 3}}));
  ASSERT_FALSE(bad);
  EXPECT_TRUE(bad.error().message.starts_with("<stdin>:2: column 3 (z) \"x\"")) << bad.error().message;
}

TEST_F(ReadXyz, PipeOfUnknownLengthIsReadToItsEnd) {
  const std::string path = folder_ / "fifo.xyz";
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  std::string content;
  for (int i = 0; i < 40000; ++i) content += std::to_string(i) + " 2 3\n";
  std::thread writer([&] { std::ofstream(path) << content; });
  const auto table = read_points(path);
  writer.join();
  ASSERT_TRUE(table);
  EXPECT_EQ(table->points.size(), 40000u);
}

TEST_F(ReadXyz, ThreadsChangeNothing) {
  std::string content = "x,y,z\n";
  for (int i = 0; i < 60000; ++i) {
    content +=
        std::to_string(i) + "," + std::to_string(i * 7 % 1000) + ".25," + std::to_string(i % 11) + "\n";
    if (i % 1000 == 0) content += "# comment\n\n";
  }
  const auto one = read(content, {.nodata = 3});
  ASSERT_TRUE(one);
  for (const unsigned threads : {2u, 3u, 8u, 64u}) {
    const auto many = read(content, {.nodata = 3, .threads = threads});
    ASSERT_TRUE(many);
    EXPECT_EQ(many->points, one->points);
    EXPECT_EQ(many->skipped_nodata, one->skipped_nodata);
  }
  const std::string faulty = content + "1,2,first\n" + content.substr(6) + "1,2,second\n";
  const std::string message = fault(faulty);
  EXPECT_TRUE(message.starts_with("p.xyz:60122: column 3 (z) \"first\"")) << message;
  for (const unsigned threads : {2u, 3u, 8u}) EXPECT_EQ(fault(faulty, {.threads = threads}), message);
}

// A text is read in blocks of half a megabyte and more; where they end must not show.
TEST_F(ReadXyz, BlocksDoNotShow) {
  std::string content =
      "# " + std::string(700000, 'c') + "\n";  // an opening longer than what is loaded first
  for (int i = 0; i < 100000; ++i) content += std::to_string(i) + ".25 2 " + std::to_string(i % 100) + "\r\n";
  content.insert(content.find('\r', content.size() / 2),
                 " " + std::string(1200000, 'w'));  // a line of several blocks
  for (const unsigned threads : {1u, 2u, 7u}) {
    const std::vector<Point3> all = points(content + "1 2 3", {.threads = threads});
    ASSERT_EQ(all.size(), 100001u);
    for (int i = 0; i < 100000; ++i)
      ASSERT_EQ(all[static_cast<std::size_t>(i)], (Point3{i + 0.25, 2, i % 100 * 1.0}));
    EXPECT_EQ(all.back(), (Point3{1, 2, 3}));
    expect_fault(content + "1 2 x\n" + content, "p.xyz:100002: column 3 (z) \"x\"", {.threads = threads});
    expect_fault("1 2 x\n" + content + std::string("1 2 3\0\n", 7), "p.xyz:100003: NUL byte",
                 {.threads = threads});
    expect_fault("x y\n" + content + std::string("1 2 3\0\n", 7), "p.xyz:100003: NUL byte",
                 {.threads = threads});
  }
}

// Quotes lead a row away from the fast path, and must not change what it means.
TEST_F(ReadXyz, FastAndCarefulParsingAgree) {
  const std::string_view words[] = {"1", "-2.5", "+3",  "1e5",   ".5",     "7.", "",
                                    "x", "nan",  "inf", "1e999", "1e-999", "0x1"};
  std::uint64_t state = 7;
  for (int round = 0; round < 300; ++round) {
    std::string plain = "1,2,3\n";
    std::string quoted = plain;
    for (int column = 0; column < 4; ++column) {
      state = state * 6364136223846793005u + 1442695040888963407u;
      const std::string_view word = words[(state >> 33) % (round % 2 == 0 ? 6 : std::size(words))];
      plain += std::string(column == 0 ? "" : " ,") + std::string(word);
      quoted += std::string(column == 0 ? "" : ",") + "\"" + std::string(word) + " \"";
    }
    const auto a = read(plain);
    const std::string message = message_of(a, path_);
    const auto b = read(quoted);
    EXPECT_EQ(message, message_of(b, path_)) << plain;
    if (a && b) {
      EXPECT_TRUE(test::same_bits(a->points, b->points)) << plain;
    }
  }
}

TEST_F(ReadXyz, CancelStopsReading) {
  const std::atomic<bool> cancel = true;
  const auto table = read("1 2 3\n", {.cancel = &cancel});
  ASSERT_FALSE(table);
  EXPECT_EQ(table.error().code, ErrorCode::cancelled);
}

TEST(Format, ComesFromTheNameElseFromTheSuffix) {
  EXPECT_EQ(*format_of("a/b.c/d.PLY", "", Direction::write), Format::ply);
  EXPECT_EQ(*format_of("x.ply", "ply-ascii", Direction::write), Format::ply_ascii);
  EXPECT_EQ(*format_of("x.geojson", "", Direction::write), Format::geojson);
  EXPECT_EQ(*format_of("-", "2dm", Direction::write), Format::two_dm);
  EXPECT_EQ(*format_of("grid.asc", "", Direction::read), Format::asc);
  EXPECT_FALSE(format_of("x.geojson", "", Direction::read));
  EXPECT_FALSE(format_of("grid.asc", "", Direction::write));
  EXPECT_FALSE(format_of("-", "", Direction::write));
  EXPECT_FALSE(format_of("a.ply/b", "", Direction::write));
  EXPECT_EQ(format_of("x.foo", "", Direction::write).error().message,
            "x.foo: \".foo\" is no suffix of a format that can be written: say the format with --to (xyz, "
            "csv, tsv, obj, "
            "ply, ply-ascii, 2dm, tlw, npy, geojson)");
}

}  // namespace
}  // namespace thalweg::io
