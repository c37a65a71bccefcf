/// Every command on every case of the degenerate corpus: a triangulation that `check` accepts, or exit code 3
/// with one line that says why.
#include "support/corpus.hpp"
#include "cli/command.hpp"
#include "support/brute.hpp"

namespace thalweg::test {
namespace {

class CliCorpus : public CommandTest {
 protected:
  /// Runs `check` on each case with the code with which every command must end.
  template <class Check>
  void for_each_case(Check&& check) const {
    const auto cases = support::corpus(THALWEG_TEST_DATA "/../corpus");
    EXPECT_GT(cases.size(), 50u);
    for (const support::CorpusCase& c : cases) {
      SCOPED_TRACE(c.name);
      const std::vector<Point2> places = c.places();
      check(c, support::all_collinear(places, support::distinct_rows(places)) ? 3 : 0);
      if (HasFatalFailure()) return;
    }
  }

  Outcome expect(int code, const std::vector<std::string>& arguments) const {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, code) << arguments[0] << ": " << outcome.err;
    if (code == 3) {
      EXPECT_EQ(outcome.err.rfind("thalweg: error: ", 0), 0u) << outcome.err;
      EXPECT_EQ(outcome.out, "");
    }
    return outcome;
  }
};

TEST_F(CliCorpus, BuildsWhatCheckAccepts) {
  for_each_case([&](const support::CorpusCase& c, int code) {
    for (const char* method : {"flip", "hull", "best"}) {
      const std::string mesh = c.name + "_" + method + ".tlw";
      expect(code, {"build", c.path, "-o", mesh, "-m", method, "-k", "3", "--threads", "2", "-q"});
      EXPECT_EQ(exists(mesh), code == 0);
    }
    if (code == 0) expect(0, {"check", c.name + "_best.tlw", "-k", "3", "-q"});
  });
}

TEST_F(CliCorpus, TheOtherCommandsEndAsBuildDoes) {
  for_each_case([&](const support::CorpusCase& c, int code) {
    expect(code, {"sweep", c.path, "-k", "0..3", "-q"});
    expect(code, {"edges", c.path, "-k", "2", "-o", c.name + ".csv", "-q"});
  });
}

TEST_F(CliCorpus, InfoReadsWhateverHasRows) {
  for_each_case([&](const support::CorpusCase& c, int) {
    expect(c.points.empty() ? 3 : 0, {"info", c.path});
  });
}

TEST_F(CliCorpus, VoronoiNeedsAsManySitesAsItsOrder) {
  for_each_case([&](const support::CorpusCase& c, int) {
    const std::size_t sites = support::distinct_rows(c.places()).size();
    const Outcome outcome =
        run({"voronoi", c.path, "-k", "2", "--query", c.path, "-o", c.name + ".csv", "-q"});
    EXPECT_EQ(outcome.code == 0, sites >= 2) << outcome.err;
    if (outcome.code != 0) {
      EXPECT_TRUE(outcome.code == 2 || outcome.code == 3) << outcome.code;
    }
  });
}

TEST_F(CliCorpus, ReportShowsWhatWasBuilt) {
  for_each_case([&](const support::CorpusCase& c, int code) {
    if (code != 0) return;
    const std::string mesh = c.name + ".ply";
    expect(0, {"build", c.path, "-o", mesh, "-q"});
    expect(0, {"report", mesh, "-o", c.name + ".html", "-q"});
    EXPECT_TRUE(exists(c.name + ".html"));
  });
}

// Commands that take other inputs refuse these.
TEST_F(CliCorpus, SampleAndGenerateRefuseTables) {
  for_each_case([&](const support::CorpusCase& c, int) {
    const Outcome sample = run({"sample", c.path, "-n", "3", "--seed", "1", "-o", "s.xyz"});
    EXPECT_TRUE(sample.code == 2 || sample.code == 3) << sample.err;
    const Outcome generate = run({"generate", "theorem1", "--segments", c.path, "-o", "g.xyz"});
    EXPECT_TRUE(generate.code == 2 || generate.code == 3) << generate.err;
    EXPECT_FALSE(exists("s.xyz") || exists("g.xyz"));
  });
}

}  // namespace
}  // namespace thalweg::test
