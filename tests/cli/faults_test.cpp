/// A machine that gives out while the command runs: memory, disk, readers of its output, patience. The old
/// output is there, or the new one as a whole, nothing else is, and the exit code says which.
#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <thread>

#include "cli/command.hpp"
#include "cli/random.hpp"
#include "support/sanitized.hpp"

namespace thalweg::test {
namespace {

using Words = std::vector<std::string>;

const Words kBuild = {"build", "points.xyz", "-m", "hull", "-k", "4", "--overwrite", "-q", "-o", "out.ply"};

std::function<void()> limit(int resource, rlim_t most) {
  return [resource, most] {
    const rlimit both = {most, most};
    setrlimit(static_cast<decltype(RLIMIT_AS)>(resource), &both);
  };
}

class CliFaults : public CommandTest {
 protected:
  /// Makes the points, what becomes of them, and an old output.
  void prepare(std::uint64_t points) {
    write("points.xyz", noise(points, 50));
    EXPECT_EQ(run(kBuild).code, 0);
    whole_ = read("out.ply");
    put_old();
  }
  void put_old() const {
    std::filesystem::remove(path("out.ply"));
    write("out.ply", "old");
  }
  Outcome run_prepared(const Words& arguments, const std::function<void()>& before) const {
    Process process(folder(), arguments, "", before);
    process.close_input();
    return process.finish();
  }
  /// Code 0 and the new output, or `code` and the old one; in both cases no other file.
  void expect_old_or_new(const Outcome& outcome, int code) const {
    EXPECT_TRUE(outcome.code == 0 || outcome.code == code) << outcome.code << " " << outcome.err;
    EXPECT_TRUE(read("out.ply") == (outcome.code == 0 ? whole_ : "old")) << outcome.code;
    EXPECT_EQ(files(), (Words{"out.ply", "points.xyz"}));
  }

  std::string whole_;
};

TEST_F(CliFaults, LittleMemory) {
  if (kSanitized) GTEST_SKIP() << "sanitizers reserve more addresses than there is memory";
  prepare(20000);
  constexpr rlim_t kStep = rlim_t{1} << 20;
  rlim_t least = 4 * kStep;  // that the loader needs
  while (run_prepared({"--version"}, limit(RLIMIT_AS, least)).code != 0) least += kStep;
  int refused = 0, done = 0;
  for (rlim_t more = 0; done < 3 && more < 400; more += 1 + more / 8) {
    SCOPED_TRACE(std::to_string(more) + " MiB more than nothing needs");
    const Outcome outcome = run_prepared(kBuild, limit(RLIMIT_AS, least + more * kStep));
    expect_old_or_new(outcome, 5);
    if (outcome.code == 5) {
      EXPECT_EQ(outcome.err.rfind("thalweg: error: out of memory", 0), 0u) << outcome.err;
    }
    ++(outcome.code == 0 ? done : refused);
    if (outcome.code == 0) put_old();
  }
  EXPECT_GT(refused, 3);
  EXPECT_EQ(done, 3);
}

/// A limit on the size of files stops a write half-way as a full disk does, and sends a signal besides.
TEST_F(CliFaults, LittleDisk) {
  prepare(3000);
  const rlim_t size = whole_.size();
  for (const rlim_t most : {rlim_t{0}, rlim_t{1}, rlim_t{4096}, size / 2, size - 1}) {
    const Outcome outcome = run_prepared(kBuild, limit(RLIMIT_FSIZE, most));
    EXPECT_EQ(outcome.code, 6) << outcome.err;
    EXPECT_NE(outcome.err.find("out.ply: cannot be written: "), std::string::npos) << outcome.err;
    expect_old_or_new(outcome, 6);
  }
  expect_old_or_new(run_prepared(kBuild, limit(RLIMIT_FSIZE, size)), 0);
}

/// What is closed is not filled by the output: messages would be written into it.
TEST_F(CliFaults, ClosedStreams) {
  prepare(300);
  for (int closed = 1; closed < 8; ++closed) {
    SCOPED_TRACE(closed);
    put_old();
    Words arguments = kBuild;
    arguments[7] = "-v";  // much is said
    const Outcome outcome = run_prepared(arguments, [closed] {
      for (int stream = 0; stream < 3; ++stream) {
        if ((closed >> stream & 1) != 0) ::close(stream);
      }
    });
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    expect_old_or_new(outcome, 0);
  }
  const auto closed_stdout = [] { ::close(STDOUT_FILENO); };
  for (const Words& arguments : {Words{"build", "points.xyz", "-m", "delaunay", "-o", "-", "--to", "ply"},
                                 Words{"--version"}, Words{"--help"}}) {
    EXPECT_EQ(run_prepared(arguments, closed_stdout).code, 6) << arguments[0];
  }
  EXPECT_EQ(run_prepared({"build", "-", "-o", "new.ply"}, [] { ::close(STDIN_FILENO); }).code, 3);
  EXPECT_FALSE(exists("new.ply"));
}

/// `| head` with each command that writes to stdout.
TEST_F(CliFaults, ReadersThatLeave) {
  prepare(20000);
  write("queries.xy", "1 2\n3 4\n");
  for (const Words& arguments :
       {Words{"build", "points.xyz", "-q", "-m", "delaunay", "--json", "-"},
        Words{"build", "points.xyz", "-q", "-m", "delaunay", "-o", "-", "--to", "obj"},
        Words{"edges", "points.xyz", "-q", "-k", "1", "-o", "-"},
        Words{"sweep", "points.xyz", "-q", "-k", "0..1", "--json", "-"},
        Words{"generate", "fractal", "-n", "20000", "--seed", "1", "-q", "-o", "-", "--to", "xyz"},
        Words{"voronoi", "points.xyz", "-q", "-k", "1", "--query", "queries.xy", "-o", "-"}}) {
    Process process(folder(), arguments);
    process.close_input();
    process.close_output();
    const Outcome outcome = process.finish();
    EXPECT_EQ(outcome.code, 6) << arguments[0] << " " << outcome.err;
    EXPECT_EQ(outcome.err, "") << arguments[0];
  }
}

/// Signals at any moment between the first look at the input and the end, one or two of them.
TEST_F(CliFaults, SignalsAtRandomMoments) {
  prepare(20000);
  Words arguments = kBuild;
  arguments[7] = "--threads=2";
  arguments.insert(arguments.end(), {"--progress", "bar"});
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(run(arguments).code, 0);
  const auto whole_run = std::chrono::steady_clock::now() - start;
  const char* const asked = std::getenv("THALWEG_SIGNAL_RUNS");
  const long runs = asked != nullptr ? std::atol(asked) : 25;
  cli::Random random(9);
  for (long i = 0; i < runs && !HasFailure(); ++i) {
    put_old();
    Process process(folder(), arguments);
    process.close_input();
    if (!process.await_error("reading")) ADD_FAILURE() << "no progress";
    for (std::uint64_t signals = 1 + random.below(2); signals > 0; --signals) {
      std::this_thread::sleep_for(whole_run * static_cast<long>(random.below(1000)) / 900);
      process.send(random.below(2) == 0 ? SIGINT : SIGTERM);
    }
    expect_old_or_new(process.finish(), 130);
  }
}

}  // namespace
}  // namespace thalweg::test
