#include "io/output_file.hpp"

#include <fcntl.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <system_error>
#include <utility>

#include "io/parallel.hpp"

namespace thalweg::io {
namespace {

constexpr std::size_t kBufferSize = std::size_t{1} << 18;
constexpr mode_t kNewFileMode = 0666;  // less the umask

std::string reason(int error_number) {
  return std::generic_category().message(error_number);
}

Error failure(const std::string& path, ErrorCode code, const std::string& what) {
  return {code, (path == "-" ? "<stdout>" : path) + ": " + what};
}

Error unwritable(const std::string& path, int error_number) {
  return failure(path, ErrorCode::unwritable, "cannot be written: " + reason(error_number));
}

Error already_there(const std::string& path) {
  return failure(path, ErrorCode::exists,
                 "exists already: say --overwrite to replace it, or choose another name");
}

// /dev/stdout and /dev/fd/N are what the process already has open, a regular file perhaps: to open them again
// by name would write over its beginning.
std::optional<int> inherited_descriptor(const std::string& path) {
  if (path == "-" || path == "/dev/stdout") return STDOUT_FILENO;
  if (path == "/dev/stderr") return STDERR_FILENO;
  for (const std::string_view prefix : {"/dev/fd/", "/proc/self/fd/"}) {
    if (!path.starts_with(prefix)) continue;
    int number = -1;
    const char* const last = path.data() + path.size();
    const auto [end, fault] = std::from_chars(path.data() + prefix.size(), last, number);
    if (fault == std::errc() && end == last && number >= 0) return number;
  }
  return std::nullopt;
}

std::string folder_of(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  if (slash == std::string::npos) return ".";
  return slash == 0 ? "/" : path.substr(0, slash);
}

// The file that `path` means once symbolic links are followed: renaming over a link would cut it off from its
// target.
std::string resolved(const std::string& path) {
  struct stat status {};
  if (::lstat(path.c_str(), &status) != 0 || !S_ISLNK(status.st_mode)) return path;
  char* const real = ::realpath(path.c_str(), nullptr);
  if (real == nullptr) return path;
  std::string out = real;
  std::free(real);
  return out;
}

/// What is at a path now.
struct Target {
  bool there = false;
  bool regular = false;
  bool directory = false;
  mode_t mode = 0;
};

Target look_at(const std::string& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return {};
  return {true, S_ISREG(status.st_mode), S_ISDIR(status.st_mode),
          static_cast<mode_t>(status.st_mode & 07777)};
}

// A name that nobody can have guessed and put a link under; O_EXCL makes sure of it.
Result<std::pair<std::string, int>> create_beside(const std::string& path, const std::string& target) {
  constexpr char kLetters[] = "0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ-_";
  for (int attempt = 0; attempt < 100; ++attempt) {
    std::array<unsigned char, 12> noise{};
    if (::getentropy(noise.data(), noise.size()) != 0) return unwritable(path, errno);
    std::string name = target + ".";
    for (const unsigned char byte : noise) name += kLetters[byte & 63];
    name += ".tmp";
    const int descriptor =
        ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, kNewFileMode);
    if (descriptor >= 0) return std::pair(std::move(name), descriptor);
    if (errno != EEXIST) return unwritable(path, errno);
  }
  return unwritable(path, EEXIST);
}

// Gives the temporary file its name. Without `overwrite` a file that has appeared meanwhile stays: link,
// unlike rename, refuses to replace it. Where there are no hard links (FAT), a look must do. Returns errno,
// or 0.
int put_in_place(const std::string& temporary, const std::string& target, bool overwrite) {
  if (!overwrite) {
    if (::link(temporary.c_str(), target.c_str()) == 0) {
      ::unlink(temporary.c_str());
      return 0;
    }
    if (errno == EEXIST) return EEXIST;
    if (look_at(target).there) return EEXIST;
  }
  return ::rename(temporary.c_str(), target.c_str()) == 0 ? 0 : errno;
}

}  // namespace

std::optional<Error> check_output(const std::string& path, bool overwrite) {
  if (path.empty()) return failure("''", ErrorCode::unwritable, "an output needs a name");
  if (const auto descriptor = inherited_descriptor(path)) {
    const int flags = ::fcntl(*descriptor, F_GETFL);
    if (flags < 0) return unwritable(path, errno);
    if ((flags & O_ACCMODE) == O_RDONLY) return unwritable(path, EBADF);
    return std::nullopt;
  }
  const Target target = look_at(path);
  if (target.directory) return unwritable(path, EISDIR);
  if (target.there && target.regular && !overwrite) return already_there(path);
  if (target.there && !target.regular) {
    if (::access(path.c_str(), W_OK) != 0) return unwritable(path, errno);
    return std::nullopt;
  }
  if (path.back() == '/') return unwritable(path, EISDIR);
  // The file itself is replaced, not written to: what counts is whether its folder takes new names.
  if (::access(folder_of(resolved(path)).c_str(), W_OK | X_OK) != 0) return unwritable(path, errno);
  return std::nullopt;
}

