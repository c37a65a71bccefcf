/// Options that several subcommands share.
#include "cli/common_options.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "cli/interrupt.hpp"
#include "cli/names.hpp"
#include "io/number.hpp"

namespace thalweg::cli {
namespace {

std::optional<Bar> parse_bar(const std::string& text) {
  if (text == "auto") return Bar::automatic;
  if (text == "bar") return Bar::always;
  if (text == "none") return Bar::never;
  return std::nullopt;
}

// NaN is a common no-data value, although no coordinate may be NaN.
std::optional<double> parse_nodata(const std::string& text) {
  const io::ParsedNumber parsed = io::parse_number(text);
  if (parsed.fault != io::NumberFault::none && parsed.fault != io::NumberFault::nan) return std::nullopt;
  return parsed.value;
}

std::optional<unsigned> parse_unsigned(const std::string& text, unsigned most) {
  const auto value = parse_whole(text, most);
  return value ? std::optional(static_cast<unsigned>(*value)) : std::nullopt;
}

}  // namespace

io::OutputOptions RunOptions::output() const {
  return {.overwrite = overwrite, .cancel = &interrupted(), .threads = threads};
}

io::ReadOptions InputOptions::reader(const RunOptions& run) const {
  io::ReadOptions options;
  options.format = from;
  options.columns = columns;
  options.nodata = nodata;
  options.threads = run.threads;
  options.cancel = &interrupted();
  return options;
}

std::string OutputPaths::format_of(std::size_t i) const {
  if (formats.empty()) return {};
  return formats.size() == 1 ? formats.front() : formats[i];
}

std::optional<Error> OutputPaths::fault() const {
  if (formats.size() <= 1 || formats.size() == paths.size()) return std::nullopt;
  return Error{ErrorCode::invalid_argument, "--to: give it once, or once for each -o (" +
                                                counted(paths.size(), "output", "outputs") + ", " +
                                                counted(formats.size(), "format", "formats") + ")"};
}

void add_run_options(CLI::App& app, RunOptions& options) {
  constexpr unsigned kMostThreads = 4096;
  add_parsed<unsigned>(
      app, "--threads", "N", "Threads to use (default: all of the machine); the result does not depend on it",
      "a number of threads from 1 to 4096",
      [](const std::string& s) { return parse_unsigned(s, kMostThreads); },
      [&options](unsigned n) { options.threads = n; });
  app.add_option("--json", options.json, "Write a summary as one JSON object to FILE, or to stdout with -")
      ->option_text("FILE|-");
  app.add_flag("--overwrite", options.overwrite, "Replace outputs that exist (default: refuse)");
  add_parsed<Bar>(app, "--progress", "auto|bar|none",
                  "Progress on stderr (default: auto, a bar on a terminal)", "one of auto, bar, none",
                  parse_bar, [&options](Bar bar) { options.bar = bar; });
  app.add_flag("-q,--quiet", options.quiet, "Say nothing but errors");
  app.add_flag("-v,--verbose", options.verbose, "Say more");
}

void add_input_options(CLI::App& app, InputOptions& options) {
  app.add_option("--from", options.from,
                 "Format of the input, instead of its suffix; stdin is told by content")
      ->option_text("FMT");
  app.add_option("--columns", options.columns,
                 "Columns of x, y, z in rows of text: names from the header, or numbers from 1, as in 1,2,5")
      ->option_text("X,Y,Z");
  add_parsed<double>(app, "--nodata", "Z",
                     "Skip rows or cells of exactly this elevation (default: what the file says)",
                     "a number or nan", parse_nodata, [&options](double z) { options.nodata = z; });
}

void add_output_options(CLI::App& app, OutputPaths& options, const std::string& what) {
  app.add_option("-o,--output", options.paths, what)->option_text("FILE|-")->allow_extra_args(false);
  app.add_option("--to", options.formats,
                 "Format of the output, instead of its suffix; once for all outputs, or once for each -o")
      ->option_text("FMT")
      ->allow_extra_args(false);
}

void add_duplicates(CLI::App& app, DuplicatePolicy& policy) {
  add_parsed<DuplicatePolicy>(
      app, "--duplicates", "POLICY",
      "Elevation of a place (x, y) that has several rows: lowest, highest, mean, first, last, or error to "
      "refuse them (default: lowest, with a warning)",
      "a policy: " + std::string(kPolicyNames), [](const std::string& s) { return parse_policy(s); },
      [&policy](DuplicatePolicy p) { policy = p; });
}

CLI::Option* add_order(CLI::App& app, const std::string& help, const std::function<void(unsigned)>& set) {
  // One less than the most, so that "more than k" can be counted.
  constexpr unsigned kMost = std::numeric_limits<unsigned>::max() - 1;
  return add_parsed<unsigned>(
      app, "-k,--order", "K", help, "an order: give a whole number from 0",
      [](const std::string& s) { return parse_unsigned(s, kMost); }, set);
}

void add_pit_options(CLI::App& app, std::string& pits, bool& fail_on_pits) {
  app.add_option("--pits", pits, "Write the pits, one point each, to a .geojson or .csv file")
      ->option_text("FILE");
  app.add_flag(
      "--fail-on-pits", fail_on_pits,
      "Exit with 4, after writing, if an interior pit is left (water leaves a boundary pit over the rim)");
}

}  // namespace thalweg::cli
