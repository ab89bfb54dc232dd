#include "cli/options/display_options.hpp"

#include <CLI/App.hpp>
#include <vector>

#include "base/error.hpp"
#include "base/text.hpp"
#include "cli/options/of_option.hpp"

namespace jointid::cli {
namespace {

const std::vector<std::string> unit_words = {"SI", "mm"}, quantity_words = {"receptance", "mobility", "accelerance", "measured"};

}  // namespace

void add_units(CLI::App* command, std::string& units) {
  command->add_option("--units", units, "Units in text, CSV and page: SI (default) or mm (N/mm); JSON stays in SI");
}

void add_quantity(CLI::App* command, std::string& quantity, const std::string& measured) {
  command->add_option("--quantity", quantity,
                      "Quantity of plotted FRFs: receptance (default), mobility, accelerance, or measured " + measured);
}

report::Display display_of(const std::string& units, const std::string& quantity) {
  report::Display display;
  display.millimetres = of_option("--units", [&] { return find_word(units, unit_words, "system of units"); }) == 1;
  of_option("--quantity", [&] { return find_word(quantity, quantity_words, "quantity of FRFs"); });
  if (quantity != "measured") display.quantity = frf::parse_quantity(quantity);
  return display;
}

void refuse_units(const std::string& units) {
  if (units == "SI") return;
  throw InputError({ErrorKind::usage, "", "--units", "does not apply to friction laws and joints at every line",
                    "leave it out: their results are in SI units"});
}

}  // namespace jointid::cli
