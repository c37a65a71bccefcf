/// The outputs of one run: checked before any work, written together, and given their names only when all are
/// whole.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cli/common_options.hpp"
#include "io/format.hpp"
#include "io/output_file.hpp"
#include "thalweg/result.hpp"

namespace thalweg::cli {

/// A file that the user named, and with which option.
struct NamedPath {
  std::string option;  ///< for messages: "-o", "--json", "--pits"
  std::string path;
};

/// Every output of a command: -o, then --json if there is one.
std::vector<NamedPath> named_outputs(const OutputPaths& data, const RunOptions& run);

/// Nothing, or what keeps these outputs from being written: two of them are one file or both stdout, one is
/// an input, one exists and may not be replaced, one cannot be created. Touches nothing.
std::optional<Error> check_outputs(std::span<const NamedPath> outputs, std::span<const std::string> inputs,
                                   bool overwrite);

/// An output and the format it is to have.
struct FormattedPath {
  std::string path;
  io::Format format = io::Format::xyz;
};

/// The outputs with their formats. Errors: invalid_argument for a format that is not known or not among
/// `legal`. `what` names the data in messages: "a mesh".
Result<std::vector<FormattedPath>> choose_formats(const OutputPaths& outputs,
                                                  std::span<const io::Format> legal, const std::string& what);

/// Files that appear together: each is written in full under a temporary name before the first is renamed.
class OutputBatch {
 public:
  using Write = std::function<std::optional<Error>(io::OutputFile&)>;

  explicit OutputBatch(const io::OutputOptions& options) : options_(options) {}

  /// Opens `path` and has it written. Nothing, or the error; then no file of the batch must be committed.
  [[nodiscard]] std::optional<Error> add(const std::string& path, const Write& write);

  /// Finishes stdout and devices, where most can still go wrong, then gives every file its name. Nothing, or
  /// the first error.
  [[nodiscard]] std::optional<Error> commit();

 private:
  io::OutputOptions options_;
  std::vector<io::OutputFile> streams_;
  std::vector<io::OutputFile> files_;
};

/// Writes `text` to `path` alone.
[[nodiscard]] OutputBatch::Write write_text(const std::string& text);

}  // namespace thalweg::cli
