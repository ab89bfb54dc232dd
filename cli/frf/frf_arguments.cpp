#include "cli/frf/frf_arguments.hpp"

#include <CLI/CLI.hpp>

#include "base/error.hpp"
#include "cli/options/command_options.hpp"
#include "cli/options/of_option.hpp"
#include "cli/options/open_options.hpp"

namespace jointid::cli {
namespace {

void declare_reading(CLI::App& command, FrfArguments& arguments) {
  command.add_option("FILES", arguments.files, "Time records: .npy, .npz, CSV or text, MATLAB, HDF5, UFF 58")->required();
  const auto channel = command.add_option_function<std::vector<std::string>>(
      "--channel",
      [&arguments](const std::vector<std::string>& texts) {
        for (const std::string& text : texts) {
          arguments.read.channels.push_back(of_option("--channel", [&] { return records::parse_channel(text); }));
        }
      },
      "COLUMN=DOF [FACTOR] [UNIT], e.g. 2=1:+Z N: a column by name or number, the DOF of its sensor, its unit where the file states "
      "none; one per channel. "
      "UFF: a channel of the run, if the file does not state it");
  channel->allow_extra_args(false);  // what follows is the next word, not one more channel
  command.add_option("--time", arguments.read.time,
                     "Column of the times; default: the one named time or t. Seconds, or as its title states");
  command.add_option("--rate", arguments.read.rate_hz, "Samples per second, if the file does not state them")
      ->check(CLI::PositiveNumber);
  command
      .add_option_function<std::vector<std::string>>(
          "--reference",
          [&arguments](const std::vector<std::string>& texts) {
            arguments.references = of_option("--reference", [&] { return parse_dofs(texts); });
          },
          "DOF of the force, or one per file (roving hammer); default: as the channels state")
      ->delimiter(',')
      ->allow_extra_args(false);
}

void declare_stretches(CLI::App& command, FrfArguments& arguments) {
  records::HammerOptions& hammer = arguments.options.hammer;
  command.add_flag("--shaker", arguments.shaker, "Segments of a long record instead of hits of a hammer");
  command.add_option("--block", arguments.block_s, "Length of a segment, s; default: each whole file is one hit");
  command.add_option("--pretrigger", hammer.pretrigger_s, "Time before the trigger that belongs to the segment, s")
      ->capture_default_str();
  command.add_option("--trigger", hammer.trigger, "A hit begins at this share of the record's largest force")
      ->capture_default_str();
  command.add_option("--second-blow", hammer.second_peak, "A force above this share of the peak is a double impact")
      ->capture_default_str();
  command.add_option("--force-window", arguments.options.force_window_s, "Seconds after its peak for which the force counts");
  command.add_option("--exponential", arguments.options.decay_time_s,
                     "Time constant, s, of an exponential window; jointid removes the damping that it adds");
  command.add_option("--overlap", arguments.segments.overlap, "Share by which segments overlap")->capture_default_str();
  command.add_option_function<std::string>(
      "--window",
      [&arguments](const std::string& text) {
        arguments.segments.window = of_option("--window", [&] {
          return static_cast<frf::Window>(find_word(text, {"rectangular", "hann"}, "window of segments"));
        });
      },
      "Window of the segments: hann (default) or rectangular");
  command.add_flag("--remove-mean", arguments.options.remove_mean, "Subtract the mean of every segment");
  command.add_option("--reject", arguments.options.reject, "Segments to leave out, by their number in the table, e.g. 2,5")
      ->delimiter(',')
      ->allow_extra_args(false);
  command.add_flag("--keep-faulty", arguments.options.keep_faulty, "Also average overloads and double impacts");
}

void declare_estimate(CLI::App& command, FrfArguments& arguments) {
  command.add_option_function<std::string>(
      "--estimator",
      [&arguments](const std::string& text) {
        arguments.options.estimator = of_option("--estimator", [&] { return records::parse_estimator(text); });
      },
      "H1, H2 or Hv; default: H1");
  command.add_option_function<std::string>(
      "--variances",
      [&arguments](const std::string& text) {
        arguments.options.noise = of_option("--variances", [&] { return records::parse_noise_from(text); });
      },
      "residuals (as the coherence) or scatter over the hits; default: residuals");
  command.add_option("--highest", arguments.options.highest_hz, "Highest line of the FRFs, Hz; default: all")->default_str("");
}

}  // namespace

void declare(CLI::App& command, FrfArguments& arguments) {
  declare_reading(command, arguments);
  declare_stretches(command, arguments);
  declare_estimate(command, arguments);
  command.add_option("--output", arguments.output,
                     "Write the FRFs (h5 with covariances; uff, mat, csv without); default: only print their quality");
  add_outputs(&command, arguments, "segments, averages and coherences", "the segments", "the FRFs and their coherence");
  command.footer(
      "Examples:\n  jointid frf hit_*.npy --channel '2=1:+Z N' --channel '3=4:+Z m/s^2' --time 1 --output beam.h5\n"
      "  jointid frf hits.csv --channel 'hammer=1:+Z N' --channel 'a=4:+Z g' --block 2 --pretrigger 0.01 --exponential 0.4 "
      "--output beam.h5\n"
      "  jointid frf point_*.uff --reference 1:+Z,2:+Z,3:+Z --output beam.h5\n"
      "  jointid frf random.mat --shaker --block 0.8 --rate 1280 --remove-mean --channel 'f=1:+Z N' --channel 'a=1:+Z m/s^2' "
      "--output beam.h5");
}

}  // namespace jointid::cli
