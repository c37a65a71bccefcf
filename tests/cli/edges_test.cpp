/// `thalweg edges`: pairs by useful order.
#include <sstream>

#include "cli/command.hpp"

namespace thalweg::test {
namespace {

class CliEdges : public CommandTest {};

// A flat kite: the short diagonal is Delaunay, the long one has useful order 1.
constexpr const char* kKite = "0 0 1\n10 0 2\n5 1 3\n5 -1 4\n";

TEST_F(CliEdges, WritesRowsUVOrder) {
  write("kite.xyz", kKite);
  ASSERT_EQ(run({"edges", "kite.xyz", "-k", "0", "-o", "a.csv"}).code, 0);
  EXPECT_EQ(read("a.csv"), "u,v,order\n0,2,0\n0,3,0\n1,2,0\n1,3,0\n2,3,0\n");
  ASSERT_EQ(run({"edges", "kite.xyz", "-k", "1", "-o", "b.csv"}).code, 0);
  EXPECT_EQ(read("b.csv"), "u,v,order\n0,1,1\n0,2,0\n0,3,0\n1,2,0\n1,3,0\n2,3,0\n");
}

TEST_F(CliEdges, StdoutNeedsNoFormat) {
  write("kite.xyz", kKite);
  const Outcome outcome = run({"edges", "kite.xyz", "-k", "0", "-o", "-"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out.substr(0, 10), "u,v,order\n");
}

TEST_F(CliEdges, MergedRowsAreStoodForByTheOneThePolicyKeeps) {
  write("kite.xyz", std::string(kKite) + "0 0 0.5\n");
  const auto rows = [&](const std::string& policy) {
    return run({"edges", "kite.xyz", "-k", "0", "-o", "-", "--duplicates", policy}).out;
  };
  EXPECT_EQ(rows("lowest"), "u,v,order\n1,2,0\n1,3,0\n2,3,0\n2,4,0\n3,4,0\n");
  EXPECT_EQ(rows("first"), "u,v,order\n0,2,0\n0,3,0\n1,2,0\n1,3,0\n2,3,0\n");
}

TEST_F(CliEdges, CountsWithoutOutput) {
  write("kite.xyz", kKite);
  const Json j = run_json({"edges", "kite.xyz", "-k", "3"});
  EXPECT_EQ(j["edges"], (Json{{"total", 6}, {"order_histogram", {5, 1}}}));
  EXPECT_EQ(j["parameters"]["order"], 3);
  EXPECT_EQ(files(), std::vector<std::string>{"kite.xyz"});
}

TEST_F(CliEdges, RowsAreSortedAndDistinct) {
  write("points.xyz", noise(300, 20));
  std::istringstream rows(run({"edges", "points.xyz", "-k", "3", "-o", "-"}).out);
  std::string line;
  std::getline(rows, line);
  std::pair<long, long> last{-1, -1};
  while (std::getline(rows, line)) {
    const std::size_t comma = line.find(',');
    const std::pair<long, long> pair{std::stol(line), std::stol(line.substr(comma + 1))};
    EXPECT_LT(pair.first, pair.second);
    EXPECT_LT(last, pair);
    last = pair;
  }
  EXPECT_GT(last.first, 0);
}

TEST_F(CliEdges, NeedsAnOrderAndCsv) {
  write("kite.xyz", kKite);
  EXPECT_EQ(run({"edges", "kite.xyz"}).code, 2);
  EXPECT_EQ(run({"edges", "kite.xyz", "-k", "1", "-o", "a.ply"}).code, 2);
  EXPECT_FALSE(exists("a.ply"));
}

}  // namespace
}  // namespace thalweg::test
