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

#include "io/npy.hpp"
#include "io/number.hpp"
#include "io/tlw.hpp"

namespace thalweg::io {
namespace {

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
    Magic{"\x89PNG"sv, "a PNG image: give the elevations as points or as an ESRI ASCII grid"sv},
    Magic{"%PDF"sv, "a PDF document: give the elevations as points or as an ESRI ASCII grid"sv},
    Magic{"\x7f"
          "ELF"sv,
          "a program: give the elevations as points or as an ESRI ASCII grid"sv},
};

/// A binary format of ours, and whether the input begins so.
struct Known {
  bool begins;
  Format format;
  std::string_view what;
};

}  // namespace

InputFile::InputFile(InputFile&& other) noexcept {
  *this = std::move(other);
}

InputFile& InputFile::operator=(InputFile&& other) noexcept {
  if (this == &other) return *this;
  if (owned_) ::close(descriptor_);
  name_ = std::move(other.name_);
  descriptor_ = other.descriptor_;
  owned_ = std::exchange(other.owned_, false);
  at_end_ = other.at_end_;
  cancel_ = other.cancel_;
  expected_ = other.expected_;
  data_ = std::move(other.data_);
  loaded_ = std::exchange(other.loaded_, 0);
  position_ = other.position_;
  taken_ = other.taken_;
  return *this;
}

InputFile::~InputFile() {
  if (owned_) ::close(descriptor_);
}

Result<InputFile> InputFile::open(const std::string& path, const ReadOptions& options) {
  InputFile input;
  input.name_ = printable(path);
  input.cancel_ = options.cancel;
  input.descriptor_ = path == "-" ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (input.descriptor_ < 0) return input.error(ErrorCode::unreadable, "cannot be opened: " + reason(errno));
  input.owned_ = path != "-";
  struct stat status {};
  if (::fstat(input.descriptor_, &status) != 0) {
    return input.error(ErrorCode::unreadable, "cannot be read: " + reason(errno));
  }
  if (S_ISDIR(status.st_mode)) {
    return input.error(ErrorCode::unreadable, "is a directory: give a file of points, a grid or a mesh");
  }
  if (S_ISREG(status.st_mode) && status.st_size > 0) {
    const off_t start = ::lseek(input.descriptor_, 0, SEEK_CUR);
    if (start >= 0 && start <= status.st_size)
      input.expected_ = static_cast<std::uint64_t>(status.st_size - start);
  }
  const std::uint64_t all = input.expected_.value_or(kFirstLoad) + 1;
  if (auto error = input.load(static_cast<std::size_t>(std::min<std::uint64_t>(kFirstLoad, all))))
    return *error;
  if (input.text().empty() && input.at_end())
    return input.error(ErrorCode::malformed, "is empty: there is nothing to read in it");
  return input;
}

std::string_view InputFile::text() const noexcept {
  const std::string_view all = bytes();
  return all.starts_with("\xef\xbb\xbf") ? all.substr(3) : all;
}

std::optional<std::uint64_t> InputFile::size() const noexcept {
  if (at_end_) return taken_;
  if (expected_) return std::max(*expected_, taken_);
  return std::nullopt;
}

std::optional<std::uint64_t> InputFile::unread() const noexcept {
  const auto all = size();
  if (!all) return std::nullopt;
  return *all - taken_ + (loaded_ - position_);
}

// Moves what is loaded to a buffer of this size and fills it.
std::optional<Error> InputFile::load(std::size_t capacity) {
  auto larger = std::make_unique_for_overwrite<char[]>(capacity);
  if (loaded_ > 0) std::memcpy(larger.get(), data_.get(), loaded_);
  data_ = std::move(larger);
  const Result<std::size_t> count = read_descriptor(data_.get() + loaded_, capacity - loaded_);
  if (!count) return count.error();
  loaded_ += *count;
  return std::nullopt;
}

