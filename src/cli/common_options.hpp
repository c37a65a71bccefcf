/// Options that several subcommands share: declared once, so that they read and behave alike everywhere.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cli/console.hpp"
#include "cli/text.hpp"
#include "io/output_file.hpp"
#include "io/read_options.hpp"
#include "thalweg/minimize.hpp"

namespace thalweg::cli {

/// What every subcommand takes: --threads, --json, --overwrite, --progress, -q, -v.
struct RunOptions {
  unsigned threads = 0;  ///< 0 = all of the machine
  std::string json;      ///< where the summary goes; empty: nowhere
  bool overwrite = false;
  Bar bar = Bar::automatic;
  bool quiet = false;
  bool verbose = false;

  /// For OutputFile: with the flag of Ctrl-C.
  io::OutputOptions output() const;
};

/// How an input is to be read: --from, --columns, --nodata.
struct InputOptions {
  std::string from;
  std::string columns;
  std::optional<double> nodata;

  /// For the readers: with the flag of Ctrl-C.
  io::ReadOptions reader(const RunOptions& run) const;
};

/// Where data goes: -o FILE and --to FMT, both repeatable.
struct OutputPaths {
  std::vector<std::string> paths;
  std::vector<std::string> formats;

  /// The --to of output i, empty if there is none. Requires: legal().
  std::string format_of(std::size_t i) const;
  /// Nothing, or an Error: --to is given neither once nor once for each -o.
  std::optional<Error> fault() const;
};

void add_run_options(CLI::App& app, RunOptions& options);
void add_input_options(CLI::App& app, InputOptions& options);
void add_output_options(CLI::App& app, OutputPaths& options, const std::string& what);

/// --duplicates, for commands that merge points of equal (x, y).
void add_duplicates(CLI::App& app, DuplicatePolicy& policy);

/// -k, --order: a whole number from 0.
CLI::Option* add_order(CLI::App& app, const std::string& help, const std::function<void(unsigned)>& set);

/// --pits FILE and --fail-on-pits.
void add_pit_options(CLI::App& app, std::string& pits, bool& fail_on_pits);

/// An option whose text `parse` turns into a value; when it returns nothing the command ends with
/// "OPTION: "TEXT" is not EXPECTED".
template <class T>
CLI::Option* add_parsed(CLI::App& app, const std::string& name, const std::string& shape,
                        const std::string& help, const std::string& expected,
                        std::function<std::optional<T>(const std::string&)> parse,
                        std::function<void(T)> set) {
  const auto read = [name, expected, parse, set](const std::string& text) {
    const std::optional<T> value = parse(text);
    if (!value) {
      const std::string shown = name.substr(name.rfind(',') + 1);
      throw CLI::ValidationError(shown, "\"" + text + "\" is not " + expected);
    }
    set(*value);
  };
  return app.add_option_function<std::string>(name, read, help)->option_text(shape);
}

}  // namespace thalweg::cli
