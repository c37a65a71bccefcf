/// The command, called in this process in an empty folder of its own, with hostile arguments and a hostile
/// file: it ends with a code that it promises, says why if that is not 0, and leaves the input as it was and
/// no file half written. Arguments never lead out of the folder.
#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "cli/run.hpp"
#include "cli_input.hpp"

namespace {

namespace fs = std::filesystem;
using fuzz::CommandLine;
using thalweg::cli::ExitCode;

/// Aborts unless `holds`, with the command line.
void require(bool holds, const char* law, const CommandLine& line) {
  if (holds) return;
  std::fputs("thalweg", stderr);
  for (const std::string& word : line.words) std::fprintf(stderr, " '%s'", word.c_str());
  std::fprintf(stderr, "\n%s: %zu bytes\n%s\n", line.file.c_str(), line.content.size(), line.content.c_str());
  fuzz::check(holds, law, {});
}

/// An empty folder, in memory where there is such a place, for all runs of this process.
class Folder {
 public:
  Folder() {
    const fs::path memory = "/dev/shm";
    std::error_code ignored;
    const fs::path parent = fs::is_directory(memory, ignored) ? memory : fs::temp_directory_path();
    std::string name = (parent / "thalweg_fuzz_XXXXXX").string();
    fuzz::check(::mkdtemp(name.data()) != nullptr, "a temporary folder can be made", {});
    path_ = name;
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  const fs::path& path() const { return path_; }

  /// Empties it; whether a temporary file was there.
  bool clear() const {
    bool temporary = false;
    for (const auto& entry : fs::directory_iterator(path_)) {
      temporary = temporary || entry.path().extension() == ".tmp";
      fs::remove_all(entry.path());
    }
    return temporary;
  }

 private:
  fs::path path_;
};

/// While one lives: the folder is the current one, stdin is the file, stdout leads nowhere, and stderr, the
/// stream of the C library, into memory; sanitizers write past it.
class Surroundings {
 public:
  Surroundings(const Folder& folder, const std::string& file)
      : here_(::open(".", O_RDONLY | O_DIRECTORY | O_CLOEXEC)),
        in_(::dup(0)),
        out_(::dup(1)),
        error_(stderr) {
    std::fflush(stdout);
    fs::current_path(folder.path());
    redirect(file.c_str(), O_RDONLY, 0);
    redirect("/dev/null", O_WRONLY, 1);
    stderr = ::open_memstream(&text_, &size_);
  }
  ~Surroundings() {
    std::fclose(std::exchange(stderr, error_));
    ::free(text_);
    std::fflush(stdout);
    for (const auto& [kept, number] : {std::pair{in_, 0}, {out_, 1}}) {
      if (kept >= 0) ::dup2(kept, number);
      ::close(kept >= 0 ? kept : number);
    }
    if (::fchdir(here_) != 0) std::abort();
    ::close(here_);
  }
  Surroundings(const Surroundings&) = delete;
  Surroundings& operator=(const Surroundings&) = delete;

  /// What has been said so far.
  std::string said() const {
    std::fflush(stderr);
    return {text_, size_};
  }

 private:
  static void redirect(const char* path, int flags, int number) {
    const int opened = ::open(path, flags);
    if (opened < 0 || ::dup2(opened, number) < 0) std::abort();
    if (opened != number) ::close(opened);
  }

  int here_, in_, out_;
  std::FILE* error_;
  char* text_ = nullptr;
  std::size_t size_ = 0;
};

std::string content_of(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

struct Ending {
  ExitCode code;
  std::string said;
};

Ending run(const Folder& folder, const CommandLine& line) {
  const Surroundings surroundings(folder, line.file);
  std::vector<std::string> words = {"thalweg"};
  words.insert(words.end(), line.words.begin(), line.words.end());
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const ExitCode code = thalweg::cli::run(static_cast<int>(words.size()), arguments.data());
  return {code, surroundings.said()};
}

/// One thread, unless the input says otherwise: to start more takes longer than all the rest.
void complete(CommandLine& line) {
  for (std::string& word : line.words) {
    if (word == "IN") word = line.file;
  }
  const bool runs = !line.words.empty() && !line.words[0].starts_with("-");
  if (runs && std::ranges::count(line.words, "--threads") == 0) {
    line.words.insert(line.words.begin() + 1, {"--threads", "1"});
  }
}

/// The command may replace the file only if it is told to, and does not read it.
bool may_change(const CommandLine& line) {
  const auto is_file = [&](std::size_t i) { return i < line.words.size() && line.words[i] == line.file; };
  return std::ranges::count(line.words, "--overwrite") > 0 && !is_file(1) && !is_file(3);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Folder folder;
  fuzz::Input input(data, size);
  CommandLine line = fuzz::take_command_line(input);
  complete(line);
  std::ofstream(folder.path() / line.file, std::ios::binary) << line.content;
  fs::create_directory(folder.path() / "folder");

  const Ending ending = run(folder, line);
  const bool promised = ending.code == ExitCode::done || ending.code == ExitCode::usage ||
                        ending.code == ExitCode::bad_input || ending.code == ExitCode::verification ||
                        ending.code == ExitCode::resources || ending.code == ExitCode::output;
  if (!promised) std::fputs(ending.said.c_str(), stderr);
  require(promised, "the code is one of those promised", line);
  require(ending.code == ExitCode::done || !ending.said.empty(), "an error is explained", line);
  require(may_change(line) || content_of(folder.path() / line.file) == line.content, "the input is as it was",
          line);
  require(!folder.clear(), "no temporary file is left", line);
  return 0;
}
