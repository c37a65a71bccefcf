/// The binary formats through the command: the same terrain, bit for bit, whatever file the points came from.
#include <tuple>

#include "cli/command.hpp"

namespace thalweg::test {
namespace {

class CliBinaryFiles : public CommandTest {
 protected:
  void expect_done(const std::vector<std::string>& arguments, const std::string& input = "") const {
    const Outcome outcome = run(arguments, input);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
  }
};

/// Places that rounding or careless parsing would merge or lose.
constexpr const char* kHard =
    "0 0 -0\n1e308 0 5e-324\n0 1e308 -5e-324\n-1e308 -1e308 1e308\n0.1 0.2 0.30000000000000004\n5e-324 1 2\n"
    "-0 3 -1e-300\n";

TEST_F(CliBinaryFiles, RoundTripsAreBitForBit) {
  write("a.xyz", kHard);
  expect_done({"build", "a.xyz", "-o", "a.tlw", "-o", "a.ply", "-o", "back.xyz"});
  expect_done({"build", "a.tlw", "-o", "b.tlw", "-o", "b.ply", "-o", "again.xyz"});
  EXPECT_EQ(read("a.tlw"), read("b.tlw"));
  EXPECT_EQ(read("a.ply"), read("b.ply"));
  EXPECT_EQ(read("back.xyz"), read("again.xyz"));
  expect_done({"check", "a.tlw", "-k", "8", "--points", "a.xyz"});
  expect_done({"check", "a.ply", "-k", "8", "--points", "a.tlw"});
}

TEST_F(CliBinaryFiles, EveryCommandTakesThem) {
  for (const char* file : {"p.xyz", "p.tlw", "p.npy"})
    expect_done({"generate", "fractal", "-n", "300", "--seed", "5", "-o", file});
  for (const char* file : {"p.tlw", "p.npy"}) {
    const std::string name = file;
    for (const auto& [command, options, out] :
         {std::tuple{"build", std::vector<std::string>{"-k", "4"}, "ply"},
          std::tuple{"edges", std::vector<std::string>{"-k", "2"}, "csv"},
          std::tuple{"voronoi", std::vector<std::string>{"-k", "2"}, "geojson"}}) {
      for (const std::string& input : {std::string("p.xyz"), name}) {
        std::vector<std::string> arguments = {command, input, "--overwrite", "-o", input + "." + out};
        arguments.insert(arguments.end(), options.begin(), options.end());
        expect_done(arguments);
      }
      EXPECT_EQ(read(name + "." + out), read(std::string("p.xyz.") + out)) << command;
    }
    expect_done({"sweep", file, "-k", "0..1"});
    expect_done({"build", "-", "-o", "stdin.ply", "-k", "4", "--overwrite"}, read(name));
    EXPECT_EQ(read("stdin.ply"), read("p.xyz.ply"));
    EXPECT_EQ(run_json({"info", file})["points"], 300);
  }
  EXPECT_EQ(run_json({"info", "p.tlw"})["input"]["kind"], "points");
  expect_done({"build", "p.tlw", "-o", "mesh.tlw", "-o", "mesh.npy", "-k", "4"});
  const Json mesh = run_json({"info", "mesh.tlw"});
  EXPECT_EQ(mesh["input"]["kind"], "mesh");
  EXPECT_EQ(read("mesh.npy").size(), 128 + 12 * mesh["triangles"].get<std::size_t>());
  expect_done(
      {"sample", data("jacksboro_fault.asc"), "-n", "50", "--seed", "1", "-o", "s.tlw", "-o", "s.npy"});
  EXPECT_EQ(run_json({"info", "s.npy"})["extent"], run_json({"info", "s.tlw"})["extent"]);
}

TEST_F(CliBinaryFiles, ThreadsChangeNeitherBytesNorErrors) {
  std::string text = noise(40000, 9);
  write("a.xyz", text);
  for (const char* threads : {"1", "2", "7"}) {
    const std::string name = std::string("t") + threads;
    expect_done({"build", "a.xyz", "-m", "delaunay", "--threads", threads, "-o", name + ".tlw", "-o",
                 name + ".obj", "-o", name + ".csv", "-o", name + ".2dm"});
    for (const char* suffix : {".tlw", ".obj", ".csv", ".2dm"})
      EXPECT_EQ(read(name + suffix), read(std::string("t1") + suffix));
  }
  text.insert(text.find('\n', text.size() / 2), " 1,5\n1 2 x");
  write("bad.xyz", text);
  const std::string message = run({"build", "bad.xyz", "--threads", "1"}).err;
  EXPECT_NE(message.find("column 3 (z) \"x\" is not a number"), std::string::npos) << message;
  for (const char* threads : {"2", "7"})
    EXPECT_EQ(run({"build", "bad.xyz", "--threads", threads}).err, message);
}

TEST_F(CliBinaryFiles, MorePointsThanFitAreRefusedBeforeMemoryIsTaken) {
  std::string header("\x89TLW\r\n\x1a\n\1\0\0\0\4\3\2\1\0\0\0\x20\0\0\0\0", 24);
  write("many.tlw", header + std::string(16, '\0'));
  const Outcome outcome = run({"build", "many.tlw", "-o", "a.ply"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_NE(outcome.err.find("536870912 points or more, and 32-bit ids allow 536870911"), std::string::npos)
      << outcome.err;
}

}  // namespace
}  // namespace thalweg::test
