/// A disk that is really full, at any moment of a run: a small file system in memory, for which root is
/// needed. Each output is the old one or the new one as a whole, and nothing else is left.
#include <fcntl.h>
#include <sched.h>
#include <sys/mount.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "cli/command.hpp"

namespace thalweg::test {
namespace {

using Words = std::vector<std::string>;
constexpr std::size_t kPage = 4096;
constexpr std::size_t kDiskPages = 64;

/// Runs in a name space of its own for mounts, so that none outlives the process.
bool mount_disk(const std::string& folder) {
  const std::string size = "size=" + std::to_string(kPage * kDiskPages);
  return ::unshare(CLONE_NEWNS) == 0 && ::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
         ::mount("none", folder.c_str(), "tmpfs", 0, size.c_str()) == 0;
}

class CliFullDisk : public CommandTest {
 protected:
  void SetUp() override {
    std::filesystem::create_directory(path("disk"));
    mounted_ = mount_disk(path("disk"));
    if (!mounted_) GTEST_SKIP() << "may not mount a file system here";
    write("points.xyz", noise(500, 50));
  }
  void TearDown() override {
    if (mounted_) {
      EXPECT_EQ(::umount2(path("disk").c_str(), MNT_DETACH), 0);
    }
  }

  /// Leaves `pages` of the disk to the next run.
  void leave(std::size_t pages) const {
    write("disk/ballast", "");
    const std::size_t left = std::filesystem::space(path("disk")).available / kPage;
    ASSERT_GE(left, pages);
    write("disk/ballast", std::string((left - pages) * kPage, 'b'));
    ASSERT_EQ(std::filesystem::space(path("disk")).available, pages * kPage);
  }
  std::vector<std::string> on_disk() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(path("disk"))) {
      names.push_back(entry.path().filename().string());
    }
    std::ranges::sort(names);
    return names;
  }
  /// With a stream that ends on the full disk.
  Outcome run_into(const std::string& file, int stream, const Words& arguments) const {
    const std::string target = path(file);
    write(file, "");
    leave(0);
    Process process(folder(), arguments, "",
                    [&target, stream] { ::dup2(::open(target.c_str(), O_WRONLY | O_TRUNC), stream); });
    process.close_input();
    return process.finish();
  }
  void expect_refused(const Outcome& outcome) const {
    EXPECT_EQ(outcome.code, 6) << outcome.err;
    EXPECT_NE(outcome.err.find("cannot be written: No space left on device"), std::string::npos)
        << outcome.err;
  }

 private:
  bool mounted_ = false;
};

TEST_F(CliFullDisk, EveryOutputIsTheOldOneOrTheNewOne) {
  const Words build = {"build", "points.xyz",   "-q",     "--overwrite",   "-o",     "disk/out.obj",
                       "-o",    "disk/out.ply", "--pits", "disk/pits.csv", "--json", "disk/out.json"};
  const Words outputs = {"out.json", "out.obj", "out.ply", "pits.csv"};
  int refused = 0, done = 0;
  for (std::size_t pages = 0; done < 2 && pages <= kDiskPages; ++pages) {
    SCOPED_TRACE(std::to_string(pages) + " pages left");
    for (const std::string& name : outputs) write("disk/" + name, "");  // takes no page
    leave(pages);
    const Outcome outcome = run(build);
    ++(outcome.code == 0 ? done : refused);
    if (outcome.code != 0) expect_refused(outcome);
    for (const std::string& name : outputs)
      EXPECT_EQ(read("disk/" + name).empty(), outcome.code != 0) << name;
    EXPECT_EQ(on_disk(), (Words{"ballast", "out.json", "out.obj", "out.ply", "pits.csv"}));
  }
  EXPECT_GT(refused, 5);
  EXPECT_EQ(done, 2);
}

TEST_F(CliFullDisk, StdoutTellsOfIt) {
  write("queries.xy", "1 2\n3 4\n");
  for (const Words& arguments :
       {Words{"build", "points.xyz", "-q", "-o", "-", "--to", "obj"},
        Words{"build", "points.xyz", "-q", "--json", "-"},
        Words{"edges", "points.xyz", "-q", "-k", "2", "-o", "-"},
        Words{"voronoi", "points.xyz", "-q", "-k", "3", "--query", "queries.xy", "-o", "-"},
        Words{"generate", "fractal", "-n", "2000", "-q", "-o", "-", "--to", "xyz"}}) {
    SCOPED_TRACE(arguments[0]);
    expect_refused(run_into("disk/out", STDOUT_FILENO, arguments));
  }
  for (const char* question : {"--help", "--version"}) {
    EXPECT_EQ(run_into("disk/out", STDOUT_FILENO, {question}).code, 6) << question;
  }
}

/// Messages are no output: where they cannot be written they are lost, and nothing else is.
TEST_F(CliFullDisk, MessagesMayBeLost) {
  const Words build = {"build", "points.xyz", "-v", "-o", "out.ply"};
  EXPECT_EQ(run_into("disk/messages", STDERR_FILENO, build).code, 0);
  EXPECT_EQ(read("disk/messages"), "");
  EXPECT_EQ(run({"check", "out.ply", "--points", "points.xyz"}).code, 0);
}

}  // namespace
}  // namespace thalweg::test
