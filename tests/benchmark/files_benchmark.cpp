/// Reading and writing: rows of x y z, and binary PLY with the Delaunay triangles. The files lie in a folder
/// of their own under that for temporary files, and are read from the system's cache.
#include <stdlib.h>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "benchmark/run.hpp"
#include "io/point_table.hpp"
#include "io/write_mesh.hpp"
#include "thalweg/delaunay.hpp"

namespace {

namespace io = thalweg::io;
using bench::SetOfSites;
using thalweg::Point2;
using thalweg::Point3;

/// Made when first used, removed at the end.
class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "thalweg_XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = name;
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }

  static std::string path_of(const SetOfSites& set, const std::string& suffix) {
    static const Folder folder;
    std::string name = set.label();
    name.replace(name.find('/'), 1, "_");
    return (folder.path_ / (name + suffix)).string();
  }

 private:
  std::filesystem::path path_;
};

/// Points with their Delaunay triangles, as a writer takes them.
class Mesh {
 public:
  explicit Mesh(const SetOfSites& set) : points_(bench::terrain(set)) {
    std::vector<Point2> places;
    places.reserve(points_.size());
    for (const Point3& p : points_) places.push_back({p.x, p.y});
    const auto mesh = thalweg::delaunay(places);
    if (!mesh) throw std::runtime_error(mesh.error().message);
    triangles_.reserve(mesh->face_count());
    for (std::uint32_t f = 0; f < mesh->face_count(); ++f) {
      const auto [a, b, c] = mesh->corners(thalweg::FaceId(f));
      triangles_.push_back({a.index(), b.index(), c.index()});
    }
  }

  io::MeshView view() const {
    io::MeshView view;
    view.points = points_;
    view.triangles = triangles_;
    return view;
  }

 private:
  std::span<const Point3> points_;
  std::vector<io::IndexTriangle> triangles_;
};

/// Writes one file whole and returns its size.
template <class Write>
std::uint64_t write_file(const std::string& path, Write&& write) {
  auto file = io::OutputFile::open(path, {.overwrite = true});
  if (!file) throw std::runtime_error(file.error().message);
  auto error = write(*file);
  const std::uint64_t size = file->size();
  if (!error) error = file->commit();
  if (error) throw std::runtime_error(error->message);
  return size;
}

std::uint64_t write_xyz(const std::string& path, std::span<const Point3> points) {
  return write_file(path,
                    [&](io::OutputFile& file) { return io::write_points(file, points, io::Format::xyz); });
}

std::uint64_t write_ply(const std::string& path, const Mesh& mesh) {
  return write_file(path,
                    [&](io::OutputFile& file) { return io::write_mesh(file, mesh.view(), io::Format::ply); });
}

/// Counter: bytes of the file.
void bytes_done(benchmark::State& state, std::uint64_t size) {
  state.counters["bytes"] = static_cast<double>(size);
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(size));
}

void add_writers(const SetOfSites& set) {
  bench::add(bench::name_of("write_xyz", set), [=](benchmark::State& state) {
    const auto points = bench::terrain(set);
    std::uint64_t size = 0;
    for (auto _ : state) size = write_xyz(Folder::path_of(set, ".xyz"), points);
    bytes_done(state, size);
  });
  bench::add(bench::name_of("write_ply", set), [=](benchmark::State& state) {
    const Mesh mesh(set);
    std::uint64_t size = 0;
    for (auto _ : state) size = write_ply(Folder::path_of(set, ".ply"), mesh);
    bytes_done(state, size);
  });
}

void read(benchmark::State& state, const std::string& path, std::uint64_t size, unsigned threads) {
  io::ReadOptions options;
  options.threads = threads;
  for (auto _ : state) {
    auto table = io::read_points(path, options);
    if (!table) return state.SkipWithError(table.error().message.c_str());
    benchmark::DoNotOptimize(table);
  }
  bytes_done(state, size);
}

void add_readers(const SetOfSites& set, unsigned threads) {
  bench::add(bench::name_of("read_xyz", set, {.threads = threads}), [=](benchmark::State& state) {
    const std::string path = Folder::path_of(set, ".xyz");
    read(state, path, write_xyz(path, bench::terrain(set)), threads);
  });
  bench::add(bench::name_of("read_ply", set, {.threads = threads}), [=](benchmark::State& state) {
    const std::string path = Folder::path_of(set, ".ply");
    read(state, path, write_ply(path, Mesh(set)), threads);
  });
}

}  // namespace

int main(int argc, char** argv) {
  for (const SetOfSites& set : bench::all_sets(1'000'000)) {
    add_writers(set);
    for (const unsigned threads : {1u, 2u}) add_readers(set, threads);
  }
  return bench::run(argc, argv);
}
