/// `thalweg info`: what is in a file.
#include "cli/command.hpp"

namespace thalweg::test {
namespace {

class CliInfo : public CommandTest {};

TEST_F(CliInfo, CountsPointsAndDuplicates) {
  write("a.xyz", "0 0 1\n0 0 1\n0 0 2\n5 0 -3\n0 7 1\n");
  const Json j = run_json({"info", "a.xyz"});
  EXPECT_EQ(j["input"]["kind"], "points");
  EXPECT_EQ(j["points"], 5);
  EXPECT_EQ(j["vertices"], 3);
  EXPECT_EQ(j["duplicates"], (Json{{"exact", 1}, {"other_z", 1}}));
  EXPECT_EQ(j["collinear"], false);
  EXPECT_EQ(j["extent"], (Json{{"x", {0.0, 5.0}}, {"y", {0.0, 7.0}}, {"z", {-3.0, 2.0}}}));
  EXPECT_GT(j["build_memory_bytes"], 0);
}

TEST_F(CliInfo, TellsCollinearPoints) {
  write("line.xyz", "0 0 1\n1 1 1\n2 2 1\n");
  EXPECT_EQ(run_json({"info", "line.xyz"})["collinear"], true);
  write("one.xyz", "0 0 1\n");
  EXPECT_EQ(run_json({"info", "one.xyz"})["collinear"], true);
}

TEST_F(CliInfo, TellsTheShapeOfAGrid) {
  const Json j = run_json({"info", data("jacksboro_fault.asc")});
  EXPECT_EQ(j["input"]["kind"], "grid");
  EXPECT_EQ(j["grid"]["columns"], 403);
  EXPECT_EQ(j["grid"]["rows"], 344);
  EXPECT_EQ(j["points"], 138632);
}

TEST_F(CliInfo, CountsTrianglesOfAMesh) {
  write("a.obj", "v 0 0 1\nv 1 0 1\nv 0 1 1\nf 1 2 3\n");
  const Json j = run_json({"info", "a.obj"});
  EXPECT_EQ(j["input"]["kind"], "mesh");
  EXPECT_EQ(j["triangles"], 1);
}

TEST_F(CliInfo, AMeshWithoutFacesIsPoints) {
  write("a.obj", "v 0 0 1\nv 1 0 1\nv 0 1 1\n");
  const Json j = run_json({"info", "a.obj"});
  EXPECT_EQ(j["input"]["kind"], "points");
  EXPECT_EQ(j["points"], 3);
}

TEST_F(CliInfo, ReadsStdin) {
  const Outcome outcome = run({"info", "-"}, "0 0 1\n1 0 1\n0 1 1\n");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
}

}  // namespace
}  // namespace thalweg::test