Result<OutputFile> OutputFile::open(const std::string& path, const OutputOptions& options) {
  if (auto error = check_output(path, options.overwrite)) return std::move(*error);
  OutputFile file;
  file.path_ = path;
  file.overwrite_ = options.overwrite;
  file.cancel_ = options.cancel;
  file.threads_ = resolve_threads(options.threads);
  if (const auto descriptor = inherited_descriptor(path)) {
    file.descriptor_ = ::fcntl(*descriptor, F_DUPFD_CLOEXEC, 0);
    if (file.descriptor_ < 0) return unwritable(path, errno);
  } else if (const Target target = look_at(path); target.there && !target.regular) {
    file.descriptor_ = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (file.descriptor_ < 0) return unwritable(path, errno);
  } else {
    file.target_ = resolved(path);
    auto created = create_beside(path, file.target_);
    if (!created) return std::move(created).error();
    file.temporary_ = std::move(created->first);
    file.descriptor_ = created->second;
    if (target.there) ::fchmod(file.descriptor_, target.mode);  // if it fails: the mode of a new file will do
  }
  file.buffer_ = std::make_unique_for_overwrite<char[]>(kBufferSize);
  return file;
}

OutputFile::OutputFile(OutputFile&& other) noexcept {
  *this = std::move(other);
}

OutputFile& OutputFile::operator=(OutputFile&& other) noexcept {
  if (this == &other) return *this;
  discard();
  path_ = std::move(other.path_);
  target_ = std::move(other.target_);
  temporary_ = std::exchange(other.temporary_, {});
  descriptor_ = std::exchange(other.descriptor_, -1);
  overwrite_ = other.overwrite_;
  cancel_ = other.cancel_;
  threads_ = other.threads_;
  buffer_ = std::move(other.buffer_);
  used_ = std::exchange(other.used_, 0);
  size_ = std::exchange(other.size_, 0);
  error_ = std::move(other.error_);
  return *this;
}

OutputFile::~OutputFile() {
  discard();
}

void OutputFile::discard() noexcept {
  if (descriptor_ >= 0) ::close(descriptor_);
  descriptor_ = -1;
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
  temporary_.clear();
  used_ = 0;
}

void OutputFile::fail(ErrorCode code, int error_number) {
  if (error_) return;
  error_ = code == ErrorCode::cancelled ? failure(path_, code, "writing was interrupted")
                                        : unwritable(path_, error_number);
  used_ = 0;
}

void OutputFile::write(std::string_view bytes) {
  if (error_ || bytes.empty()) return;  // nothing may have no address, which memcpy does not take
  size_ += bytes.size();
  if (bytes.size() > kBufferSize - used_) {
    flush();
    if (bytes.size() >= kBufferSize) {
      put(bytes.data(), bytes.size());
      return;
    }
  }
  if (error_) return;
  std::memcpy(buffer_.get() + used_, bytes.data(), bytes.size());
  used_ += bytes.size();
}

void OutputFile::flush() {
  put(buffer_.get(), std::exchange(used_, 0));
}

void OutputFile::put(const char* bytes, std::size_t count) {
  constexpr std::size_t kChunk = std::size_t{1} << 22;
  while (count > 0 && !error_) {
    if (cancel_ != nullptr && cancel_->load(std::memory_order_relaxed)) return fail(ErrorCode::cancelled, 0);
    const ssize_t written = ::write(descriptor_, bytes, std::min(count, kChunk));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return fail(ErrorCode::unwritable, errno);
    bytes += written;
    count -= static_cast<std::size_t>(written);
  }
}

std::optional<Error> OutputFile::commit() {
  if (!error_ && cancel_ != nullptr && cancel_->load(std::memory_order_relaxed))
    fail(ErrorCode::cancelled, 0);
  flush();
  // Only where there is an old file to lose is it worth waiting for the disk: without it a power cut soon
  // after could leave neither the old content nor the new.
  if (!error_ && !temporary_.empty() && overwrite_ && look_at(target_).there && ::fsync(descriptor_) != 0) {
    fail(ErrorCode::unwritable, errno);
  }
  if (descriptor_ >= 0 && ::close(descriptor_) != 0)
    fail(ErrorCode::unwritable, errno);  // NFS tells of a full disk here
  descriptor_ = -1;
  if (!error_ && !temporary_.empty()) {
    const int fault = put_in_place(temporary_, target_, overwrite_);
    if (fault == EEXIST && !overwrite_) {
      error_ = already_there(path_);
    } else if (fault != 0) {
      fail(ErrorCode::unwritable, fault);
    } else {
      temporary_.clear();
    }
  }
  discard();
  return error_;
}

}  // namespace thalweg::io
