/// Inputs that are no points: with the name of every format, with its first bytes or without, short and
/// long. The command refuses what cannot be read, soon, and in memory that is a small multiple of what it
/// reads. THALWEG_GARBAGE_BYTES adds a size to those tried, a gigabyte say.
#include <sys/resource.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "cli/command.hpp"
#include "cli/random.hpp"
#include "support/sanitized.hpp"

namespace thalweg::test {
namespace {

/// Peak memory is at most kMultiple times the size of the input, and kFixed for the command itself.
constexpr std::uint64_t kMultiple = 40;  // a header that never ends: 16 bytes a field, in vectors that grow
constexpr std::uint64_t kFixed = std::uint64_t{48} << 20;

struct Kind {
  const char* name;
  std::string (*next)(cli::Random& random);  ///< a piece of it
};

const Kind kKinds[] = {
    {"zeros", [](cli::Random&) { return std::string(64, '\0'); }},
    {"ones", [](cli::Random&) { return std::string(64, '\xff'); }},
    {"bytes", [](cli::Random& random) { return std::string(1, static_cast<char>(random.below(256))); }},
    {"characters",
     [](cli::Random& random) { return std::string(1, static_cast<char>(' ' + random.below(95))); }},
    {"one endless number", [](cli::Random&) { return std::string(64, '7'); }},
    {"one endless line", [](cli::Random&) { return std::string("12 -3.5 1e9 "); }},
    {"empty lines", [](cli::Random&) { return std::string(64, '\n'); }},
    {"one point again and again", [](cli::Random&) { return std::string("4 5 6\n"); }},
    {"open quotes", [](cli::Random&) { return std::string("\"a,"); }},
};

struct Guise {
  const char* suffix;
  std::string beginning;
};

const Guise kGuises[] = {
    {"xyz", "0 0 1\n1 0 2\n"},
    {"csv", "x,y,z\n0,0,1\n"},
    {"asc", "ncols 60000\nnrows 60000\nxllcorner 0\nyllcorner 0\ncellsize 1\n"},
    {"ply",
     "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty double x\nproperty double y\n"
     "property double z\nelement face 4000000000\nproperty list uint uint vertex_indices\nend_header\n"},
    {"ply",
     "ply\nformat ascii 1.0\nelement vertex 3000000000\nproperty float x\nproperty float y\nproperty float "
     "z\n"
     "end_header\n"},
    {"obj", "v 0 0 1\nv 1 0 2\nv 0 1 3\nf 1 2 3\n"},
    {"2dm", "MESH2D\nND 1 0 0 1\n"},
    {"npy", std::string("\x93NUMPY\x01\x00\x76\x00", 10) +
                "{'descr': '<f8', 'fortran_order': False, 'shape': (900000000000, 3), }" +
                std::string(47, ' ') + "\n"},
    {"tlw", "THALWEG\n"},
};

std::string garbage(const Kind& kind, const Guise& guise, bool disguised, std::size_t size,
                    cli::Random& random) {
  std::string text = disguised ? guise.beginning : "";
  std::string block;
  while (block.size() < std::min<std::size_t>(size, 1 << 16)) block += kind.next(random);
  while (text.size() < size && !block.empty()) text.append(block, 0, size - text.size());
  return text;
}

class CliGarbage : public CommandTest {
 protected:
  void expect_refusal(const std::vector<std::string>& arguments, std::uint64_t size, bool disguised) const {
    // Processor time, not that of the clock: others may be busy.
    Process process(folder(), arguments, "", [size] {
      const rlim_t seconds = 20 + size / 5000000;
      const rlimit both = {seconds, seconds};
      setrlimit(RLIMIT_CPU, &both);
    });
    process.close_input();
    const Outcome outcome = process.finish();
    // Behind a sound beginning some formats allow lines of any kind.
    const bool accepted = disguised && (outcome.code == 0 || outcome.code == 4);
    EXPECT_TRUE(accepted || outcome.code == 3) << outcome.code << " " << outcome.err;
    EXPECT_TRUE(accepted || outcome.err.find("thalweg: error: ") != std::string::npos) << outcome.err;
    EXPECT_TRUE(accepted || !exists("out.obj"));
    std::filesystem::remove(path("out.obj"));
    EXPECT_LT(outcome.err.size(), 2000u);
    if (kSanitized) return;
    EXPECT_LT(static_cast<std::uint64_t>(outcome.peak_kilobytes) * 1024, kFixed + kMultiple * size);
  }
};

TEST_F(CliGarbage, IsRefusedInLittleMemory) {
  cli::Random random(8);
  std::vector<std::uint64_t> sizes = {0, 300000};
  if (const char* more = std::getenv("THALWEG_GARBAGE_BYTES"))
    sizes.push_back(std::strtoull(more, nullptr, 10));
  bool disguised = false;
  for (const std::uint64_t size : sizes) {
    for (const Guise& guise : kGuises) {
      for (const Kind& kind : kKinds) {
        const std::uint64_t bytes = size == 0 ? random.below(3000) : size;
        disguised = !disguised;  // an odd number of kinds: each comes with every beginning, and without
        SCOPED_TRACE(std::to_string(bytes) + " bytes of " + kind.name + " as " + guise.suffix +
                     (disguised ? " with its beginning" : ""));
        const std::string name = std::string("garbage.") + guise.suffix;
        std::filesystem::remove(path(name));
        write(name, garbage(kind, guise, disguised, bytes, random));
        const bool mesh = guise.suffix == std::string("obj") || random.below(3) == 0;
        if (mesh) {
          expect_refusal({"check", name}, bytes, disguised);
        } else {
          expect_refusal({"build", name, "-m", "delaunay", "-o", "out.obj"}, bytes, disguised);
        }
        if (HasFailure()) return;
      }
    }
  }
}

}  // namespace
}  // namespace thalweg::test
