/// `thalweg check`: meshes of any tool, sound or not.
#include "cli/command.hpp"

namespace thalweg::test {
namespace {

class CliCheck : public CommandTest {
 protected:
  /// The square of the corners 0, 0 and 4, 4, with this list of faces.
  void write_square(const std::string& faces) const {
    write("square.obj", "v 0 0 1\nv 4 0 2\nv 4 4 3\nv 0 4 4\n" + faces);
  }
  Json faults(int code = 4) const { return run_json({"check", "square.obj"}, code)["faults"]; }
};

TEST_F(CliCheck, TellsOrderAndPitsOfASoundMesh) {
  write_square("f 1 2 3\nf 1 3 4\n");
  const Json j = run_json({"check", "square.obj", "-k", "0"});
  EXPECT_EQ(keys(j),
            (std::vector<std::string>{"tool", "version", "input", "parameters", "passed", "sound", "faults",
                                      "pits", "mesh", "points", "seconds", "peak_memory_bytes"}));
  EXPECT_EQ(j["sound"], true);
  EXPECT_EQ(j["mesh"],
            (Json{{"triangles", 2}, {"max_order", 0}, {"order_histogram", {2}}, {"non_delaunay_edges", 0}}));
  EXPECT_EQ(j["pits"], (Json{{"total", 1}, {"interior", 0}, {"boundary", 1}}));
}

TEST_F(CliCheck, FailsAboveTheOrder) {
  // A flat kite split along its long diagonal: each circle holds the other end of the short one.
  write("kite.obj", "v 0 0 1\nv 10 0 2\nv 5 1 3\nv 5 -1 4\nf 1 2 3\nf 2 1 4\n");
  const Json j = run_json({"check", "kite.obj", "-k", "0"}, 4);
  EXPECT_EQ(j["sound"], true);
  EXPECT_EQ(j["passed"], false);
  EXPECT_EQ(j["mesh"]["max_order"], 1);
  EXPECT_EQ(j["mesh"]["non_delaunay_edges"], 1);
  EXPECT_EQ(run({"check", "kite.obj", "-k", "1"}).code, 0);
  EXPECT_EQ(run({"check", "kite.obj"}).code, 0);
}

TEST_F(CliCheck, ListsFaultsWithCountsAndExamples) {
  write_square("f 1 2 3\nf 1 4 3\n");
  const Json clockwise = faults();
  ASSERT_GE(clockwise.size(), 1u);
  EXPECT_EQ(clockwise[0]["kind"], "clockwise triangle");
  EXPECT_EQ(clockwise[0]["count"], 1);
  EXPECT_GE(clockwise[0]["examples"].size(), 1u);

  write_square("f 1 2 3\n");
  EXPECT_EQ(run({"check", "square.obj"}).code, 4);
  write_square("f 1 2 3\nf 1 2 3\nf 1 3 4\n");
  EXPECT_EQ(run({"check", "square.obj"}).code, 4);
  write_square("f 1 2 3\nf 1 1 4\n");
  EXPECT_EQ(run({"check", "square.obj"}).code, 4);
  write_square("f 1 2 3\nf 1 2 4\n");
  const Outcome overlapping = run({"check", "square.obj"});
  EXPECT_EQ(overlapping.code, 4);
  EXPECT_NE(overlapping.err.find("thalweg: error: square.obj: "), std::string::npos) << overlapping.err;
}

TEST_F(CliCheck, ComparesVerticesWithPoints) {
  write_square("f 1 2 3\nf 1 3 4\n");
  write("same.xyz", "4 4 3\n0 4 4\n0 0 1\n4 0 2\n4 0 7\n");
  EXPECT_EQ(run({"check", "square.obj", "--points", "same.xyz"}).code, 0);
  write("more.xyz", "4 4 3\n0 4 4\n0 0 1\n4 0 2\n2 2 2\n");
  EXPECT_EQ(run_json({"check", "square.obj", "--points", "more.xyz"}, 4)["points"]["missing"], 1);
  write("fewer.xyz", "4 4 3\n0 4 4\n0 0 1\n");
  EXPECT_EQ(run_json({"check", "square.obj", "--points", "fewer.xyz"}, 4)["points"]["foreign"], 1);
  write("moved.xyz", "4 4 3\n0 4 4.0000000000000009\n0 0 1\n4 0 2\n");
  const Json j = run_json({"check", "square.obj", "--points", "moved.xyz"}, 4);
  EXPECT_EQ(j["points"]["changed"], 1);
  EXPECT_EQ(j["points"]["examples"].size(), 1u);
}

TEST_F(CliCheck, FailsOnInteriorPitsOnly) {
  write("bowl.obj", "v 0 0 9\nv 4 0 9\nv 4 4 9\nv 0 4 9\nv 2 2 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n");
  EXPECT_EQ(run({"check", "bowl.obj"}).code, 0);
  EXPECT_EQ(run({"check", "bowl.obj", "--fail-on-pits"}).code, 4);
  write_square("f 1 2 3\nf 1 3 4\n");
  EXPECT_EQ(run({"check", "square.obj", "--fail-on-pits"}).code, 0);
}

TEST_F(CliCheck, ReadsStdin) {
  write_square("f 1 2 3\nf 1 3 4\n");
  EXPECT_EQ(run({"check", "-", "--from", "obj"}, read("square.obj")).code, 0);
  EXPECT_EQ(run({"check", "-", "--points", "-"}).code, 2);
}

}  // namespace
}  // namespace thalweg::test
