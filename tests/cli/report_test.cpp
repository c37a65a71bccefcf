/// `thalweg report`, and reports of `thalweg build`.
#include "cli/command.hpp"

namespace thalweg::test {
namespace {

class CliReport : public CommandTest {
 protected:
  /// The object in a page's element of data.
  Json data_of(const std::string& name) const {
    const std::string page = read(name);
    const std::string mark = "id=\"report-data\">";
    const std::size_t from = page.find(mark);
    const std::size_t to = page.find("</script>", from);
    EXPECT_NE(to, std::string::npos);
    return Json::parse(page.substr(from + mark.size(), to - from - mark.size()));
  }
};

TEST_F(CliReport, TellsTheFiguresOfTheSummary) {
  write("points.xyz", noise(400, 1));
  const Json summary = run_json({"build", "points.xyz", "-k", "4", "--report", "a.html", "-o", "a.ply"});
  const Json page = data_of("a.html");
  EXPECT_EQ(page["pits"]["total"][0], summary["pits"]["delaunay"]["total"]);
  EXPECT_EQ(page["pits"]["total"][1], summary["pits"]["result"]["total"]);
  EXPECT_EQ(page["lower_bound"], summary["pits"]["lower_bound"]);
  EXPECT_EQ(page["edges_changed"], summary["mesh"]["edges_changed"]);
  EXPECT_EQ(page["order_histogram"], summary["mesh"]["order_histogram"]);
  EXPECT_EQ(page["hash_in"], page["hash_out"]);
  EXPECT_EQ(page["water"]["basins"], page["pits"]["total"]);
  EXPECT_EQ(page["remaining"]["x"].size(), summary["pits"]["remaining"].size());
  EXPECT_EQ(page["drawn"]["common"].get<int>() + page["drawn"]["after"].get<int>(),
            summary["mesh"]["triangles"]);
  EXPECT_TRUE(page["sweep"]["order"].empty());
}

TEST_F(CliReport, OfAMeshAndOfASummaryIsThatOfTheBuild) {
  write("points.xyz", noise(300, 2));
  ASSERT_EQ(run({"build", "points.xyz", "--report", "a.html", "-o", "a.ply", "--json", "a.json"}).code, 0);
  ASSERT_EQ(run({"report", "a.ply", "-o", "b.html"}).code, 0);
  ASSERT_EQ(run({"report", "a.json", "-o", "c.html", "-o", "c.svg"}).code, 0);
  const Json a = data_of("a.html"), b = data_of("b.html"), c = data_of("c.html");
  EXPECT_EQ(a, c);
  for (const char* key : {"pits", "water", "lower_bound", "edges_changed", "non_delaunay_edges", "removed",
                          "drawn", "hash_out", "order_histogram"}) {
    EXPECT_EQ(a[key], b[key]) << key;
  }
  EXPECT_EQ(a["remaining"]["spill"], b["remaining"]["spill"]);
  EXPECT_EQ(b["hash_in"], "");
}

TEST_F(CliReport, ShowsASweepIfAskedFor) {
  write("points.xyz", noise(60, 3));
  ASSERT_EQ(run({"build", "points.xyz", "--report", "a.html", "--sweep"}).code, 0);
  EXPECT_EQ(data_of("a.html")["sweep"]["best"].size(), 11u);
  EXPECT_EQ(run({"build", "points.xyz", "--sweep"}).code, 2);
}

TEST_F(CliReport, DoesNotDependOnThreads) {
  write("points.xyz", noise(500, 4));
  ASSERT_EQ(run({"build", "points.xyz", "--report", "a.html", "--threads", "1"}).code, 0);
  ASSERT_EQ(run({"build", "points.xyz", "--report", "b.html", "--threads", "3"}).code, 0);
  EXPECT_EQ(read("a.html"), read("b.html"));
}

TEST_F(CliReport, SaysWhenElevationsAreMeans) {
  write("points.xyz", "0 0 5\n9 0 7\n0 0 3\n0 9 4\n9 9 8\n");
  ASSERT_EQ(run({"build", "points.xyz", "--report", "a.html", "--duplicates", "mean"}).code, 0);
  const Json page = data_of("a.html");
  EXPECT_NE(page["hash_in"], page["hash_out"]);
  EXPECT_EQ(page["merged"], 1);
}

TEST_F(CliReport, RefusesWhatItCannotShow) {
  write("points.xyz", noise(50, 5));
  write("bad.json", "{\"tool\": \"thalweg\"}");
  write("torn.json", "{\"tool\": ");
  write("fold.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 1 2 4\n");
  EXPECT_EQ(run({"build", "points.xyz", "--report", "a.pdf"}).code, 2);
  EXPECT_EQ(run({"report", "bad.json", "-o", "a.html"}).code, 3);
  EXPECT_EQ(run({"report", "torn.json", "-o", "a.html"}).code, 3);
  EXPECT_EQ(run({"report", "fold.obj", "-o", "a.html"}).code, 4);
  EXPECT_EQ(run({"report", "none.ply", "-o", "a.html"}).code, 3);
  EXPECT_EQ(run({"report", "fold.obj", "-o", "a.html", "--layers", "edges,clouds"}).code, 2);
  EXPECT_FALSE(exists("a.html"));
}

TEST_F(CliReport, RefusesPointsThatAreNotThoseOfTheSummary) {
  write("points.xyz", noise(80, 6));
  ASSERT_EQ(run({"build", "points.xyz", "--json", "a.json"}).code, 0);
  write("points.xyz", noise(81, 6));
  const Outcome outcome = run({"report", "a.json", "-o", "a.html"});
  EXPECT_EQ(outcome.code, 4) << outcome.err;
  EXPECT_FALSE(exists("a.html"));
}

TEST_F(CliReport, MapsOfASurveyAreSmall) {
  ASSERT_EQ(run({"build", data("jacksboro_1.xyz"), "-o", "a.svg", "--layers",
                 "shading,cells,flow,edges,changes,pits"})
                .code,
            0);
  EXPECT_LT(read("a.svg").size(), 2'000'000u);
}

}  // namespace
}  // namespace thalweg::test
