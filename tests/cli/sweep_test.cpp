/// `thalweg sweep`: the table of orders and methods.
#include <algorithm>

#include "cli/command.hpp"

namespace thalweg::test {
namespace {

class CliSweep : public CommandTest {};

TEST_F(CliSweep, WritesOneObjectAnInput) {
  write("a.xyz", noise(300, 30));
  write("b.xyz", noise(200, 31));
  const Json j = run_json({"sweep", "a.xyz", "b.xyz", "-k", "1..4"});
  ASSERT_EQ(j.size(), 2u);
  EXPECT_EQ(keys(j[0]), (std::vector<std::string>{"file", "vertices", "rows"}));
  EXPECT_EQ(j[0]["file"], "a.xyz");
  EXPECT_EQ(j[1]["vertices"], 200);
  ASSERT_EQ(j[0]["rows"].size(), 4u);
  EXPECT_EQ(keys(j[0]["rows"][0]),
            (std::vector<std::string>{"order", "flip", "hull", "best", "lower_bound", "certified"}));
  EXPECT_EQ(j[0]["rows"][0]["order"], 1);
  EXPECT_EQ(j[0]["rows"][3]["order"], 4);
}

TEST_F(CliSweep, RowsAgreeWithBuild) {
  write("a.xyz", noise(300, 32));
  const Json j = run_json({"sweep", "a.xyz", "-k", "0..3"});
  for (const Json& row : j[0]["rows"]) {
    for (const char* method : {"flip", "hull", "best"}) {
      const Json built =
          run_json({"build", "a.xyz", "-k", std::to_string(row["order"].get<int>()), "-m", method});
      EXPECT_EQ(row[method], built["pits"]["result"]["total"]) << row << method;
    }
  }
}

TEST_F(CliSweep, TableGoesToStderrAndDefaultsToTen) {
  write("a.xyz", noise(100, 33));
  const Outcome outcome = run({"sweep", "a.xyz"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 2 + 11) << outcome.err;
}

TEST_F(CliSweep, TakesOneOrder) {
  write("a.xyz", noise(100, 34));
  const Json j = run_json({"sweep", "a.xyz", "-k", "5"});
  ASSERT_EQ(j[0]["rows"].size(), 1u);
  EXPECT_EQ(j[0]["rows"][0]["order"], 5);
}

TEST_F(CliSweep, WritesCsv) {
  write("a,b.xyz", noise(100, 35));
  ASSERT_EQ(run({"sweep", "a,b.xyz", "-k", "0..1", "-o", "sweep.csv"}).code, 0);
  const std::string text = read("sweep.csv");
  EXPECT_EQ(text.substr(0, text.find('\n')), "file,order,flip,hull,best,lower_bound,certified");
  EXPECT_EQ(std::ranges::count(text, '\n'), 3);
  EXPECT_NE(text.find("\n\"a,b.xyz\",0,"), std::string::npos) << text;
}

TEST_F(CliSweep, RefusesBadRanges) {
  write("a.xyz", noise(10, 36));
  for (const char* range : {"3..1", "-1", "..", "1..", "a", "1...3", ""}) {
    EXPECT_EQ(run({"sweep", "a.xyz", "-k", range}).code, 2) << range;
  }
}

TEST_F(CliSweep, OneBadInputSpoilsAll) {
  write("a.xyz", noise(10, 37));
  write("bad.xyz", "1 2 x\n");
  EXPECT_EQ(run({"sweep", "a.xyz", "bad.xyz", "-o", "sweep.csv", "--json", "sweep.json"}).code, 3);
  EXPECT_EQ(files(), (std::vector<std::string>{"a.xyz", "bad.xyz"}));
}

}  // namespace
}  // namespace thalweg::test
