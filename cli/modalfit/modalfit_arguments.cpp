#include "cli/modalfit/modalfit_arguments.hpp"

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "cli/options/command_options.hpp"
#include "cli/options/of_option.hpp"
#include "cli/options/open_options.hpp"
#include "cli/options/whole_number.hpp"

namespace jointid::cli {
namespace {

std::optional<double> number_in(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// One side of a range; `otherwise` where it is empty.
double side(std::string_view text, double otherwise, const std::string& whole) {
  if (text.empty()) return otherwise;
  const auto value = number_in(text);
  if (!value) {
    throw InputError({ErrorKind::usage, "", "--range", "'" + whole + "' is not LOW:HIGH in Hz", "write e.g. 400:1000"});
  }
  return *value;
}

}  // namespace

std::array<double, 2> parse_range(const std::string& text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) side("x", 0.0, text);
  const std::string_view all = text;
  const std::array range = {side(all.substr(0, colon), 0.0, text), side(all.substr(colon + 1), std::numeric_limits<double>::max(), text)};
  if (!(range[0] >= 0.0 && range[0] < range[1])) {
    throw InputError({ErrorKind::usage, "", "--range", "'" + text + "' does not go up from 0 Hz or more", "write e.g. 400:1000"});
  }
  return range;
}

std::vector<modalfit::Pole> parse_poles(const std::vector<std::string>& texts) {
  std::vector<modalfit::Pole> poles;
  for (const std::string& text : texts) {
    const std::size_t colon = text.find(':');
    const std::string_view all = text;
    const auto frequency = number_in(all.substr(0, colon));
    const auto damping = colon == std::string::npos ? std::nullopt : number_in(all.substr(colon + 1));
    if (!frequency || !damping || !(*frequency > 0.0 && *damping > 0.0)) {
      throw InputError({ErrorKind::usage, "", "--poles", "'" + text + "' is not FREQUENCY:DAMPING, both positive",
                        "write e.g. 51.5:0.001,142.2:0.002 (Hz, and ζ or η according to --damping)"});
    }
    poles.push_back({*frequency, *damping});
  }
  return poles;
}

void declare(CLI::App& command, ModalfitArguments& arguments) {
  command.add_option("FILES", arguments.files, "FRFs of one structure: UFF, HDF5, MAT or CSV")->required();
  command.add_option_function<std::string>(
      "--range", [&arguments](const std::string& text) { arguments.fit.range_hz = parse_range(text); },
      "Lines to fit, LOW:HIGH in Hz; default: all");
  add_whole_number(&command, "--modes", [&arguments](std::uint64_t count) { arguments.fit.modes = count; },
                   "Keep only this many, the most significant; default: all that exceed the noise",
                   {.least = 1, .most = 10000, .remedy = {}});
  command
      .add_option_function<std::vector<std::string>>(
          "--poles", [&arguments](const std::vector<std::string>& texts) { arguments.fit.poles = parse_poles(texts); },
          "Refine these modes in place of a search: FREQUENCY:DAMPING,… in Hz and ζ (η), as the workbench copies them")
      ->delimiter(',')
      ->excludes("--modes");
  command.add_flag("--real", arguments.fit.kind.real_modes, "Real modes: all DOFs move in phase or in antiphase");
  command
      .add_option_function<std::string>(
          "--damping",
          [&arguments](const std::string& text) {
            arguments.fit.kind.damping = of_option("--damping", [&] { return modalfit::parse_damping(text); });
          },
          "viscous or hysteretic; default: viscous");
  command.add_option("--regenerate", arguments.regenerate,
                      "Write the FRFs between all coordinates, measured or not, with variances (h5, uff, mat, csv)");
  command.add_option("--shapes", arguments.shapes, "Write the mode shapes as UFF dataset 55");
  add_open_options(&command, arguments.open);
  add_outputs(&command, arguments, "the fit", "the modes", "stabilisation diagram and FRFs");
  command.footer(
      "Examples:\n  jointid modalfit beam.uff --report beam.html\n"
      "  jointid modalfit beam_1.uff beam_2.uff --range 400:1000 --real --damping hysteretic\n"
      "  jointid modalfit beam.uff --regenerate beam_modal.h5 --shapes shapes.uff");
}

}  // namespace jointid::cli
