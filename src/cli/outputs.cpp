/// The outputs of one run.
#include "cli/outputs.hpp"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

namespace thalweg::cli {
namespace {

namespace fs = std::filesystem;

bool is_stdout(const std::string& path) {
  return path == "-" || path == "/dev/stdout";
}

/// Whether the output cannot be taken back: stdout, a device, a pipe.
bool written_in_place(const std::string& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  return is_stdout(path) || (fs::exists(status) && !fs::is_regular_file(status));
}

/// Whether both paths are one file, now or once it is written. Devices can take any number of outputs.
bool same_file(const std::string& a, const std::string& b) {
  std::error_code ignored;
  if (fs::exists(a, ignored) && fs::exists(b, ignored)) {
    return fs::equivalent(a, b, ignored) && fs::is_regular_file(a, ignored);
  }
  const fs::path left = fs::weakly_canonical(fs::absolute(a, ignored), ignored);
  const fs::path right = fs::weakly_canonical(fs::absolute(b, ignored), ignored);
  return !left.empty() && left == right;
}

Error usage(std::string message) {
  return {ErrorCode::invalid_argument, std::move(message)};
}

std::optional<Error> check_pair(const NamedPath& a, const NamedPath& b) {
  const bool both_stdout = is_stdout(a.path) && is_stdout(b.path);
  if (both_stdout) {
    return usage(a.option + " and " + b.option + " both want stdout: give one of them a file");
  }
  if (is_stdout(a.path) || is_stdout(b.path) || !same_file(a.path, b.path)) return std::nullopt;
  return usage(b.path + ": both " + a.option + " and " + b.option + " would write it: give two names");
}

std::string list_of(std::span<const io::Format> formats) {
  std::string list;
  for (const io::Format format : formats) list.append(list.empty() ? "" : ", ").append(io::name_of(format));
  return list;
}

}  // namespace

std::vector<NamedPath> named_outputs(const OutputPaths& data, const RunOptions& run) {
  std::vector<NamedPath> named;
  for (const std::string& path : data.paths) named.push_back({"-o", path});
  if (!run.json.empty()) named.push_back({"--json", run.json});
  return named;
}

std::optional<Error> check_outputs(std::span<const NamedPath> outputs, std::span<const std::string> inputs,
                                   bool overwrite) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const NamedPath& output = outputs[i];
    if (output.path.empty()) return usage(output.option + ": the name of the file is empty");
    for (std::size_t j = 0; j < i; ++j) {
      if (auto error = check_pair(outputs[j], output)) return error;
    }
    for (const std::string& input : inputs) {
      if (!is_stdout(output.path) && input != "-" && same_file(input, output.path)) {
        return usage(output.path + ": " + output.option + " would write over the input: give another name");
      }
    }
  }
  for (const NamedPath& output : outputs) {
    if (auto error = io::check_output(output.path, overwrite)) return error;
  }
  return std::nullopt;
}

Result<std::vector<FormattedPath>> choose_formats(const OutputPaths& outputs,
                                                  std::span<const io::Format> legal,
                                                  const std::string& what) {
  if (auto error = outputs.fault()) return *error;
  std::vector<FormattedPath> chosen;
  for (std::size_t i = 0; i < outputs.paths.size(); ++i) {
    const std::string& path = outputs.paths[i];
    std::string forced = outputs.format_of(i);
    if (forced.empty() && legal.size() == 1 && is_stdout(path)) forced = io::name_of(legal.front());
    const Result<io::Format> format = io::format_of(path, forced, io::Direction::write);
    if (!format) return format.error();
    if (std::ranges::find(legal, *format) == legal.end()) {
      return usage(path + ": " + what + " cannot be written as " + std::string(io::name_of(*format)) +
                   ": choose one of " + list_of(legal) + " by the suffix or with --to");
    }
    chosen.push_back({path, *format});
  }
  return chosen;
}

std::optional<Error> OutputBatch::add(const std::string& path, const Write& write) {
  Result<io::OutputFile> file = io::OutputFile::open(path, options_);
  if (!file) return file.error();
  if (auto error = write(*file)) return error;
  const bool in_place = written_in_place(path);
  // All files have found room on the disk before the first one gets its name.
  if (!in_place) file->flush();
  if (file->error()) return file->error();
  (in_place ? streams_ : files_).push_back(std::move(*file));
  return std::nullopt;
}

std::optional<Error> OutputBatch::commit() {
  for (std::vector<io::OutputFile>* outputs : {&streams_, &files_}) {
    for (io::OutputFile& output : *outputs) {
      if (auto error = output.commit()) return error;
    }
    outputs->clear();
  }
  return std::nullopt;
}

OutputBatch::Write write_text(const std::string& text) {
  return [text](io::OutputFile& file) -> std::optional<Error> {
    file.write(text);
    return file.error();
  };
}

}  // namespace thalweg::cli
