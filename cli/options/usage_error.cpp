#include "cli/options/usage_error.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <vector>

#include "base/error.hpp"

namespace jointid::cli {
namespace {

/// The innermost command that was named.
const CLI::App& named_command(const CLI::App& app) {
  const CLI::App* current = &app;
  while (!current->get_subcommands().empty()) current = current->get_subcommands().front();
  return *current;
}

/// "jointid problem write"
std::string path_of(const CLI::App& command) {
  const CLI::App* parent = command.get_parent();
  return (parent == nullptr ? "" : path_of(*parent) + " ") + command.get_name();
}

std::vector<std::string> commands_of(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::App* sub : command.get_subcommands({})) names.push_back(sub->get_name());
  return names;
}

std::vector<std::string> options_of(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& valid) {
  const std::string nearest = nearest_word(word, valid);
  return nearest.empty() ? "" : "; did you mean '" + nearest + "'?";
}

/// The first word that no command or option took: an option where there is one that `command` does not have. Behind a stray word its
/// own options are left over, too.
std::string stray_word(const CLI::App& app, const CLI::App& command) {
  const std::vector<std::string> stray = app.remaining(true), known = options_of(command);
  for (const std::string& word : stray) {
    const std::string option = word.substr(0, word.find('='));
    if (word.starts_with('-') && std::ranges::find(known, option) == known.end()) return option;
  }
  return stray.empty() ? "" : stray.front();
}

/// Whether some command below this one has the option.
bool is_option_of_some(const CLI::App& command, const std::string& option) {
  return std::ranges::any_of(command.get_subcommands({}), [&](const CLI::App* sub) {
    const std::vector<std::string> own = options_of(*sub);
    return std::ranges::find(own, option) != own.end() || is_option_of_some(*sub, option);
  });
}

std::string about_stray(const CLI::App& command, const std::string& word) {
  const std::string of = "`" + path_of(command) + "`";
  const std::vector<std::string> own = options_of(command);
  if (std::ranges::find(own, word) != own.end()) return "'" + word + "' is in the wrong place; put it after " + of;
  if (word.starts_with('-') && is_option_of_some(command, word)) return of + " has no option '" + word + "'; it goes behind the command";
  if (word.starts_with('-')) return of + " has no option '" + word + "'" + did_you_mean(word, own);
  const std::vector<std::string> commands = commands_of(command);
  if (commands.empty()) return "'" + word + "' was not expected";
  return "'" + word + "' is no command of " + of + did_you_mean(word, commands);
}

std::string what_is_wrong(const CLI::App& app, const CLI::App& command, const CLI::ParseError& error) {
  const std::string stray = stray_word(app, command);
  if (!stray.empty()) return about_stray(command, stray);
  if (!commands_of(command).empty()) return "no command was given";
  std::string what = error.what();
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) {
    what = what.substr(0, what.find(':')) + " needs a value";
  }
  return what;
}

}  // namespace

std::string usage_error(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& command = named_command(app);
  return what_is_wrong(app, command, error) + "; see `" + path_of(command) + " --help`";
}

}  // namespace jointid::cli
