/// Everything that can be wrong with an input, an output or a command line: the exit code, a message that
/// names the place, and nothing written.
#include <filesystem>

#include "cli/command.hpp"

namespace thalweg::test {
namespace {

class CliErrors : public CommandTest {
 protected:
  /// Runs, and expects this code, an error that holds `fragment`, silence on stdout, and no new file.
  void expect_error(const std::vector<std::string>& arguments, int code, const std::string& fragment) const {
    const std::vector<std::string> before = files();
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, code) << outcome.err;
    EXPECT_EQ(outcome.err.rfind("thalweg: error: ", 0), 0u) << outcome.err;
    EXPECT_NE(outcome.err.find(fragment), std::string::npos) << fragment << " is not in " << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(files(), before);
  }
  /// The same of a build of this file.
  void expect_bad(const std::string& name, const std::string& text, const std::string& fragment) const {
    write(name, text);
    expect_error({"build", name, "-o", "out.ply", "--json", "out.json", "--pits", "out.csv"}, 3, fragment);
  }
  void write_good() const { write("good.xyz", "0 0 1\n9 0 2\n0 9 3\n9 8 4\n"); }
};

TEST_F(CliErrors, NotANumber) {
  expect_bad("a.xyz", "0 0 1\n1 x 2\n3 4 5\n", "a.xyz:2: ");
}
TEST_F(CliErrors, MissingColumn) {
  expect_bad("a.xyz", "0 0 1\n1 2\n3 4 5\n", "a.xyz:2: ");
}
TEST_F(CliErrors, NoSuchColumn) {
  write("a.csv", "x,y,z\n0,0,1\n");
  expect_error({"build", "a.csv", "--columns", "x,y,height", "-o", "out.ply"}, 3, "height");
}
TEST_F(CliErrors, NaN) {
  expect_bad("a.xyz", "0 0 1\n1 2 nan\n3 4 5\n", "a.xyz:2: ");
}
TEST_F(CliErrors, Infinity) {
  expect_bad("a.xyz", "0 0 1\ninf 2 1\n3 4 5\n", "a.xyz:2: ");
}
TEST_F(CliErrors, EmptyFile) {
  expect_bad("a.xyz", "", "a.xyz");
}
TEST_F(CliErrors, OnePoint) {
  expect_bad("a.xyz", "0 0 1\n", "a.xyz: ");
}
TEST_F(CliErrors, TwoPoints) {
  expect_bad("a.xyz", "0 0 1\n1 2 3\n", "a.xyz: ");
}
TEST_F(CliErrors, OnePlaceManyTimes) {
  expect_bad("a.xyz", "0 0 1\n0 0 2\n0 0 3\n1 1 1\n", "a.xyz: ");
}
TEST_F(CliErrors, AllCollinear) {
  expect_bad("a.xyz", "0 0 1\n1 2 3\n2 4 5\n3 6 7\n", "a.xyz: ");
}
TEST_F(CliErrors, BinaryJunk) {
  std::string junk;
  for (int i = 0; i < 4096; ++i) junk += static_cast<char>((i * 7919 + 13) % 256);
  for (const char* name : {"a.xyz", "a.csv", "a.asc", "a.ply", "a.obj", "a.2dm"})
    expect_bad(name, junk, name);
}
TEST_F(CliErrors, TruncatedPly) {
  write_good();
  ASSERT_EQ(run({"build", "good.xyz", "-o", "whole.ply"}).code, 0);
  const std::string whole = read("whole.ply");
  write("cut.ply", whole.substr(0, whole.size() - 5));
  expect_error({"check", "cut.ply"}, 3, "cut.ply");
  expect_bad("shorter.ply", whole.substr(0, whole.size() - 60), "shorter.ply");
  expect_bad("header.ply", whole.substr(0, 40), "header.ply");
}
TEST_F(CliErrors, TruncatedGrid) {
  expect_bad("a.asc", "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 10\n1 2 3\n4 5\n", "a.asc");
  expect_error({"sample", "a.asc", "-n", "1", "--seed", "1", "-o", "out.xyz"}, 3, "a.asc");
  expect_error({"info", "a.asc"}, 3, "a.asc");
}
TEST_F(CliErrors, FaceIndexOutOfRange) {
  write("a.obj", "v 0 0 1\nv 1 0 1\nv 0 1 1\nf 1 2 4\n");
  expect_error({"check", "a.obj"}, 3, "a.obj:4: ");
}
TEST_F(CliErrors, NegativeOrder) {
  write_good();
  for (const char* command : {"build", "edges", "sweep"}) {
    expect_error({command, "good.xyz", "-k", "-1"}, 2, "-1");
    expect_error({command, "good.xyz", "-k=-1"}, 2, "-1");
  }
  expect_error({"check", "good.xyz", "-k", "-1"}, 2, "-1");
  expect_error({"build", "good.xyz", "-k", "2.5"}, 2, "2.5");
  expect_error({"build", "good.xyz", "-k", "99999999999999999999"}, 2, "99999999999999999999");
}
TEST_F(CliErrors, UnknownWords) {
  write_good();
  expect_error({"build", "good.xyz", "-m", "magic"}, 2, "magic");
  expect_error({"build", "good.xyz", "--duplicates", "both"}, 2, "both");
  expect_error({"build", "good.xyz", "--progress", "loud"}, 2, "loud");
  expect_error({"build", "good.xyz", "--max-memory", "much"}, 2, "much");
  expect_error({"build", "good.xyz", "--nodata", "none"}, 2, "none");
  expect_error({"build", "good.xyz", "--threads", "many"}, 2, "many");
  expect_error({"build", "good.xyz", "--no-such-option"}, 2, "--no-such-option");
  expect_error({"bild", "good.xyz"}, 2, "bild");
  expect_error({}, 2, "thalweg --help");
  expect_error({"build"}, 2, "POINTS");
  expect_error({"build", "good.xyz", "-o"}, 2, "output");
}
TEST_F(CliErrors, UnknownSuffix) {
  write_good();
  expect_error({"build", "good.xyz", "-o", "out.stl"}, 2, "out.stl");
  expect_error({"build", "good.xyz", "-o", "out"}, 2, "out");
  expect_error({"build", "good.xyz", "-o", "out.geojson"}, 2, "out.geojson");
  expect_error({"build", "good.xyz", "--pits", "pits.ply"}, 2, "pits.ply");
  expect_error({"build", "good.xyz", "-o", "-"}, 2, "--to");
  write("points.tif", "0 0 1\n");
  expect_error({"build", "points.tif"}, 2, "points.tif");
}
TEST_F(CliErrors, UnreadableFile) {
  expect_error({"build", "absent.xyz", "-o", "out.ply"}, 3, "absent.xyz: ");
  std::filesystem::create_directory(path("folder.xyz"));
  expect_error({"build", "folder.xyz", "-o", "out.ply"}, 3, "folder.xyz: ");
  expect_error({"check", "absent.ply"}, 3, "absent.ply: ");
  expect_error({"info", "absent.ply"}, 3, "absent.ply: ");
}
TEST_F(CliErrors, FullDisk) {
  write_good();
  expect_error({"build", "good.xyz", "-o", "out.obj", "-o", "/dev/full", "--to", "obj"}, 6, "/dev/full");
  expect_error({"build", "good.xyz", "-o", "out.obj", "--json", "/dev/full"}, 6, "/dev/full");
}
TEST_F(CliErrors, OutputInNoFolder) {
  write_good();
  expect_error({"build", "good.xyz", "-o", "nowhere/out.ply"}, 6, "nowhere/out.ply");
}
TEST_F(CliErrors, ExistingOutputIsKept) {
  write_good();
  for (const char* name : {"out.ply", "out.json", "out.csv"}) write(name, "precious");
  expect_error({"build", "good.xyz", "-o", "out.ply"}, 6, "--overwrite");
  expect_error({"build", "good.xyz", "-o", "new.ply", "--json", "out.json"}, 6, "out.json");
  expect_error({"build", "good.xyz", "-o", "new.ply", "--pits", "out.csv"}, 6, "out.csv");
  expect_error({"edges", "good.xyz", "-k", "1", "-o", "out.csv"}, 6, "out.csv");
  for (const char* name : {"out.ply", "out.json", "out.csv"}) EXPECT_EQ(read(name), "precious");
  EXPECT_EQ(run({"build", "good.xyz", "-o", "out.ply", "--overwrite"}).code, 0);
  EXPECT_NE(read("out.ply"), "precious");
}
TEST_F(CliErrors, ExistingOutputIsFoundBeforeAnyWork) {
  write("bad.xyz", "not even a point\n");
  write("out.ply", "precious");
  expect_error({"build", "bad.xyz", "-o", "out.ply"}, 6, "out.ply");
}
TEST_F(CliErrors, BadInputLeavesTheOldOutput) {
  write("bad.xyz", "not even a point\n");
  write("out.ply", "precious");
  expect_error({"build", "bad.xyz", "-o", "out.ply", "--overwrite"}, 3, "bad.xyz");
  EXPECT_EQ(read("out.ply"), "precious");
}
TEST_F(CliErrors, OneFileForTwoOutputs) {
  write_good();
  expect_error({"build", "good.xyz", "-o", "out.ply", "-o", "./out.ply"}, 2, "out.ply");
  expect_error({"build", "good.xyz", "-o", "out.csv", "--pits", "out.csv"}, 2, "out.csv");
  expect_error({"build", "good.xyz", "-o", "-", "--to", "ply", "--json", "-"}, 2, "stdout");
  expect_error({"build", "good.xyz", "-o", "-", "-o", "-", "--to", "ply"}, 2, "stdout");
}
TEST_F(CliErrors, OutputOverTheInput) {
  write_good();
  expect_error({"build", "good.xyz", "-o", "good.xyz", "--overwrite"}, 2, "good.xyz");
}
TEST_F(CliErrors, HelpAndVersionAreNoErrors) {
  EXPECT_EQ(run({"--version"}).out.rfind("thalweg ", 0), 0u);
  for (const char* command : {"build", "check", "edges", "sweep", "sample", "info"}) {
    const Outcome help = run({command, "--help"});
    EXPECT_EQ(help.code, 0);
    EXPECT_EQ(help.err, "");
    EXPECT_NE(help.out.find(std::string("Usage: thalweg ") + command), std::string::npos) << help.out;
    EXPECT_NE(help.out.find("Examples:\n"), std::string::npos) << help.out;
  }
  EXPECT_EQ(run({"--help"}).code, 0);
}

}  // namespace
}  // namespace thalweg::test
