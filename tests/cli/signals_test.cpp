/// Ctrl-C, kill and closed pipes: no half file, and the right exit code. Every wait is for something to
/// happen.
#include <signal.h>

#include "cli/command.hpp"

namespace thalweg::test {
namespace {

class CliSignals : public CommandTest {
 protected:
  void expect_interrupted(Process& process, const std::vector<std::string>& left) const {
    const Outcome outcome = process.finish();
    EXPECT_EQ(outcome.code, 130) << outcome.err;
    EXPECT_NE(outcome.err.find("interrupted"), std::string::npos) << outcome.err;
    EXPECT_EQ(files(), left);
  }
};

TEST_F(CliSignals, WhileReading) {
  for (const int signal : {SIGINT, SIGTERM}) {
    Process process(folder(), {"build", "-", "-o", "out.ply", "--progress", "bar"});
    ASSERT_TRUE(process.await_error("reading"));
    process.send(signal);
    process.close_input();
    expect_interrupted(process, {});
  }
}

TEST_F(CliSignals, WhileMinimizing) {
  write("points.xyz", noise(30000, 40));
  // At this order the search takes many times longer than the bar needs to appear and the signal to arrive.
  Process process(folder(), {"build", "points.xyz", "-k", "200", "-o", "out.ply", "--json", "out.json",
                             "--progress", "bar", "--threads", "1"});
  ASSERT_TRUE(process.await_error("searching exits"));
  process.send(SIGINT);
  expect_interrupted(process, {"points.xyz"});
}

TEST_F(CliSignals, WhileWriting) {
  write("points.xyz", noise(30000, 41));
  // The first output is whole under its temporary name when the second fills its pipe, which nobody empties.
  Process process(folder(), {"build", "points.xyz", "-m", "delaunay", "-k", "0", "-o", "out.ply", "-o", "-",
                             "--to", "ply"});
  ASSERT_TRUE(process.await_output());
  process.send(SIGINT);
  expect_interrupted(process, {"points.xyz"});
}

TEST_F(CliSignals, KeepsTheOldOutput) {
  write("points.xyz", noise(30000, 42));
  write("out.ply", "old");
  Process process(folder(), {"build", "points.xyz", "-m", "delaunay", "-k", "0", "--overwrite", "-o",
                             "out.ply", "-o", "-", "--to", "ply"});
  ASSERT_TRUE(process.await_output());
  process.send(SIGINT);
  expect_interrupted(process, {"out.ply", "points.xyz"});
  EXPECT_EQ(read("out.ply"), "old");
}

TEST_F(CliSignals, AClosedPipeIsReportedQuietly) {
  write("points.xyz", noise(30000, 43));
  Process process(folder(), {"build", "points.xyz", "-q", "-m", "delaunay", "-k", "0", "-o", "out.ply", "-o",
                             "-", "--to", "ply"});
  process.close_output();
  const Outcome outcome = process.finish();
  EXPECT_EQ(outcome.code, 6);
  EXPECT_EQ(outcome.err, "");
  EXPECT_FALSE(exists("out.ply"));
}

}  // namespace
}  // namespace thalweg::test
