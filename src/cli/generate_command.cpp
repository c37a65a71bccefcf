/// `thalweg generate`: synthetic terrains and the paper's hard instances.
#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "cli/commands.hpp"
#include "cli/common_options.hpp"
#include "cli/interrupt.hpp"
#include "cli/outputs.hpp"
#include "cli/resources.hpp"
#include "cli/summary.hpp"
#include "io/random.hpp"
#include "io/random_segments.hpp"
#include "io/read_segments.hpp"
#include "io/synthetic.hpp"
#include "io/write_mesh.hpp"
#include "thalweg/hard_instances.hpp"

namespace thalweg::cli {
namespace {

constexpr const char* kKinds = "fractal, ridge, plateau, ring, grid, lidar, theorem1, corollary2";

constexpr const char* kGenerateFooter =
    "Terrains of N points:\n"
    "  fractal     rough ground, uniform places; about 4 % of the points are pits\n"
    "  ridge       narrow oblique valleys, which Delaunay edges dam\n"
    "  plateau     terraces: a dozen elevations\n"
    "  ring        rings of 324 points on one circle, exactly, and as many just beside it\n"
    "  grid        a full square grid of whole coordinates\n"
    "  lidar       scan lines with jitter, in centimetres, at UTM coordinates\n"
    "Hard instances (de Kok, van Kreveld, Loeffler, section 2), from N random segments or those of a file: "
    "the\n"
    "fewest pits are 2N minus the largest number of segments no two of which cross.\n"
    "  theorem1    for triangulations of any order, by points exactly on lines\n"
    "  corollary2  in general position, for order 2N^2; of N = 2 .. 8 segments\n"
    "The same arguments give the same bytes on every machine. Random segments for corollary2 that need\n"
    "coordinates beyond 2^53 are drawn again.\n"
    "\n"
    "Examples:\n"
    "  thalweg generate fractal -n 100000 --seed 1 -o points.xyz\n"
    "  thalweg generate theorem1 --segments segments.txt -o hard.xyz      lines x1 y1 x2 y2, whole numbers\n"
    "  thalweg generate corollary2 -n 3 --seed 1 -o hard.xyz && thalweg build hard.xyz -k 18 -o hard.ply";

struct GenerateOptions {
  std::string kind;
  std::optional<std::uint64_t> count;
  std::optional<std::uint64_t> seed;
  std::string segments;
  OutputPaths outputs;
  RunOptions run;

