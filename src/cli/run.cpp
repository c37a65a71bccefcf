/// The command with its arguments.
#include "cli/run.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include "cli/application.hpp"
#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "thalweg/version.hpp"

namespace thalweg::cli {
namespace {

std::string version_line() {
  return std::string("thalweg ") + version() + "\n";
}

/// Text that was asked for goes to stdout.
ExitCode print(const std::string& text) {
  const bool whole =
      std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
  return whole ? ExitCode::done : ExitCode::output;
}

std::string help_of(const CLI::App& root) {
  std::string text = root.help();
  if (!text.empty() && text.back() != '\n') text += '\n';
  return text;
}

bool is_command(const std::string& word, const std::vector<Command>& commands) {
  return std::ranges::any_of(commands, [&](const Command& c) { return c.app->get_name() == word; });
}

std::string unknown_command(const std::string& word, const std::vector<Command>& commands) {
  std::string message = "unknown command \"" + word + "\": give one of";
  for (const Command& command : commands) message += " " + command.app->get_name();
  return message;
}

/// The first option that nobody knows; empty if there is none. It explains more than what may be missing for
/// it.
std::string unknown_option(const CLI::App& root) {
  for (const std::string& word : root.remaining(true)) {
    if (word.size() > 1 && word.front() == '-') return word;
  }
  return {};
}

ExitCode usage_error(Console& console, const CLI::App& root, const std::string& message) {
  std::string called = "thalweg";
  for (const CLI::App* command : root.get_subcommands()) called += " " + command->get_name();
  return console.fail(ExitCode::usage, message + " (see " + called + " --help)");
}

ExitCode run_command(int argc, char** argv, Console& console) {
  CLI::App root;
  const std::vector<Command> commands = declare(root);

  const std::string word = argc > 1 ? argv[1] : "";
  if (!word.empty() && word.front() != '-' && !is_command(word, commands)) {
    return console.fail(ExitCode::usage, unknown_command(word, commands));
  }
  try {
    root.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return print(help_of(root));
  } catch (const CLI::CallForVersion&) {
    return print(version_line());
  } catch (const CLI::ParseError& error) {
    const std::string unknown = unknown_option(root);
    return usage_error(console, root, unknown.empty() ? error.what() : "unknown option " + unknown);
  }
  for (const Command& command : commands) {
    if (command.app->parsed()) return command.run(console);
  }
  return ExitCode::usage;
}

ExitCode out_of_memory(Console& console) {
  return console.fail(
      ExitCode::resources,
      "out of memory: free some, or cut the points into tiles (thalweg info estimates the need)");
}

}  // namespace

ExitCode run(int argc, char** argv) {
  Console console;
  try {
    return run_command(argc, argv, console);
  } catch (const std::bad_alloc&) {
    return out_of_memory(console);
  } catch (const std::length_error&) {  // more than there are addresses for, where these have 32 bits
    return out_of_memory(console);
  } catch (const std::exception& error) {
    return console.fail(ExitCode::internal, std::string("internal error: ") + error.what());
  }
}

}  // namespace thalweg::cli
