#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/options/target.hpp"
#include "frf/set/frf_source.hpp"
#include "modalfit/model/fit.hpp"

namespace CLI {
class App;
}

namespace jointid::cli {

struct ModalfitArguments {
  std::vector<std::filesystem::path> files;
  frf::OpenOptions open;
  modalfit::FitOptions fit;
  std::optional<std::filesystem::path> regenerate, shapes;
  Target json, csv, report;
};

/// Declares the options of `jointid modalfit` on its command.
void declare(CLI::App& command, ModalfitArguments& arguments);

/// "400:1000" in Hz; either side may be left out. Throws InputError (usage).
std::array<double, 2> parse_range(const std::string& text);

/// "51.5:0.001,142:0.002": frequencies in Hz and damping ratios (loss factors). Throws InputError (usage).
std::vector<modalfit::Pole> parse_poles(const std::vector<std::string>& texts);

}  // namespace jointid::cli
