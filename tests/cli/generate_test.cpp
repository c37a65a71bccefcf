/// `thalweg generate`: terrains and hard instances, the same bytes for the same arguments.
#include "cli/command.hpp"

namespace thalweg::test {
namespace {

class CliGenerate : public CommandTest {
 protected:
  std::string points(const std::vector<std::string>& arguments) const {
    std::vector<std::string> all = {"generate"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    all.insert(all.end(), {"-o", "-", "--to", "xyz"});
    const Outcome outcome = run(all);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return outcome.out;
  }
  /// Expects this code, an error that holds `fragment`, and nothing written.
  void expect_error(const std::vector<std::string>& arguments, int code, const std::string& fragment) const {
    std::vector<std::string> all = {"generate", "-o", "never.xyz"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const Outcome outcome = run(all);
    EXPECT_EQ(outcome.code, code) << outcome.err;
    EXPECT_NE(outcome.err.find(fragment), std::string::npos) << outcome.err;
    EXPECT_FALSE(exists("never.xyz"));
  }
  /// The pits that `build` leaves, which it must say are the fewest.
  std::uint64_t fewest_pits(const std::string& file, std::uint64_t order) const {
    const Json summary = run_json({"build", file, "-k", std::to_string(order), "-o", file + ".ply"});
    EXPECT_TRUE(summary["pits"]["certified"].get<bool>());
    return summary["pits"]["result"]["total"];
  }
};

/// Three that cross each other, one apart: two of them at most do not cross.
constexpr const char* kSegments = "# x1 y1 x2 y2\n-10 -1 10 2\n\n-1 -10 2 10\n-7 8 8 -7\n20 0 21 9\n";

TEST_F(CliGenerate, SameSeedSameBytesOtherSeedOthers) {
  // Written down once: a change of a generator would change everybody's data.
  EXPECT_EQ(points({"fractal", "-n", "3", "--seed", "1"}),
            "12.917319 16.818261 783.251186\n7.696527 7.69489 708.477824\n13.213718 15.196125 661.497251\n");
  EXPECT_EQ(points({"lidar", "--n", "3", "--seed", "1"}),
            "500000.03 4100000.16 250.01\n500000.44 4100000.21 250.06\n499999.83 4100000.61 250\n");
  EXPECT_EQ(points({"theorem1", "-n", "2", "--seed", "1"}),
            "9 351 1\n270 99 2\n513 0 1\n333 477 2\n65 312 3\n45 365 3\n297 88 3\n277 141 3\n457 39 3\n"
            "486 11 3\n297 463 3\n326 435 3\n");
  for (const char* kind :
       {"fractal", "ridge", "plateau", "ring", "grid", "lidar", "theorem1", "corollary2"}) {
    const std::string first = points({kind, "-n", "3", "--seed", "1"});
    EXPECT_EQ(first, points({kind, "-n", "3", "--seed", "1"}));
    EXPECT_NE(first, points({kind, "-n", "3", "--seed", "2"}));
    EXPECT_EQ(points({kind, "-n", "3"}), points({kind, "-n", "3", "--seed", "0"}));
  }
}

TEST_F(CliGenerate, TerrainsAreBuilt) {
  for (const char* kind : {"fractal", "ridge", "plateau", "ring", "grid", "lidar"}) {
    const Json summary =
        run_json({"generate", kind, "-n", "500", "--seed", "3", "-o", "a.xyz", "--overwrite"});
    EXPECT_EQ(keys(summary),
              (std::vector<std::string>{"tool", "version", "parameters", "points", "peak_memory_bytes"}));
    EXPECT_EQ(summary["parameters"].dump(),
              std::string(R"({"kind":")") + kind + R"(","count":500,"seed":3})");
    EXPECT_EQ(run_json({"info", "a.xyz"})["points"], 500) << kind;
    EXPECT_EQ(run({"build", "a.xyz", "-o", "a.ply", "--overwrite"}).code, 0);
  }
}

TEST_F(CliGenerate, TheoremOneOfAFileIsSolved) {
  write("segments.txt", kSegments);
  const Json summary = run_json({"generate", "theorem1", "--segments", "segments.txt", "-o", "hard.xyz"});
  EXPECT_EQ(summary["parameters"].dump(), R"({"kind":"theorem1","segments":"segments.txt"})");
  EXPECT_EQ(summary["points"], 56);
  EXPECT_EQ(keys(summary["instance"]),
            (std::vector<std::string>{"segments", "shields", "guards", "order", "scale"}));
  EXPECT_EQ(summary["instance"]["shields"], 48);
  EXPECT_EQ(fewest_pits("hard.xyz", summary["instance"]["order"]), 6u);
}

TEST_F(CliGenerate, CorollaryTwoIsSolvedAtTheOrderItPrints) {
  write("segments.txt", kSegments);
  const Outcome outcome = run({"generate", "corollary2", "--segments", "segments.txt", "-o", "hard.xyz"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("order k = 32"), std::string::npos) << outcome.err;
  EXPECT_EQ(fewest_pits("hard.xyz", 32), 6u);
}

TEST_F(CliGenerate, DrawsAgainUntilCorollaryTwoFits) {
  for (int seed = 0; seed < 6; ++seed) {
    const Json summary = run_json(
        {"generate", "corollary2", "-n", "6", "--seed", std::to_string(seed), "-o", "a.xyz", "--overwrite"});
    EXPECT_EQ(summary["instance"]["order"], 72);
    EXPECT_EQ(summary["points"], 4452);
  }
}

TEST_F(CliGenerate, SegmentsFromStdin) {
  const Outcome outcome =
      run({"generate", "theorem1", "--segments", "-", "-o", "-", "--to", "csv"}, "0 0 7 5\n1 6 5 0\n");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out.rfind("x,y,z\n0,0,1\n", 0), 0u) << outcome.out;
}

TEST_F(CliGenerate, BadSegmentsAreNamedByLine) {
  const auto refuse = [&](const std::string& text, const std::string& fragment) {
    write("s.txt", text);
    expect_error({"theorem1", "--segments", "s.txt"}, 3, fragment);
  };
  refuse("0 0 4 4\n9 0 0 9\n# touches\n2 2 7 1\n", "s.txt:4: ");
  refuse("0 0 4 4\n1.5 0 0 9\n", "s.txt:2: ");
  refuse("0 0 4 4\n1 0 0\n", "s.txt:2: ");
  refuse("0 0 4 4\n1 0 0 9 7\n", "s.txt:2: ");
  refuse("0 0 4 4\n9 9 9 9\n", "s.txt:2: ");
  refuse("0 0 4 4\n", "s.txt: 1 segments");
  expect_error({"theorem1", "--segments", "none.txt"}, 3, "none.txt");
}

TEST_F(CliGenerate, SenselessOptionsAreUsageErrors) {
  expect_error({"flat", "-n", "9"}, 2, "fractal, ridge, plateau, ring, grid, lidar, theorem1, corollary2");
  expect_error({"fractal"}, 2, "-n");
  expect_error({"theorem1"}, 2, "--segments");
  expect_error({"fractal", "--segments", "s.txt"}, 2, "--segments");
  expect_error({"theorem1", "--segments", "s.txt", "-n", "3"}, 2, "--segments");
  expect_error({"fractal", "-n", "2"}, 2, "fewer than 3");
  expect_error({"fractal", "-n", "0"}, 2, "a number from 1");
  expect_error({"corollary2", "-n", "9"}, 2, "23634 points");
  expect_error({"theorem1", "-n", "1"}, 2, "from 2 to");
  expect_error({"theorem1", "-n", "201"}, 2, "at most 200");
  expect_error({"fractal", "-n", "9", "-o", "a.ply"}, 2, "ply");
}

}  // namespace
}  // namespace thalweg::test
