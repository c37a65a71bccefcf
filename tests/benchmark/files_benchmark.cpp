/// Reading and writing: points as rows of x y z and as .npy, meshes with the Delaunay triangles as .tlw,
/// binary PLY and OBJ. Readers are asked for the points. The files lie in a folder of their own under that
/// for temporary files, and are read from the system's cache.
#include <stdlib.h>

#include <filesystem>
#include <optional>
#include <span>
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
std::uint64_t write_file(const std::string& path, unsigned threads, Write&& write) {
  io::OutputOptions options;
  options.overwrite = true;
  options.threads = threads;
  auto file = io::OutputFile::open(path, options);
  if (!file) throw std::runtime_error(file.error().message);
  auto error = write(*file);
  const std::uint64_t size = file->size();
  if (!error) error = file->commit();
  if (error) throw std::runtime_error(error->message);
  return size;
}

/// Where a file of this format lies, and how to write it.
struct FileKind {
  const char* name;
  io::Format format;
  bool mesh;  ///< with the Delaunay triangles
};

constexpr FileKind kKinds[] = {{"xyz", io::Format::xyz, false},
                               {"npy", io::Format::npy, false},
                               {"tlw", io::Format::tlw, true},
                               {"ply", io::Format::ply, true},
                               {"obj", io::Format::obj, true}};

std::string path_of(const SetOfSites& set, const FileKind& kind) {
  return Folder::path_of(set, std::string(".") + kind.name);
}

/// What is written to a file of a kind.
class Content {
 public:
  Content(const SetOfSites& set, const FileKind& kind) : path_(path_of(set, kind)), kind_(kind) {
    if (kind.mesh) {
      mesh_.emplace(set);
    } else {
      points_ = bench::terrain(set);
    }
  }

  std::uint64_t write(unsigned threads) const {
    return write_file(path_, threads, [&](io::OutputFile& file) {
      return mesh_ ? io::write_mesh(file, mesh_->view(), kind_.format)
                   : io::write_points(file, points_, kind_.format);
    });
  }

 private:
  std::string path_;
  FileKind kind_;
  std::optional<Mesh> mesh_;
  std::span<const Point3> points_;
};

/// Counter: bytes of the file.
void bytes_done(benchmark::State& state, std::uint64_t size) {
  state.counters["bytes"] = static_cast<double>(size);
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(size));
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

void add(const SetOfSites& set, const FileKind& kind, unsigned threads) {
  const std::string name = kind.name;
  bench::add(bench::name_of("write_" + name, set, {.threads = threads}), [=](benchmark::State& state) {
    const Content content(set, kind);
    std::uint64_t size = 0;
    for (auto _ : state) size = content.write(threads);
    bytes_done(state, size);
  });
  bench::add(bench::name_of("read_" + name, set, {.threads = threads}), [=](benchmark::State& state) {
    read(state, path_of(set, kind), Content(set, kind).write(threads), threads);
  });
}

}  // namespace

int main(int argc, char** argv) {
  for (const SetOfSites& set : bench::all_sets(1'000'000)) {
    for (const FileKind& kind : kKinds) {
      for (const unsigned threads : {1u, 2u}) add(set, kind, threads);
    }
  }
  return bench::run(argc, argv);
}