  std::uint64_t seed_or_default() const { return seed.value_or(0); }
};

/// What was made, and for hard instances of what.
struct Generated {
  std::vector<Point3> points;
  std::optional<HardInstance> hard;  ///< without its points
};

using Reduction = Result<HardInstance> (*)(std::span<const LatticeSegment>);

std::optional<Reduction> reduction_of(const std::string& kind) {
  if (kind == "theorem1") return &theorem1_instance;
  if (kind == "corollary2") return &corollary2_instance;
  return std::nullopt;
}

Result<HardInstance> from_file(const GenerateOptions& options, Reduction reduction) {
  io::ReadOptions reader;
  reader.cancel = options.run.output().cancel;
  const Result<io::SegmentFile> file = io::read_segments(options.segments, reader);
  if (!file) return file.error();
  Result<HardInstance> instance = reduction(file->segments);
  if (!instance) return file->located(instance.error());
  return instance;
}

/// Of random segments. The seed counts for the first draw; draws that do not fit into 2^53 are followed by
/// others.
Result<HardInstance> from_seed(const GenerateOptions& options, Reduction reduction) {
  constexpr std::uint64_t kDraws = 100;
  const auto count = static_cast<std::uint32_t>(*options.count);
  Result<HardInstance> instance = Error{};
  for (std::uint64_t draw = 0; draw < kDraws && !interrupted(); ++draw) {
    const std::uint64_t seed = options.seed_or_default();
    const auto segments =
        io::random_segments(count, draw == 0 ? seed : io::Random::mix(io::Random::mix(seed) + draw));
    if (!segments) return segments.error();
    instance = reduction(*segments);
    if (instance || count < 2 || count > kMostCorollary2Segments) return instance;
  }
  if (interrupted()) return Error{ErrorCode::cancelled, "interrupted"};
  return instance;
}

Result<Generated> generate(const GenerateOptions& options) {
  if (const auto reduction = reduction_of(options.kind)) {
    Result<HardInstance> instance =
        options.segments.empty() ? from_seed(options, *reduction) : from_file(options, *reduction);
    if (!instance) return instance.error();
    Generated generated;
    generated.points = std::exchange(instance->points, {});
    generated.hard = *std::move(instance);
    return generated;
  }
  const auto kind = io::terrain_kind(options.kind);
  Result<std::vector<Point3>> points =
      io::synthetic_terrain(*kind, *options.count, options.seed_or_default());
  if (!points) {
    // The number came from the command line, not from a file.
    return Error{ErrorCode::invalid_argument,
                 "-n " + std::to_string(*options.count) + ": " + points.error().message};
  }
  return Generated{*std::move(points), std::nullopt};
}

/// What is wrong with the options together, in words.
std::optional<std::string> fault_of(const GenerateOptions& options) {
  const bool hard = reduction_of(options.kind).has_value();
  if (!hard && !io::terrain_kind(options.kind)) {
    return "unknown kind \"" + options.kind + "\": give one of " + kKinds;
  }
  if (!hard && !options.segments.empty())
    return "--segments is for theorem1 and corollary2 alone: leave it out";
  if (!options.segments.empty() && (options.count || options.seed)) {
    return "--segments says which segments: leave out -n and --seed";
  }
  if (options.segments.empty() && !options.count) {
    return hard ? "how many segments? Give -n N, or --segments FILE" : "how many points? Give -n N";
  }
  return std::nullopt;
}

Json summarize(const GenerateOptions& options, const Generated& generated) {
  Json summary = new_summary();
  Json parameters = {{"kind", options.kind}};
  if (options.segments.empty()) {
    parameters["count"] = *options.count;
    parameters["seed"] = options.seed_or_default();
  } else {
    parameters["segments"] = options.segments;
  }
  summary["parameters"] = std::move(parameters);
  summary["points"] = generated.points.size();
  if (generated.hard) {
    summary["instance"] = {{"segments", generated.hard->segments},
                           {"shields", generated.hard->shields},
                           {"guards", generated.hard->guards},
                           {"order", generated.hard->order},
                           {"scale", generated.hard->scale}};
  }
  summary["peak_memory_bytes"] = peak_memory_bytes();
  return summary;
}

std::optional<Error> write_outputs(const GenerateOptions& options, std::span<const FormattedPath> targets,
                                   const Generated& generated) {
  const WritingOutputs guard;
  OutputBatch batch(options.run.output());
  for (const FormattedPath& target : targets) {
    const auto write = [&](io::OutputFile& file) {
      return io::write_points(file, generated.points, target.format);
    };
    if (auto error = batch.add(target.path, write)) return error;
  }
  if (!options.run.json.empty()) {
    const std::string text = to_text(summarize(options, generated));
    if (auto error = batch.add(options.run.json, write_text(text))) return error;
  }
  return batch.commit();
}

void describe(const GenerateOptions& options, const Generated& generated, Console& console) {
  const std::string points = counted(generated.points.size(), "point", "points");
  if (!generated.hard) {
    console.note(options.kind + ": " + points + ", seed " + std::to_string(options.seed_or_default()));
    return;
  }
  const HardInstance& hard = *generated.hard;
  console.note(options.kind + ": " + points + " of " + counted(hard.segments, "segment", "segments") + ", " +
               counted(hard.shields, "shield", "shields") + " and " +
               counted(hard.guards, "guard", "guards") + ", coordinates times " + std::to_string(hard.scale));
  console.note("the fewest pits at order k = " + std::to_string(hard.order) + " are " +
               std::to_string(2 * hard.segments) + " less the largest number of segments that do not cross");
}

ExitCode run_generate(const GenerateOptions& options, Console& console) {
  console.configure(options.run.bar, options.run.quiet, options.run.verbose);
  if (const auto fault = fault_of(options)) return console.fail(ExitCode::usage, *fault);
  constexpr std::array kFormats = {io::Format::xyz, io::Format::csv, io::Format::tsv, io::Format::tlw,
                                   io::Format::npy};
  const Result<std::vector<FormattedPath>> targets = choose_formats(options.outputs, kFormats, "points");
  if (!targets) return console.fail(targets.error());
  const std::vector<NamedPath> named = named_outputs(options.outputs, options.run);
  const std::span<const std::string> inputs(&options.segments, options.segments.empty() ? 0 : 1);
  if (auto error = check_outputs(named, inputs, options.run.overwrite)) return console.fail(*error);
  const Result<Generated> generated = generate(options);
  if (!generated) return console.fail(generated.error());
  if (interrupted()) return console.fail({ErrorCode::cancelled, "interrupted"});
  if (auto error = write_outputs(options, *targets, *generated)) return console.fail(*error);
  describe(options, *generated, console);
  return ExitCode::done;
}

}  // namespace

Command add_generate(CLI::App& thalweg) {
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();
  const auto options = std::make_shared<GenerateOptions>();
  CLI::App* app = thalweg.add_subcommand("generate", "Synthetic terrains and the paper's hard instances");
  app->add_option("KIND", options->kind, kKinds)->required();
  add_parsed<std::uint64_t>(
      *app, "-n,--n", "N", "How many points, or segments of a hard instance", "a number from 1",
      [](const std::string& s) -> std::optional<std::uint64_t> {
        const auto count = parse_whole(s, std::numeric_limits<std::uint32_t>::max() - 1);
        return count == std::uint64_t{0} ? std::nullopt : count;
      },
      [options](std::uint64_t n) { options->count = n; });
  add_parsed<std::uint64_t>(
      *app, "--seed", "S", "Which of them: any whole number from 0 (default: 0)",
      "a seed: give a whole number from 0", [](const std::string& s) { return parse_whole(s, kMost); },
      [options](std::uint64_t s) { options->seed = s; });
  app->add_option("--segments", options->segments,
                  "Segments of a hard instance, lines x1 y1 x2 y2 of whole numbers; - is stdin")
      ->option_text("FILE|-");
  add_output_options(*app, options->outputs,
                     "File of points to write (xyz, csv, tsv, tlw, npy); - is stdout");
  app->get_option("--output")->required();
  add_run_options(*app, options->run);
  app->footer(kGenerateFooter);
  return {app, [options](Console& console) { return run_generate(*options, console); }};
}

}  // namespace thalweg::cli
