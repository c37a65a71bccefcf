#include "io/input_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <system_error>
#include <utility>

#include "io/number.hpp"

namespace thalweg::io {
namespace {

struct Descriptor {
  int number = -1;
  bool owned = false;
  ~Descriptor() {
    if (owned) ::close(number);
  }
};

std::string printable(const std::string& path) {
  if (path == "-") return "<stdin>";
  std::string out = path;
  for (char& c : out) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  }
  return out;
}

std::string reason(int error_number) {
  return std::generic_category().message(error_number);
}

// Reads to the end of the file, whose size may be unknown or may change meanwhile.
std::optional<Error> read_all(int descriptor, std::size_t expected, const ReadOptions& options,
                              InputFile& input) {
  constexpr std::size_t kSmallest = std::size_t{1} << 16;
  constexpr std::size_t kChunk = std::size_t{1} << 24;
  std::size_t capacity = std::max(kSmallest, expected + 1);
  input.data = std::make_unique_for_overwrite<char[]>(capacity);
  for (;;) {
    if (options.cancel != nullptr && options.cancel->load(std::memory_order_relaxed)) {
      return input.error(ErrorCode::cancelled, "reading was interrupted");
    }
    if (input.size == capacity) {
      auto larger = std::make_unique_for_overwrite<char[]>(2 * capacity);
      std::memcpy(larger.get(), input.data.get(), input.size);
      input.data = std::move(larger);
      capacity *= 2;
    }
    const ssize_t count =
        ::read(descriptor, input.data.get() + input.size, std::min(kChunk, capacity - input.size));
    if (count == 0) return std::nullopt;
    if (count > 0) {
      input.size += static_cast<std::size_t>(count);
    } else if (errno != EINTR) {
      return input.error(ErrorCode::unreadable, "cannot be read: " + reason(errno));
    }
  }
}

struct Magic {
  std::string_view bytes;
  std::string_view advice;
};

using namespace std::string_view_literals;

// First bytes of what people are likely to pass. The advice is one command that makes a file we read.
constexpr std::array kForeign = {
    Magic{"\x1f\x8b"sv, "gzip-compressed: unpack it first: gunzip -c FILE | thalweg ... -"sv},
    Magic{"BZh"sv, "bzip2-compressed: unpack it first: bunzip2 -c FILE | thalweg ... -"sv},
    Magic{"\xfd"
          "7zXZ"sv,
          "xz-compressed: unpack it first: xz -dc FILE | thalweg ... -"sv},
    Magic{"\x28\xb5\x2f\xfd"sv, "zstd-compressed: unpack it first: zstd -dc FILE | thalweg ... -"sv},
    Magic{"PK\x03\x04"sv, "a zip archive: unpack it first: unzip -p FILE | thalweg ... -"sv},
    Magic{"LASF"sv, "LAS or LAZ: convert it first: pdal translate FILE points.csv"sv},
    Magic{"II*\0"sv, "a TIFF: convert it first: gdal_translate -of AAIGrid FILE grid.asc"sv},
    Magic{"MM\0*"sv, "a TIFF: convert it first: gdal_translate -of AAIGrid FILE grid.asc"sv},
    Magic{"II+\0"sv, "a BigTIFF: convert it first: gdal_translate -of AAIGrid FILE grid.asc"sv},
    Magic{"\x89HDF"sv, "HDF5 or NetCDF: convert it first: gdal_translate -of AAIGrid FILE grid.asc"sv},
    Magic{"CDF\x01"sv, "NetCDF: convert it first: gdal_translate -of AAIGrid FILE grid.asc"sv},
    Magic{"CDF\x02"sv, "NetCDF: convert it first: gdal_translate -of AAIGrid FILE grid.asc"sv},
    Magic{"\0\0\x27\x0a"sv,
          "a shapefile: convert it first: ogr2ogr -f CSV -lco GEOMETRY=AS_XYZ points.csv FILE"sv},
    Magic{
        "SQLite format 3"sv,
        "a GeoPackage or SQLite file: convert it first: ogr2ogr -f CSV -lco GEOMETRY=AS_XYZ points.csv FILE"sv},
    Magic{"\x93NUMPY"sv,
          "a NumPy array: write it as text first: numpy.savetxt('points.xyz', a, fmt='%.17g')"sv},
    Magic{"\x89PNG"sv, "a PNG image: give the elevations as points or as an ESRI ASCII grid"sv},
    Magic{"%PDF"sv, "a PDF document: give the elevations as points or as an ESRI ASCII grid"sv},
    Magic{"\x7f"
          "ELF"sv,
          "a program: give the elevations as points or as an ESRI ASCII grid"sv},
};

}  // namespace