std::optional<Error> InputFile::load_more() {
  if (at_end_) return std::nullopt;
  return load(2 * std::max(loaded_, kFirstLoad / 2));
}

std::optional<Error> InputFile::load_all() {
  if (!at_end_ && expected_ && *expected_ >= loaded_) {
    if (auto error = load(static_cast<std::size_t>(*expected_) + 1)) return error;
  }
  while (!at_end_) {  // the size was unknown, or has changed meanwhile
    if (auto error = load_more()) return error;
  }
  return std::nullopt;
}

Result<std::size_t> InputFile::read(char* out, std::size_t count) {
  const std::size_t copied = std::min(count, loaded_ - position_);
  if (copied > 0) std::memcpy(out, data_.get() + position_, copied);
  position_ += copied;
  if (copied == count) return copied;
  Result<std::size_t> more = read_descriptor(out + copied, count - copied);
  if (!more) return more;
  return copied + *more;
}

Result<std::size_t> InputFile::read_descriptor(char* out, std::size_t count) {
  constexpr std::size_t kChunk = std::size_t{1} << 24;
  std::size_t done = 0;
  while (done < count && !at_end_) {
    if (cancel_ != nullptr && cancel_->load(std::memory_order_relaxed)) {
      return error(ErrorCode::cancelled, "reading was interrupted");
    }
    const ssize_t got = ::read(descriptor_, out + done, std::min(kChunk, count - done));
    if (got > 0) {
      done += static_cast<std::size_t>(got);
    } else if (got == 0) {
      at_end_ = true;
    } else if (errno != EINTR) {
      return error(ErrorCode::unreadable, "cannot be read: " + reason(errno));
    }
  }
  taken_ += done;
  return done;
}

Error InputFile::error(ErrorCode code, std::string_view what) const {
  return {code, name_ + ": " + std::string(what)};
}

Result<InputFile> read_input(const std::string& path, const ReadOptions& options) {
  Result<InputFile> input = InputFile::open(path, options);
  if (!input) return input;
  if (auto error = input->load_all()) return std::move(*error);
  return input;
}

Result<Format> format_of_input(const InputFile& input, const std::string& path, const ReadOptions& options) {
  for (const Magic& magic : kForeign) {
    if (input.bytes().starts_with(magic.bytes)) return input.error(ErrorCode::unreadable, magic.advice);
  }
  const bool told_by_content = path == "-" && options.format.empty();
  for (const auto& [begins, format, what] :
       {Known{begins_as_npy(input.bytes()), Format::npy, "a NumPy array"},
        Known{begins_as_tlw(input.bytes()), Format::tlw, "a .tlw file"}}) {
    if (!begins) continue;
    if (told_by_content) return format;
    const Result<Format> said = format_of(path, options.format, Direction::read);
    if (said && *said == format) return format;
    return input.error(ErrorCode::unreadable,
                       std::string(what) + ": say --from " + std::string(name_of(format)));
  }
  if (told_by_content) {
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
  if (auto error = find_nul(input, bytes, 1)) return error;
  if (bytes.find('\r') != std::string_view::npos && bytes.find('\n') == std::string_view::npos) {
    return input.error(ErrorCode::malformed,
                       "lines end in CR alone: convert them first: tr '\\r' '\\n' < FILE | thalweg ... -");
  }
  return std::nullopt;
}

std::optional<Error> find_nul(const InputFile& input, std::string_view part, std::uint64_t first_line) {
  const std::size_t nul = part.find('\0');
  if (nul == std::string_view::npos) return std::nullopt;
  const auto lines = std::count(part.begin(), part.begin() + static_cast<std::ptrdiff_t>(nul), '\n');
  return Error{ErrorCode::malformed,
               input.name() + ":" + std::to_string(first_line + static_cast<std::uint64_t>(lines)) +
                   ": NUL byte: this is binary data, not text; say what it is with --from"};
}

}  // namespace thalweg::io
