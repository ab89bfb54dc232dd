#include "cli/series/series_command.hpp"

#include <CLI/CLI.hpp>

#include "cli/options/command_options.hpp"

namespace jointid::cli {
namespace {

const char* const file_text = "Record: text, UFF 58, MATLAB, HDF5 or numpy";

CLI::Option* add_rate(CLI::App* command, std::optional<double>& rate_hz) {
  return command->add_option("--rate", rate_hz, "Samples per second, if the file does not state them")->check(CLI::PositiveNumber);
}

void add_delay(CLI::App& series, Chosen& chosen) {
  auto [command, a] = add_command<SeriesDelayArguments>(
      series, chosen, "delay", "Delay, embedding dimension, correlation dimension, exponent and recurrences of one channel");
  command->add_option("FILE", a->file, file_text)->required();
  command->add_option("--channel", a->channel, "Name or number of the column (default: the only one beside the time)");
  add_rate(command, a->rate_hz);
  add_whole_number(command, "--samples", a->samples, "Samples to read, from the first on", {100, 200'000, "time grows with their square"});
  add_whole_number(command, "--cells", a->cells, "Cells of each histogram of the mutual information", {2, 1000, ""});
  add_whole_number(command, "--most-lag", a->most_lag, "Largest lag of mutual information, samples", {2, 100'000, ""});
  add_whole_number(command, "--delay", a->delay, "Delay of the embedding, samples; 0: first minimum of the mutual information",
                   {0, 100'000, ""});
  add_whole_number(command, "--dimension", a->dimension,
                   "Dimension of the embedding; 0: the smallest with at most 1 % false nearest neighbours",
                   {0, 20, ""});
  add_whole_number(command, "--most-dimension", a->most_dimension, "Largest dimension in the search by false nearest neighbours",
                   {1, 20, ""});
  add_whole_number(command, "--theiler", a->theiler,
                   "Smallest distance of neighbours in time, samples; 0: twice delay times dimension", {0, 100'000, ""});
  add_whole_number(command, "--steps", a->steps, "Length of the divergence curves, samples", {10, 10'000, ""});
  command->add_option("--wolf", a->wolf, "Wolf's exponent, too: samples over which a pair is followed, e.g. 2,5,10,20")
      ->delimiter(',')
      ->check(CLI::PositiveNumber);
  command
      ->add_option("--wolf-range", a->wolf_range,
                   "Least and largest distance of new pairs of --wolf, in the channel's unit (default: 0.001 and 0.1 standard deviations)")
      ->delimiter(',')
      ->needs("--wolf");
  add_outputs(command, *a, "all results", "the curves", "curves");
  command->footer("Example:\n  jointid series delay run.csv --channel 2 --rate 1000 --theiler 60 --wolf 2,5,10,20");
}

void add_strain(CLI::App& series, Chosen& chosen) {
  auto [command, a] =
      add_command<SeriesStrainArguments>(series, chosen, "strain", "Displacements of a clamped beam from strain gauges");
  command->add_option("FILE", a->file, file_text)->required();
  command->add_option("--channels", a->channels, "Columns of the gauges, in their order (default: all but the time)")
      ->delimiter(',');
  command->add_option("--length", a->length, "Length of the beam, m")->required()->check(CLI::PositiveNumber);
  command->add_option("--thickness", a->thickness, "Thickness of the beam, m; the strain is half of it times the curvature")
      ->required()
      ->check(CLI::PositiveNumber);
  command->add_option("--gauges", a->gauges, "Positions of the gauges, m from the clamp")->required()->delimiter(',');
  command->add_option("--points", a->points, "Positions of the displacements, m (default: the tip)")->delimiter(',');
  add_whole_number(command, "--shapes", a->shapes, "Number of shapes in the basis; 0: the number of gauges", {0, 100, ""});
  command->add_flag("--static-shapes", a->static_shapes, "Take the shapes of a tip force and a tip moment as two of --shapes");
  command->add_option("--output,--csv", a->output, "Write the displacements as CSV to a file, or - for stdout");
  command->add_option("--json", a->json, "Write the map and its noise as JSON to a file, or - for stdout");
  add_force(command);
  command->add_option("--report", a->report, "Write one HTML page with the map and the first samples to a file, or - for stdout");
  command->footer(
      "Example:\n  jointid series strain run.csv --length 0.4 --thickness 0.00086 --gauges 0.05,0.1,0.15,0.2 --output y.csv");
}

void add_friction(CLI::App& series, Chosen& chosen) {
  auto [command, a] =
      add_command<SeriesFrictionArguments>(series, chosen, "friction", "Friction law of a contact from a stick-slip record");
  command->add_option("FILE", a->file, file_text)->required();
  command->add_option("--velocity", a->velocity, "Column of the relative velocity, m/s")->required();
  command->add_option("--force", a->force, "Column of the friction force, N, with the sign of the velocity while it slips")
      ->required();
  command->add_option("--normal", a->normal, "Column of the normal load, N");
  command->add_option("--load", a->load, "Constant normal load, N")->check(CLI::PositiveNumber);
  command
      ->add_option("--stick-speed", a->stick_speed,
                   "Samples below this speed count as sticking, m/s; choose it above the noise of the velocity")
      ->required()
      ->check(CLI::PositiveNumber);
  add_rate(command, a->rate_hz);
  command->add_option("--force-delay", a->force_delay, "Time delay of the force, s; `series align` finds it");
  add_outputs(command, *a, "the law", "velocity and friction coefficient of the samples", "the law over the samples");
  command->footer("Example:\n  jointid series friction run.csv --velocity v --force F --load 1.86 --stick-speed 0.002");
}

void add_reversal(CLI::App& series, Chosen& chosen) {
  auto [command, a] = add_command<SeriesReversalArguments>(series, chosen, "reversal",
                                                           "Contact stiffness from the slopes of the friction force after reversals");
  command->add_option("FILE", a->file, file_text)->required();
  command->add_option("--displacement", a->displacement, "Column of the slider's displacement against the nub, m")->required();
  command->add_option("--force", a->force, "Column of the friction force on the body, N")->required();
  command->add_option("--slip-force", a->options.slip_force, "Friction force while it slips, N (default: from the record)")
      ->check(CLI::PositiveNumber);
  command->add_option("--share", a->options.share, "Straight parts lie between plus and minus this share of the slip force")
      ->check(CLI::Range(0.05, 0.99));
  command
      ->add_option("--body-stiffness", a->options.body_stiffness,
                   "Stiffness of the body at the nub, N/m, where the displacement is that of the slider alone")
      ->check(CLI::PositiveNumber);
  add_rate(command, a->rate_hz);
  command->add_option("--json", a->json, "Write the stiffness as JSON to a file, or - for stdout");
  add_force(command);
  command->add_option("--report", a->report, "Write one HTML page with the slopes to a file, or - for stdout");
  command->footer("Example:\n  jointid series reversal run.csv --displacement d --force F");
}

void add_align(CLI::App& series, Chosen& chosen) {
  auto [command, a] = add_command<SeriesAlignArguments>(
      series, chosen, "align", "Time delays of the channels of a periodic record, and the record without them");
  command->add_option("FILE", a->file, file_text)->required();
  command->add_option("--reference", a->reference, "Column without a time delay")->required();
  command->add_option("--frequency", a->frequency_hz, "Frequency of the motion, Hz")->required()->check(CLI::PositiveNumber);
  add_whole_number(command, "--harmonics", a->harmonics, "How many harmonics to fit together", {1, 50, ""});
  add_rate(command, a->rate_hz);
  command->add_option("--output,--csv", a->output, "Write the aligned record as CSV to a file, or - for stdout");
  command->add_option("--json", a->json, "Write the delays as JSON to a file, or - for stdout");
  add_force(command);
  command->add_option("--report", a->report, "Write one HTML page with the delays and three periods to a file, or - for stdout");
  command->footer("Example:\n  jointid series align run.csv --reference slider --frequency 12 --output aligned.csv");
}

}  // namespace

void add_series(CLI::App& app, Chosen& chosen) {
  CLI::App* series = app.add_subcommand("series", "Tools for time records: delay and dimension, strain, friction, phases");
  series->require_subcommand(1);
  series->footer(
      "Examples:\n  jointid series delay run.csv --channel 2\n  jointid series friction run.csv --velocity v --force F --load 2 "
      "--stick-speed 0.01");
  add_delay(*series, chosen);
  add_strain(*series, chosen);
  add_friction(*series, chosen);
  add_align(*series, chosen);
  add_reversal(*series, chosen);
}

}  // namespace jointid::cli