std::string_view InputFile::text() const noexcept {
  const std::string_view all = bytes();
  return all.starts_with("\xef\xbb\xbf") ? all.substr(3) : all;
}

Error InputFile::error(ErrorCode code, std::string_view what) const {
  return {code, name + ": " + std::string(what)};
}

Result<InputFile> read_input(const std::string& path, const ReadOptions& options) {
  InputFile input;
  input.name = printable(path);
  Descriptor file;
  if (path == "-") {
    file.number = STDIN_FILENO;
  } else {
    file.number = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file.number < 0) return input.error(ErrorCode::unreadable, "cannot be opened: " + reason(errno));
    file.owned = true;
  }
  struct stat status {};
  if (::fstat(file.number, &status) != 0) {
    return input.error(ErrorCode::unreadable, "cannot be read: " + reason(errno));
  }
  if (S_ISDIR(status.st_mode)) {
    return input.error(ErrorCode::unreadable, "is a directory: give a file of points, a grid or a mesh");
  }
  const std::size_t expected = S_ISREG(status.st_mode) && status.st_size > 0
                                   ? static_cast<std::size_t>(status.st_size)
                                   : std::size_t{0};
  if (auto error = read_all(file.number, expected, options, input)) return std::move(*error);
  if (input.text().empty())
    return input.error(ErrorCode::malformed, "is empty: there is nothing to read in it");
  return input;
}

Result<Format> format_of_input(const InputFile& input, const std::string& path, const ReadOptions& options) {
  for (const Magic& magic : kForeign) {
    if (input.bytes().starts_with(magic.bytes)) return input.error(ErrorCode::unreadable, magic.advice);
  }
  if (path == "-" && options.format.empty()) {
    const std::string_view text = input.text();
    if (text.starts_with("ply\n") || text.starts_with("ply\r")) return Format::ply;
    if (text.starts_with("MESH2D")) return Format::two_dm;
    if (text.starts_with("v ")) return Format::obj;
    if (text.starts_with("ncols") || text.starts_with("NCOLS")) return Format::asc;
    return Format::xyz;
  }
  return format_of(path, options.format, Direction::read);
}

std::optional<Error> find_text_fault(const InputFile& input) {
  const std::string_view bytes = input.bytes();
  if (bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff")) {
    return input.error(ErrorCode::malformed, "UTF-16 text: convert it first: iconv -f UTF-16 -t UTF-8 FILE");
  }
  const std::size_t nul = bytes.find('\0');
  if (nul != std::string_view::npos) {
    const auto line = 1 + std::count(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(nul), '\n');
    return Error{ErrorCode::malformed,
                 input.name + ":" + std::to_string(line) +
                     ": NUL byte: this is binary data, not text; say what it is with --from"};
  }
  if (bytes.find('\r') != std::string_view::npos && bytes.find('\n') == std::string_view::npos) {
    return input.error(ErrorCode::malformed,
                       "lines end in CR alone: convert them first: tr '\\r' '\\n' < FILE | thalweg ... -");
  }
  return std::nullopt;
}

}  // namespace thalweg::io
