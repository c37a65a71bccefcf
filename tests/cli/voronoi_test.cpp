/// `thalweg voronoi`: drawings and nearest points.
#include <algorithm>
#include <sstream>

#include "cli/command.hpp"

namespace thalweg::test {
namespace {

class CliVoronoi : public CommandTest {};

constexpr const char* kKite = "0 0 1\n10 0 2\n5 1 3\n5 -1 4\n";

TEST_F(CliVoronoi, AnswersQueriesNearestFirst) {
  write("kite.xyz", kKite);
  write("places.txt", "# where\n0 0.25\n\n9 0\n5 0\n");
  ASSERT_EQ(run({"voronoi", "kite.xyz", "-k", "2", "--query", "places.txt", "-o", "near.csv"}).code, 0);
  // (5, 0) is as far from row 3 as from row 2: the smaller (x, y) comes first.
  EXPECT_EQ(read("near.csv"), "query,site,site\n0,0,2\n1,1,3\n2,3,2\n");
}

TEST_F(CliVoronoi, AnswersAgreeWithSortingAllRows) {
  write("points.xyz", noise(300, 20));
  std::string places;
  std::vector<std::pair<long, long>> queries;
  for (long i = 0; i < 200; ++i) {
    queries.emplace_back((i * 7919) % 1000003, (i * 104729) % 1000003);
    places += std::to_string(queries.back().first) + ", " + std::to_string(queries.back().second) + "\n";
  }
  write("places.csv", "x,y\n" + places);
  std::istringstream rows(run({"voronoi", "points.xyz", "-k", "4", "--query", "places.csv", "-o", "-"}).out);
  struct Row {
    long x, y, z;
  };
  std::vector<Row> points;
  std::istringstream file(read("points.xyz"));
  for (Row row{}; file >> row.x >> row.y >> row.z;) points.push_back(row);
  std::string line;
  std::getline(rows, line);
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const auto [x, y] = queries[i];
    std::vector<std::array<long, 4>> order;
    for (std::size_t r = 0; r < points.size(); ++r) {
      const long dx = points[r].x - x, dy = points[r].y - y;
      order.push_back({dx * dx + dy * dy, points[r].x, points[r].y, static_cast<long>(r)});
    }
    std::sort(order.begin(), order.end());
    std::string expected = std::to_string(i);
    for (std::size_t j = 0; j < 4; ++j) expected += "," + std::to_string(order[j][3]);
    ASSERT_TRUE(std::getline(rows, line));
    EXPECT_EQ(line, expected);
  }
}

TEST_F(CliVoronoi, DrawsCellsThatTileTheBox) {
  write("points.xyz", noise(60, 3));
  ASSERT_EQ(run({"voronoi", "points.xyz", "-k", "3", "-o", "cells.geojson", "-o", "cells.svg"}).code, 0);
  const Json collection = Json::parse(read("cells.geojson"));
  double area = 0, low = 1e9, high = -1e9, left = 1e9, right = -1e9;
  for (const Json& feature : collection["features"]) {
    EXPECT_EQ(feature["properties"]["sites"].size(), 3u);
    const Json& ring = feature["geometry"]["coordinates"][0];
    EXPECT_EQ(ring.front(), ring.back());
    for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
      const double x = ring[i][0], y = ring[i][1], next_x = ring[i + 1][0], next_y = ring[i + 1][1];
      area += (x * next_y - y * next_x) / 2;
      low = std::min(low, y);
      high = std::max(high, y);
      left = std::min(left, x);
      right = std::max(right, x);
    }
  }
  const double box = (right - left) * (high - low);
  EXPECT_NEAR(area / box, 1, 1e-9);
  const std::string picture = read("cells.svg");
  EXPECT_EQ(picture.substr(0, 5), "<svg ");
  std::size_t paths = 0;
  for (std::size_t at = picture.find("<path"); at != std::string::npos; at = picture.find("<path", at + 1))
    ++paths;
  EXPECT_EQ(paths, collection["features"].size());
}

TEST_F(CliVoronoi, CountsWithoutOutput) {
  write("kite.xyz", kKite);
  const Json j = run_json({"voronoi", "kite.xyz", "-k", "1"});
  EXPECT_EQ(j["voronoi"]["cells"], 4);
  EXPECT_EQ(j["voronoi"]["vertices"], 2);
  EXPECT_EQ(files(), std::vector<std::string>{"kite.xyz"});
}

TEST_F(CliVoronoi, MergedRowsAreStoodForByTheOneThePolicyKeeps) {
  write("kite.xyz", std::string(kKite) + "0 0 0.5\n");
  write("places.txt", "1 0\n");
  const auto answer = [&](const std::string& policy) {
    return run(
        {"voronoi", "kite.xyz", "-k", "1", "--query", "places.txt", "-o", "-", "--duplicates", policy});
  };
  EXPECT_EQ(answer("lowest").out, "query,site\n0,4\n");
  EXPECT_EQ(answer("highest").out, "query,site\n0,0\n");
  EXPECT_EQ(answer("last").out, "query,site\n0,4\n");
  EXPECT_EQ(answer("error").code, 3);
}

TEST_F(CliVoronoi, PointsOnALineAreLegal) {
  write("line.xyz", "0 0 1\n2 2 1\n1 1 1\n7 7 1\n");
  write("places.txt", "6 6\n");
  EXPECT_EQ(run({"voronoi", "line.xyz", "-k", "2", "--query", "places.txt", "-o", "-"}).out,
            "query,site,site\n0,3,1\n");
}

TEST_F(CliVoronoi, RefusesWhatCannotBe) {
  write("kite.xyz", kKite);
  write("bad.txt", "1 2\n3 four\n");
  EXPECT_EQ(run({"voronoi", "kite.xyz"}).code, 2);
  EXPECT_EQ(run({"voronoi", "kite.xyz", "-k", "0"}).code, 2);
  EXPECT_EQ(run({"voronoi", "kite.xyz", "-k", "5"}).code, 3);
  EXPECT_EQ(run({"voronoi", "kite.xyz", "-k", "1", "-o", "a.csv"}).code, 2);
  EXPECT_EQ(run({"voronoi", "kite.xyz", "-k", "1", "-o", "a.ply"}).code, 2);
  EXPECT_EQ(run({"voronoi", "kite.xyz", "-k", "1", "--query", "none.txt", "-o", "a.csv"}).code, 3);
  const Outcome bad = run({"voronoi", "kite.xyz", "-k", "1", "--query", "bad.txt", "-o", "a.csv"});
  EXPECT_EQ(bad.code, 3);
  EXPECT_NE(bad.err.find("bad.txt:2:"), std::string::npos) << bad.err;
  EXPECT_FALSE(exists("a.csv"));
}

}  // namespace
}  // namespace thalweg::test
