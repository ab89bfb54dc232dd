#include "cli/parser.hpp"

#include <CLI/CLI.hpp>
#include <sstream>

#include "cli/options/usage_error.hpp"
#include "cli/text/version.hpp"

namespace jointid::cli {

std::variant<ChosenCommand, Notice> parse(int argc, const char* const* argv,
                                          void (*add_commands)(CLI::App& app, Chosen& chosen)) {
  CLI::App app(
      "Identifies the stiffness, mass and damping of joints from measured frequency response functions, with uncertainty.", "jointid");
  app.require_subcommand(1);
  app.set_version_flag("--version", version_text());
  app.footer(
      "Examples:\n  jointid problem write A1 a1   write a built-in problem\n"
      "  jointid solve a1/A1.toml      identify its joint\n"
      "  jointid solve --help          help on one command");
  Chosen chosen;
  add_commands(app, chosen);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForVersion& version) {
    return Notice{ExitCode::done, std::string(version.what()) + "\n", true};
  } catch (const CLI::Success& success) {
    std::ostringstream out, err;
    app.exit(success, out, err);
    return Notice{ExitCode::done, out.str()};
  } catch (const CLI::ParseError& error) {
    return Notice{ExitCode::usage, usage_error(app, error)};
  }
  return *chosen;
}

}  // namespace jointid::cli
