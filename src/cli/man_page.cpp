/// The manual page in the macros of man(7).
///
/// Texts are as for --help: lines that begin with a blank are tables or examples and stay as they are, others
/// are prose and may be filled.
#include "cli/man_page.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <sstream>
#include <vector>

#include "cli/application.hpp"
#include "thalweg/version.hpp"

namespace thalweg::cli {
namespace {

using Options = std::vector<const CLI::Option*>;

/// Text that troff shows as it is. Hyphens are made such that what is copied from the page can be typed.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\\') {
      out += "\\e";
    } else if (c == '-') {
      out += "\\-";
    } else {
      out += c;
    }
  }
  return out;
}

/// A line of text: one that begins like a request must not be taken for one.
std::string text_line(const std::string& line) {
  const bool request = !line.empty() && (line.front() == '.' || line.front() == '\'');
  return (request ? "\\&" : "") + escaped(line) + "\n";
}

std::string text_block(const std::string& text) {
  std::string out;
  std::istringstream lines(text);
  bool literal = false;
  for (std::string line; std::getline(lines, line);) {
    const bool wanted = !line.empty() && line.front() == ' ';
    if (wanted != literal && !line.empty()) out += wanted ? ".nf\n" : ".fi\n";
    if (!line.empty()) literal = wanted;
    out += line.empty() ? ".PP\n" : text_line(line);
  }
  return out + (literal ? ".fi\n" : "");
}

std::string bold(const std::string& text) {
  return "\\fB" + escaped(text) + "\\fR";
}

std::string italic(const std::string& text) {
  return "\\fI" + escaped(text) + "\\fR";
}

/// "-o, --output FILE|-" of an option, "POINTS" of an argument.
std::string entry_head(const CLI::Option& option) {
  if (option.get_positional()) return italic(option.get_name(true));
  std::string head;
  for (const std::string& name : option.get_snames()) head += (head.empty() ? "" : ", ") + bold("-" + name);
  for (const std::string& name : option.get_lnames()) head += (head.empty() ? "" : ", ") + bold("--" + name);
  const std::string& value = option.get_option_text();
  return value.empty() ? head : head + " " + italic(value);
}

std::string entry(const CLI::Option& option) {
  return ".TP\n" + entry_head(option) + "\n" + text_block(option.get_description());
}

/// The arguments of a command first, as on its command line.
Options options_of(const CLI::App& app) {
  Options options = app.get_options();
  std::stable_partition(options.begin(), options.end(),
                        [](const CLI::Option* o) { return o->get_positional(); });
  return options;
}

bool has_same(const CLI::App& app, const CLI::Option& option) {
  return std::ranges::any_of(app.get_options(),
                             [&](const CLI::Option* other) { return entry(*other) == entry(option); });
}

/// The options that every command has, in the same words.
Options common_options(const std::vector<Command>& commands) {
  Options common = options_of(*commands.front().app);
  std::erase_if(common, [&](const CLI::Option* option) {
    return !std::ranges::all_of(commands, [&](const Command& c) { return has_same(*c.app, *option); });
  });
  return common;
}

std::string synopsis(const CLI::App& app) {
  std::string line = bold("thalweg " + app.get_name()) + " [" + italic("OPTIONS") + "]";
  for (const CLI::Option* option : options_of(app)) {
    if (!option->get_positional()) continue;
    line += " " + italic(option->get_name(true));
    if (option->get_expected_max() > 1) line += " ...";
  }
  return line;
}

std::string command_section(const CLI::App& app, const Options& common) {
  std::string out = ".SS " + escaped(app.get_name()) + "\n" + text_line(app.get_description() + ".");
  for (const CLI::Option* option : options_of(app)) {
    const bool shared =
        std::ranges::any_of(common, [&](const auto* c) { return entry(*c) == entry(*option); });
    if (!shared) out += entry(*option);
  }
  return out + ".PP\n" + text_block(app.get_footer());
}

/// "Terrains without ..." as the one line after the name.
std::string purpose(const CLI::App& root) {
  std::string text = root.get_description();
  text.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(text.front())));
  if (text.back() == '.') text.pop_back();
  return escaped(text);
}

}  // namespace

std::string man_page() {
  CLI::App root;
  const std::vector<Command> commands = declare(root);
  const Options common = common_options(commands);

  std::string page = std::string(".TH THALWEG 1 \"\" \"thalweg ") + version() + "\" \"User Commands\"\n";
  page += ".SH NAME\nthalweg \\- " + purpose(root) + "\n.SH SYNOPSIS\n";
  for (const Command& command : commands) page += synopsis(*command.app) + "\n.br\n";
  page += ".SH COMMANDS\n";
  for (const Command& command : commands) page += command_section(*command.app, common);
  page += ".SH COMMON OPTIONS\n";
  for (const CLI::Option* option : common) page += entry(*option);
  return page + ".SH NOTES\n" + text_block(root.get_footer());
}

}  // namespace thalweg::cli
