/// Damaged files of every format: a reader may refuse them or not, but never crashes, never gives back what
/// breaks its contract, and never asks for more memory than a small multiple of the file.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "io/grid.hpp"
#include "io/mesh_file.hpp"
#include "io/point_table.hpp"
#include "io/random.hpp"
#include "io/write_mesh.hpp"
#include "support/allocation_watch.hpp"
#include "support/io_support.hpp"

namespace thalweg::io {
namespace {

std::string damaged(const std::string& good, Random& random) {
  static const std::string kNasty = "0123456789999-+.eE \n\r\t,;#\"\xff\x7f/nvf";
  std::string out = good;
  for (std::uint64_t edits = 1 + random.below(6); edits > 0 && !out.empty(); --edits) {
    const std::size_t at = random.below(out.size());
    switch (random.below(6)) {
      case 0:
        out[at] = static_cast<char>(random.below(256));
        break;
      case 1:
        out[at] = kNasty[random.below(kNasty.size())];
        break;
      case 2:
        out.insert(at, 1, kNasty[random.below(kNasty.size())]);
        break;
      case 3:
        out.erase(at, 1 + random.below(8));
        break;
      case 4:
        out.insert(at, out.substr(random.below(out.size()), random.below(40)));
        break;
      default:
        out[at] = static_cast<char>(out[at] ^ 1 << random.below(8));
        break;
    }
  }
  if (random.below(4) == 0) out.resize(random.below(out.size() + 1));
  return out;
}

bool finite(const std::vector<Point3>& points) {
  for (const Point3& p : points) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) return false;
  }
  return true;
}

void expect_sound_message(const Error& error, const std::string& path) {
  EXPECT_TRUE(error.message.starts_with(path + ":")) << error.message;
  EXPECT_LT(error.message.size(), path.size() + 1200);
  for (const char c : error.message) EXPECT_TRUE(static_cast<unsigned char>(c) >= 0x20) << error.message;
}

void read_every_way(const std::string& path) {
  if (const auto table = read_points(path, {.threads = 2})) {
    EXPECT_TRUE(finite(table->points));
    EXPECT_FALSE(table->points.empty());
  } else {
    expect_sound_message(table.error(), path);
  }
  if (const auto mesh = read_mesh(path)) {
    EXPECT_TRUE(finite(mesh->points));
    for (const IndexTriangle& t : mesh->triangles) {
      for (const std::uint32_t v : t) EXPECT_LT(v, mesh->points.size());
    }
  } else {
    expect_sound_message(mesh.error(), path);
  }
  if (const auto grid = read_grid(path)) {
    EXPECT_EQ(grid->values.size(), std::size_t{grid->columns} * grid->rows);
    EXPECT_EQ(grid->x.size(), grid->columns);
    EXPECT_EQ(grid->y.size(), grid->rows);
  } else {
    expect_sound_message(grid.error(), path);
  }
}

void damage_and_read(const std::string& name, const std::string& good) {
  const test::ScratchFolder folder;
  constexpr std::size_t kFixed = 300000;  // buffers of the reader and of the stream that writes the file
  Random random(1);
  for (int i = 0; i < 400; ++i) {
    const std::string content = i == 0 ? good : damaged(good, random);
    const std::string path = folder.put(name, content);
    test::reset_largest_allocation();
    read_every_way(path);
    EXPECT_LT(test::largest_allocation(), kFixed + 40 * content.size()) << content;
    if (testing::Test::HasFailure()) {
      ADD_FAILURE() << "round " << i << " of " << name << ":\n" << content;
      return;
    }
  }
}

std::string small_mesh(Format format) {
  const test::ScratchFolder folder;
  const std::vector<Point3> points = {{0, 0, 1}, {1, 0, 2}, {0, 1, 3.5}, {1, 1, -4}, {0.5, 0.25, 1e-7}};
  const std::vector<IndexTriangle> triangles = {{0, 1, 4}, {1, 3, 4}, {3, 2, 4}, {2, 0, 4}};
  const std::vector<std::uint8_t> pit = {0, 0, 0, 1, 0};
  const std::vector<std::uint32_t> order = {0, 1, 2, 0};
  auto file = OutputFile::open(folder / "m");
  EXPECT_FALSE(write_mesh(*file, {points, triangles, pit, order, "EPSG:2056"}, format));
  EXPECT_FALSE(file->commit());
  return test::content_of(folder / "m");
}

TEST(Corruption, OfArrays) {
  damage_and_read("t.npy", small_mesh(Format::npy));
}

TEST(Corruption, OfTables) {
  damage_and_read("p.xyz", "# a comment\n1 2 3\n4.5 -6 7e2\n0.1 0.2 0.3\n1e-300 2 -0\n");
  damage_and_read("p.csv", "id,x,y,z\na,1,2,3\n\"b,c\",4.5,-6,\"7e2\"\nd,0.1,0.2,0.3\n");
}

TEST(Corruption, OfGrids) {
  damage_and_read(
      "g.asc",
      "ncols 4\nnrows 3\nxllcorner 100\nyllcorner 200.5\ncellsize 10\nNODATA_value -9999\n1 2 3 4\n"
      "5 6 -9999 8\n9 10 11 12.5\n");
}

TEST(Corruption, OfMeshes) {
  damage_and_read("m.obj", small_mesh(Format::obj));
  damage_and_read("m.2dm", small_mesh(Format::two_dm));
  damage_and_read("a.ply", small_mesh(Format::ply_ascii));
  damage_and_read("m.ply", small_mesh(Format::ply));
  std::string big = small_mesh(Format::ply);  // nonsense as content, but a walk through the other byte order
  big.replace(big.find("little"), 6, "big");
  damage_and_read("b.ply", big);
  damage_and_read("m.tlw", small_mesh(Format::tlw));
}

// Binary files have few bytes that do not matter, so all of them can be tried.
TEST(Corruption, OfEveryByteAndEveryLengthOfBinaryFiles) {
  const test::ScratchFolder folder;
  for (const auto& [name, format] : {std::pair("m.tlw", Format::tlw), std::pair("t.npy", Format::npy)}) {
    const std::string good = small_mesh(format);
    for (std::size_t at = 0; at < good.size() && !testing::Test::HasFailure(); ++at) {
      read_every_way(folder.put(name, good.substr(0, at)));
      EXPECT_FALSE(read_points(folder / name)) << at;
      for (const int flip : {1, 0x80, 0xff}) {
        std::string changed = good;
        changed[at] = static_cast<char>(changed[at] ^ flip);
        test::reset_largest_allocation();
        read_every_way(folder.put(name, changed));
        EXPECT_LT(test::largest_allocation(), 300000u) << at;
      }
    }
  }
}

}  // namespace
}  // namespace thalweg::io
