#include "cli/loading_curve/loading_curve_arguments.hpp"

#include <CLI/CLI.hpp>

#include "cli/options/command_options.hpp"
#include "cli/options/output.hpp"

namespace jointid::cli {
namespace {

void declare_columns(CLI::App& command, LoadingCurveArguments& arguments) {
  command.add_option("--displacement", arguments.displacement,
                     "Column of displacements, angles or amplitudes, by name or number");
  command.add_option("--force", arguments.force, "Column of forces or torques");
  command.add_option("--time", arguments.time, "Column of times, for --velocity");
  command.add_flag("--velocity", arguments.velocity, "The displacement column is a velocity");
  command.add_option("--energy", arguments.energy, "Instead of --force: column of energies per cycle over amplitude");
  command.add_option("--stiffness", arguments.stiffness,
                     "Instead of --force: column of equivalent stiffnesses over amplitude, with --damping");
  command.add_option("--damping", arguments.damping, "Column of equivalent dampings, with --stiffness");
  command.add_option("--unit", arguments.unit,
                     "Unit of displacements, e.g. mm, or of velocities, e.g. mm/s; default: the header's, else SI");
  command.add_option("--force-unit", arguments.force_unit, "Unit of forces, e.g. uN or N*m");
  command.add_option("--time-unit", arguments.time_unit, "Unit of times, e.g. ms");
  command.add_option("--sign", arguments.sign, "1 or -1: direction of the forces; auto: such that the joint is passive")
      ->check(CLI::IsMember({"auto", "1", "-1"}))
      ->capture_default_str();
  command.add_option("--kind", arguments.kind, "loading: loaded once from rest; loops: cut whole cycles out of the record")
      ->check(CLI::IsMember({"auto", "loading", "loops"}))
      ->capture_default_str();
}

void declare_fit(CLI::App& command, LoadingCurveArguments& arguments) {
  command
      .add_option("--law", arguments.laws,
                  "Laws to fit, e.g. ren,shoukry,menq-shape,parallel:ren:spring; default: the usual ones")
      ->delimiter(',');
  command.add_option("--ring", arguments.ring, "Rotary joint: inner and outer radius of its ring, m")
      ->delimiter(',')
      ->expected(2);
  command.add_option("--limit", arguments.limit, "Given friction limit, N (N·m)");
  command.add_option("--normal-load", arguments.normal_loads, "Normal load, N: one for all files or one for each")
      ->delimiter(',');
  command.add_flag("--friction-coefficient", arguments.friction_coefficient,
                   "One unknown mu: every friction limit is mu times the normal load");
  command.add_option("--shared", arguments.shared, "Parameters that all files have in common, e.g. b")->delimiter(',');
  command.add_option("--specimen-stiffness", arguments.specimen_stiffness, "Subtract the elastic deformation of a specimen, N/m");
  command.add_option("--specimen", arguments.specimen,
                     "Subtract that of a loading curve: a specimen without joint, columns as FILE");
  command.add_option("--weighting", arguments.weighting, "Weighting of the residuals")
      ->check(CLI::IsMember({"none", "largest", "relative", "travel"}))
      ->capture_default_str();
  command.add_option("--minimiser", arguments.minimiser, "ceres, or pattern: the pattern search of Hooke and Jeeves")
      ->check(CLI::IsMember({"best", "ceres", "pattern"}))
      ->capture_default_str();
  command
      .add_option("--slopes", arguments.slopes,
                  "Also the share h of the stiffness that has slipped, from slopes over so many samples, and which u(h) fits it")
      ->check(CLI::Range(2, 1000));
}

void check_outputs(const LoadingCurveArguments& arguments) {
  std::vector<ident::NamedFile> inputs;
  for (const auto& file : arguments.files) inputs.push_back({file, "FILES"});
  if (!arguments.specimen.empty()) inputs.push_back({arguments.specimen, "--specimen"});
  check_targets(inputs, {{"--json", arguments.json}, {"--csv", arguments.csv}, {"--report", arguments.report}});
}

}  // namespace

void declare(CLI::App& command, LoadingCurveArguments& arguments) {
  command
      .add_option("FILES", arguments.files,
                  "CSV, MATLAB or HDF5 with columns of numbers; or a scene of a joint, FILE.toml: its forces along a history")
      ->required();
  declare_columns(command, arguments);
  declare_fit(command, arguments);
  add_outputs(&command, arguments, "the fits", "the parameters", "tables and plots");
  command.footer(
      "Examples:\n  jointid problem write table2.1-1 curve && jointid loading-curve curve/table2.1-1.csv\n"
      "  jointid loading-curve rig.txt --displacement position --unit mm --force friction --force-unit uN --law ren,bilinear\n"
      "  jointid loading-curve 50kg.csv 100kg.csv --law ren --normal-load 490,981 --friction-coefficient --report joint.html");
}

void check(const LoadingCurveArguments& arguments) {
  tasks::check(arguments);
  check_outputs(arguments);
}

}  // namespace jointid::cli
