/// `thalweg build`: outputs, summary, options.
#include <algorithm>
#include <numeric>
#include <set>

#include "cli/command.hpp"
#include "io/mesh_file.hpp"
#include "io/point_table.hpp"

namespace thalweg::test {
namespace {

class CliBuild : public CommandTest {
 protected:
  io::MeshFile mesh(const std::string& name) const {
    auto read = io::read_mesh(path(name));
    EXPECT_TRUE(read) << name;
    return read ? *std::move(read) : io::MeshFile{};
  }
};

TEST_F(CliBuild, WritesSeveralFormatsOfOneTerrain) {
  write("points.xyz", noise(300, 1));
  const Outcome outcome =
      run({"build", "points.xyz", "-o", "a.ply", "-o", "a.obj", "-o", "a.2dm", "-o", "a.csv"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  const io::MeshFile ply = mesh("a.ply");
  EXPECT_EQ(ply.points.size(), 300u);
  EXPECT_EQ(mesh("a.obj").points, ply.points);
  EXPECT_EQ(mesh("a.obj").triangles, ply.triangles);
  EXPECT_EQ(mesh("a.2dm").points, ply.points);
  EXPECT_EQ(mesh("a.2dm").triangles, ply.triangles);
  EXPECT_EQ(files(), (std::vector<std::string>{"a.2dm", "a.csv", "a.obj", "a.ply", "points.xyz"}));
}

TEST_F(CliBuild, KeepsVerticesInTheOrderOfTheRows) {
  write("points.xyz", noise(300, 2));
  ASSERT_EQ(run({"build", "points.xyz", "-o", "a.ply"}).code, 0);
  const auto rows = io::read_points(path("points.xyz"));
  ASSERT_TRUE(rows);
  EXPECT_EQ(mesh("a.ply").points, rows->points);
}

TEST_F(CliBuild, DropsMergedRowsAndKeepsTheOrderOfTheOthers) {
  write("points.xyz", "0 0 5\n9 0 7\n0 0 3\n0 9 4\n9 9 8\n");
  const Outcome outcome = run({"build", "points.xyz", "-o", "a.obj"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("warning"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("lowest"), std::string::npos) << outcome.err;
  const std::vector<Point3> expected = {{9, 0, 7}, {0, 0, 3}, {0, 9, 4}, {9, 9, 8}};
  EXPECT_EQ(mesh("a.obj").points, expected);
}

TEST_F(CliBuild, ObeysTheDuplicatePolicy) {
  write("points.xyz", "0 0 5\n9 0 7\n0 0 3\n0 9 4\n0 0 1\n");
  const auto first_site = [&](const std::string& policy) {
    EXPECT_EQ(run({"build", "points.xyz", "-o", "a.obj", "--overwrite", "--duplicates", policy}).code, 0);
    const io::MeshFile file = mesh("a.obj");
    const auto at = std::ranges::find_if(file.points, [](const Point3& p) { return p.x == 0 && p.y == 0; });
    return at == file.points.end() ? -1 : at->z;
  };
  EXPECT_EQ(first_site("lowest"), 1);
  EXPECT_EQ(first_site("highest"), 5);
  EXPECT_EQ(first_site("first"), 5);
  EXPECT_EQ(first_site("last"), 1);
  EXPECT_EQ(first_site("mean"), 3);
  EXPECT_EQ(run({"build", "points.xyz", "-o", "b.obj", "--duplicates", "error"}).code, 3);
  EXPECT_FALSE(exists("b.obj"));
}

TEST_F(CliBuild, SummaryHasTheKeysOfTheContractInOrder) {
  write("points.xyz", noise(400, 3));
  const Json j = run_json({"build", "points.xyz", "-k", "4", "-m", "hull", "--threads", "2"});
  using Keys = std::vector<std::string>;
  EXPECT_EQ(keys(j), (Keys{"tool", "version", "input", "parameters", "pits", "mesh", "work", "seconds",
                           "peak_memory_bytes"}));
  EXPECT_EQ(keys(j["input"]), (Keys{"file", "points", "vertices", "duplicates", "policy"}));
  EXPECT_EQ(keys(j["parameters"]), (Keys{"order", "method", "threads"}));
  EXPECT_EQ(keys(j["pits"]), (Keys{"delaunay", "result", "lower_bound", "certified", "remaining"}));
  EXPECT_EQ(keys(j["pits"]["delaunay"]), (Keys{"total", "interior", "boundary"}));
  EXPECT_EQ(keys(j["pits"]["result"]), (Keys{"total", "interior", "boundary"}));
  EXPECT_EQ(keys(j["mesh"]), (Keys{"triangles", "max_order", "order_histogram", "edges_changed",
                                   "non_delaunay_edges", "min_angle_deg"}));
  EXPECT_EQ(keys(j["mesh"]["min_angle_deg"]), (Keys{"before", "after"}));
  EXPECT_EQ(keys(j["work"]), (Keys{"flips", "insertions", "circle_counts"}));
  EXPECT_EQ(keys(j["seconds"]), (Keys{"read", "delaunay", "minimize", "write", "total"}));
  ASSERT_FALSE(j["pits"]["remaining"].empty());
  EXPECT_EQ(keys(j["pits"]["remaining"][0]),
            (Keys{"vertex", "x", "y", "z", "boundary", "reason", "order_needed"}));
}

TEST_F(CliBuild, SummaryAgreesWithItselfAndWithTheInput) {
  write("points.xyz", noise(400, 3) + noise(1, 3));
  const Json j = run_json({"build", "points.xyz", "-k", "4", "-m", "hull", "--threads", "2"});
  EXPECT_EQ(j["tool"], "thalweg");
  EXPECT_EQ(j["input"], (Json{{"file", "points.xyz"},
                              {"points", 401},
                              {"vertices", 400},
                              {"duplicates", 1},
                              {"policy", "lowest"}}));
  EXPECT_EQ(j["parameters"], (Json{{"order", 4}, {"method", "hull"}, {"threads", 2}}));
  const Json& pits = j["pits"];
  for (const char* when : {"delaunay", "result"}) {
    const int interior = pits[when]["interior"];
    const int boundary = pits[when]["boundary"];
    EXPECT_EQ(pits[when]["total"], interior + boundary);
  }
  EXPECT_EQ(pits["remaining"].size(), pits["result"]["total"]);
  EXPECT_LE(pits["lower_bound"], pits["result"]["total"]);
  EXPECT_EQ(pits["certified"], pits["lower_bound"] == pits["result"]["total"]);
  const std::vector<int> histogram = j["mesh"]["order_histogram"];
  EXPECT_EQ(std::accumulate(histogram.begin(), histogram.end(), 0), j["mesh"]["triangles"]);
  EXPECT_EQ(j["mesh"]["max_order"], histogram.size() - 1);
  EXPECT_LE(j["mesh"]["max_order"], 4);
  EXPECT_GE(j["seconds"]["total"], j["seconds"]["minimize"]);
  EXPECT_GT(j["peak_memory_bytes"], 1000000);
}

TEST_F(CliBuild, RemainingPitsNameVerticesOfTheMesh) {
  write("points.xyz", "500000 500000 1\n500000 500000 0\n" + noise(300, 4));
  const Json j = run_json({"build", "points.xyz", "-o", "a.ply"});
  const io::MeshFile file = mesh("a.ply");
  const std::set<std::string> reasons = {"unremovable", "conflict", "kept"};
  for (const Json& pit : j["pits"]["remaining"]) {
    const Point3& p = file.points.at(pit["vertex"].get<std::size_t>());
    EXPECT_EQ(p, (Point3{pit["x"], pit["y"], pit["z"]}));
    EXPECT_TRUE(reasons.contains(pit["reason"].get<std::string>())) << pit;
    EXPECT_TRUE(pit["order_needed"].is_null() || pit["order_needed"].is_number_unsigned()) << pit;
  }
}

TEST_F(CliBuild, CheckConfirmsTheMesh) {
  write("points.xyz", noise(500, 5));
  const Json built = run_json({"build", "points.xyz", "-o", "a.ply", "-k", "6"});
  const Json checked = run_json({"check", "a.ply", "-k", "6", "--points", "points.xyz"});
  EXPECT_EQ(checked["passed"], true);
  EXPECT_EQ(checked["pits"], built["pits"]["result"]);
  EXPECT_EQ(checked["mesh"]["order_histogram"], built["mesh"]["order_histogram"]);
  EXPECT_EQ(checked["mesh"]["non_delaunay_edges"], built["mesh"]["non_delaunay_edges"]);
}

TEST_F(CliBuild, MethodsAreNeverWorseThanDelaunayAndBestIsLeast) {
  write("points.xyz", noise(500, 6));
  const auto pits = [&](const std::string& method) {
    return run_json({"build", "points.xyz", "-m", method})["pits"]["result"]["total"].get<int>();
  };
  const int delaunay = pits("delaunay");
  const int flip = pits("flip");
  const int hull = pits("hull");
  const int best = pits("best");
  EXPECT_LE(flip, delaunay);
  EXPECT_LE(hull, delaunay);
  EXPECT_LE(best, std::min(flip, hull));
  EXPECT_EQ(run_json({"build", "points.xyz"})["pits"]["result"]["total"], best);
  EXPECT_EQ(run_json({"build", "points.xyz"})["parameters"]["order"], 8);
}

/// Nine sites whose optimum at order 4 lies above the bound that `best` has: only the search can prove it.
TEST_F(CliBuild, ExactProvesWhatBestCannot) {
  write("trap.xyz", "6 6 3\n8 0 3\n2 8 28\n7 3 28\n5 7 16\n1 5 17\n1 8 0\n0 2 19\n0 5 20\n");
  const Json best = run_json({"build", "trap.xyz", "-k", "4"});
  EXPECT_EQ(best["pits"]["result"]["total"], 2);
  EXPECT_EQ(best["pits"]["certified"], false);
  for (const char* limit : {"0", "60"}) {
    const Json exact = run_json({"build", "trap.xyz", "-k", "4", "-m", "exact", "--time-limit", limit});
    EXPECT_EQ(exact["parameters"]["method"], "exact");
    EXPECT_EQ(exact["pits"]["result"]["total"], 2);
    EXPECT_EQ(exact["pits"]["lower_bound"], 2);
    EXPECT_EQ(exact["pits"]["certified"], true);
  }
  const Outcome short_of_time =
      run({"build", "trap.xyz", "-k", "4", "-m", "exact", "--time-limit", "0.000000001"});
  EXPECT_EQ(short_of_time.code, 0);
  for (const char* wrong : {"-1", "soon", "nan", ""}) {
    EXPECT_EQ(run({"build", "trap.xyz", "-m", "exact", "--time-limit", wrong}).code, 2) << wrong;
  }
}

TEST_F(CliBuild, SameBytesForEitherCounter) {
  write("points.xyz", noise(500, 7));
  ASSERT_EQ(run({"build", "points.xyz", "-o", "crawl.ply", "--counter", "crawl"}).code, 0);
  ASSERT_EQ(run({"build", "points.xyz", "-o", "voronoi.ply", "--counter", "voronoi"}).code, 0);
  EXPECT_TRUE(read("crawl.ply") == read("voronoi.ply"));
  EXPECT_EQ(run({"build", "points.xyz", "--counter", "abacus"}).code, 2);
}

TEST_F(CliBuild, SameBytesForAnyNumberOfThreads) {
  write("points.xyz", noise(2000, 7));
  ASSERT_EQ(run({"build", "points.xyz", "-o", "one.ply", "--threads", "1"}).code, 0);
  ASSERT_EQ(run({"build", "points.xyz", "-o", "four.ply", "--threads", "4"}).code, 0);
  EXPECT_TRUE(read("one.ply") == read("four.ply"));
}

TEST_F(CliBuild, ReadsStdinAndWritesStdout) {
  const std::string points = noise(100, 8);
  write("points.xyz", points);
  ASSERT_EQ(run({"build", "points.xyz", "-o", "a.ply"}).code, 0);
  const Outcome piped = run({"build", "-", "-o", "-", "--to", "ply"}, points);
  EXPECT_EQ(piped.code, 0) << piped.err;
  EXPECT_TRUE(piped.out == read("a.ply"));
}

TEST_F(CliBuild, OneToForAllOutputsOrOneForEach) {
  write("points.xyz", noise(50, 9));
  ASSERT_EQ(run({"build", "points.xyz", "-o", "a", "-o", "b", "--to", "obj"}).code, 0);
  EXPECT_EQ(read("a"), read("b"));
  ASSERT_EQ(run({"build", "points.xyz", "-o", "c", "-o", "-", "--to", "obj", "--to", "2dm"}).code, 0);
  EXPECT_EQ(read("c"), read("a"));
  EXPECT_EQ(run({"build", "points.xyz", "-o", "d", "-o", "e", "-o", "f", "--to", "obj", "--to", "obj"}).code,
            2);
}

TEST_F(CliBuild, WritesRemainingAndRemovedPits) {
  write("points.xyz", noise(400, 10));
  const Json j = run_json({"build", "points.xyz", "--pits", "pits.geojson"});
  const Json collection = Json::parse(read("pits.geojson"));
  std::size_t removed = 0;
  for (const Json& feature : collection["features"]) removed += feature["properties"]["removed"] ? 1 : 0;
  EXPECT_GT(removed, 0u);
  EXPECT_EQ(collection["features"].size() - removed, j["pits"]["result"]["total"]);
  ASSERT_EQ(run({"build", "points.xyz", "--pits", "pits.csv"}).code, 0);
  const std::string rows = read("pits.csv");
  EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(rows, '\n')), collection["features"].size() + 1);
}

TEST_F(CliBuild, WithoutOutputOnlyReports) {
  write("points.xyz", noise(50, 11));
  const Outcome outcome = run({"build", "points.xyz"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.out, "");
  EXPECT_NE(outcome.err.find("pits"), std::string::npos);
  EXPECT_EQ(files(), std::vector<std::string>{"points.xyz"});
}

TEST_F(CliBuild, QuietSaysNothing) {
  write("points.xyz", noise(50, 12) + noise(3, 12));
  const Outcome outcome = run({"build", "points.xyz", "-o", "a.ply", "-q", "--progress", "bar"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.err, "");
}

TEST_F(CliBuild, FailsOnInteriorPitsAfterWriting) {
  // A bowl: its lowest point is inside and can drain nowhere.
  write("bowl.xyz", "0 0 9\n10 0 9.5\n10 10 9.7\n0 10 9.2\n5 4 1\n");
  EXPECT_EQ(run({"build", "bowl.xyz", "-o", "a.ply", "--fail-on-pits"}).code, 4);
  EXPECT_TRUE(exists("a.ply"));
  // A plane: its only pit is on the boundary, where water leaves.
  write("plane.xyz", "0 0 0\n10 0 10\n10 10 21\n0 10 11\n5 4 9\n");
  EXPECT_EQ(run({"build", "plane.xyz", "-o", "b.ply", "--fail-on-pits"}).code, 0);
}

TEST_F(CliBuild, RefusesWhatNeedsMoreMemoryThanAllowed) {
  write("points.xyz", noise(50, 13));
  const Outcome outcome = run({"build", "points.xyz", "-o", "a.ply", "--max-memory", "1K"});
  EXPECT_EQ(outcome.code, 5);
  EXPECT_NE(outcome.err.find("--max-memory"), std::string::npos);
  EXPECT_FALSE(exists("a.ply"));
  EXPECT_EQ(run({"build", "points.xyz", "-o", "a.ply", "--max-memory", "8G"}).code, 0);
}

TEST_F(CliBuild, CountsTheMemoryOfAReport) {
  write("points.xyz", noise(20'000, 13));
  EXPECT_EQ(run({"build", "points.xyz", "-m", "delaunay", "--max-memory", "28M"}).code, 0);
  for (const char* report : {"a.html", "a.svg"}) {
    const Outcome outcome =
        run({"build", "points.xyz", "-m", "delaunay", "--max-memory", "28M", "--report", report});
    EXPECT_EQ(outcome.code, 5) << report;
    EXPECT_FALSE(exists(report));
  }
}

TEST_F(CliBuild, ReadsChosenColumnsAndSkipsNodata) {
  write("points.csv", "id,height,east,north\n1,5,0,0\n2,6,9,0\n3,7,0,9\n4,-99,9,9\n");
  const Json j =
      run_json({"build", "points.csv", "--columns", "east,north,height", "--nodata", "-99", "-o", "a.obj"});
  EXPECT_EQ(j["input"]["points"], 3);
  EXPECT_EQ(mesh("a.obj").points, (std::vector<Point3>{{0, 0, 5}, {9, 0, 6}, {0, 9, 7}}));
}

TEST_F(CliBuild, WarnsOfDegrees) {
  write("degrees.xyz", "-121.5 37.1 5\n-121.4 37.1 6\n-121.5 37.2 7\n");
  EXPECT_NE(run({"build", "degrees.xyz"}).err.find("degrees"), std::string::npos);
  write("metres.xyz", "500000.5 37.1 5\n500001.5 37.1 6\n500001.4 37.2 7\n");
  EXPECT_EQ(run({"build", "metres.xyz"}).err.find("look like degrees"), std::string::npos);
}

TEST_F(CliBuild, ProvesARealTerrain) {
  const Json j = run_json({"build", data("jacksboro_fault.asc"), "-o", "a.ply"});
  EXPECT_EQ(j["input"]["vertices"], 138632);
  EXPECT_LT(j["pits"]["result"]["total"], j["pits"]["delaunay"]["total"]);
}

TEST_F(CliBuild, DrawsAndErasesAProgressBar) {
  write("points.xyz", noise(100, 14));
  const Outcome outcome = run({"build", "points.xyz", "--progress", "bar"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_NE(outcome.err.find("reading ["), std::string::npos);
  EXPECT_NE(outcome.err.find("\r\033[K"), std::string::npos);
  EXPECT_EQ(run({"build", "points.xyz"}).err.find('\r'), std::string::npos) << "no bar without a terminal";
}

}  // namespace
}  // namespace thalweg::test
