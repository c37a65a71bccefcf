/// `thalweg sample`: random cells of a grid.
#include <algorithm>
#include <map>

#include "cli/command.hpp"

namespace thalweg::test {
namespace {

class CliSample : public CommandTest {
 protected:
  void write_grid() const {
    write("grid.asc",
          "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 10\nNODATA_value -1\n1 2 3\n4 -1 6\n");
  }
};

TEST_F(CliSample, AllCellsAreTheGridInItsOrder) {
  write_grid();
  ASSERT_EQ(run({"sample", "grid.asc", "-n", "5", "--seed", "1", "-o", "a.xyz"}).code, 0);
  EXPECT_EQ(read("a.xyz"), "5 15 1\n15 15 2\n25 15 3\n5 5 4\n25 5 6\n");
}

TEST_F(CliSample, SameSeedSameBytesOtherSeedOthers) {
  const auto sample = [&](const std::string& seed) {
    return run({"sample", data("jacksboro_fault.asc"), "-n", "3", "--seed", seed, "-o", "-", "--to", "xyz"})
        .out;
  };
  // Written down once: a change of the generator or of the order would change everybody's data.
  EXPECT_EQ(sample("3"),
            "2501.67138671875 29049.5712890625 469\n3696.49951171875 22841.2099609375 450\n"
            "21394.89111328125 18764.0771484375 348\n");
  EXPECT_EQ(sample("3"), sample("3"));
  EXPECT_NE(sample("3"), sample("4"));
}

TEST_F(CliSample, EveryPairOfCellsIsDrawn) {
  write_grid();
  std::map<std::string, int> seen;
  for (int seed = 0; seed < 100; ++seed) {
    const Outcome outcome =
        run({"sample", "grid.asc", "-n", "2", "--seed", std::to_string(seed), "-o", "-", "--to", "xyz"});
    EXPECT_EQ(outcome.out.find("15 5 "), std::string::npos) << "the cell without data";
    ++seen[outcome.out];
  }
  EXPECT_EQ(seen.size(), 10u);  // of 5 cells; a pair is missed by chance once in 3700 sets of seeds
}

TEST_F(CliSample, TooManyCellsIsAnError) {
  write_grid();
  const Outcome outcome = run({"sample", "grid.asc", "-n", "6", "--seed", "1", "-o", "a.xyz"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.err.find("5 cells"), std::string::npos) << outcome.err;
  EXPECT_FALSE(exists("a.xyz"));
}

TEST_F(CliSample, NeedsCountSeedAndOutput) {
  write_grid();
  EXPECT_EQ(run({"sample", "grid.asc", "--seed", "1", "-o", "a.xyz"}).code, 2);
  EXPECT_EQ(run({"sample", "grid.asc", "-n", "1", "-o", "a.xyz"}).code, 2);
  EXPECT_EQ(run({"sample", "grid.asc", "-n", "1", "--seed", "1"}).code, 2);
  EXPECT_EQ(run({"sample", "grid.asc", "-n", "0", "--seed", "1", "-o", "a.xyz"}).code, 2);
  EXPECT_EQ(run({"sample", "grid.asc", "-n", "1", "--seed", "-1", "-o", "a.xyz"}).code, 2);
  EXPECT_EQ(files(), std::vector<std::string>{"grid.asc"});
}

TEST_F(CliSample, PipesIntoBuild) {
  const Outcome sampled =
      run({"sample", data("jacksboro_fault.asc"), "-n", "500", "--seed", "1", "-o", "-", "--to", "xyz"});
  EXPECT_EQ(run({"build", "-", "-o", "a.ply"}, sampled.out).code, 0);
}

}  // namespace
}  // namespace thalweg::test
