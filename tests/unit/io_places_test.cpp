/// Reading places: two numbers a line.
#include <gtest/gtest.h>

#include "io/read_places.hpp"
#include "support/io_support.hpp"

namespace thalweg::io {
namespace {

using test::ScratchFolder;

class ReadPlaces : public testing::Test {
 protected:
  Result<std::vector<Point2>> read(std::string_view content) {
    return read_places(folder_.put("q.txt", content));
  }

  ScratchFolder folder_;
};

const std::vector<Point2> kTwo = {{1, -2.5}, {3e300, 4}};

TEST_F(ReadPlaces, BlanksAndCommasSeparate) {
  for (const char* text : {"1 -2.5\n3e300 4\n", "1,-2.5\n3e300,4", "  1\t-2.5 \r\n3e300 , 4 , 7\r\n",
                           "# c\n\n1 -2.5 99 x\n\n3e300,4\n", "x,y\n1,-2.5\n3e300,4\n"}) {
    const auto places = read(text);
    ASSERT_TRUE(places) << text;
    EXPECT_EQ(*places, kTwo) << text;
  }
  EXPECT_TRUE(read("# nobody asks\n")->empty());
}

TEST_F(ReadPlaces, FaultsNameTheLine) {
  for (const char* text :
       {"1 2\n3 four\n", "1 2\nx y\n", "x y\n5\n", "1 2\n3,,4\n", "1 2\n3 nan\n", "1 2\n3 1e999\n"}) {
    const auto places = read(text);
    ASSERT_FALSE(places) << text;
    EXPECT_EQ(places.error().code, ErrorCode::malformed) << text;
    EXPECT_NE(places.error().message.find("q.txt:2: "), std::string::npos) << places.error().message;
  }
  const auto first = read("nan 3\n");
  ASSERT_FALSE(first);
  EXPECT_EQ(first.error().code, ErrorCode::malformed);
}

TEST_F(ReadPlaces, NoFile) {
  const auto places = read_places(folder_ / "none.txt");
  ASSERT_FALSE(places);
  EXPECT_EQ(places.error().code, ErrorCode::unreadable);
}

}  // namespace
}  // namespace thalweg::io
