#include "cli/convert/convert_command.hpp"

#include <CLI/CLI.hpp>
#include <vector>

#include "base/text.hpp"
#include "cli/options/command_options.hpp"
#include "cli/options/open_options.hpp"
#include "cli/options/output.hpp"
#include "cli/text/progress.hpp"
#include "frf/file/open_as_one.hpp"
#include "tasks/convert/convert.hpp"

namespace jointid::cli {

void add_convert(CLI::App& app, Chosen& chosen) {
  auto [command, arguments] = add_command<ConvertArguments>(
      app, chosen, "convert", "Convert FRF files, several of one structure into one; the name of OUT gives the format");
  command
      ->add_option_function<std::vector<std::filesystem::path>>(
          "IN OUT",
          [to = arguments](const std::vector<std::filesystem::path>& files) {
            if (files.size() < 2) throw CLI::RequiredError("OUT");
            to->in = {files.begin(), files.end() - 1};
            to->out = files.back();
          },
          "Files to read: UFF, HDF5, MAT, numpy, CSV or text exports of an analyser; last the file to write")
      ->required();
  add_open_options(command, arguments->open);
  add_force(command);
  command->footer(
      "Examples:\n  jointid convert beam_long.uff beam_long.h5\n"
      "  jointid convert rig.mat rig.h5 --quantity accelerance --response 4:+Y,5:+Y\n"
      "  jointid convert hit_1.txt hit_3.txt beam.h5 --response 4:-X --reference 1:+X,3:+X");
}

ExitCode execute(const ConvertArguments& arguments, std::ostream& out) {
  std::vector<ident::NamedFile> inputs;
  for (const auto& file : arguments.in) inputs.push_back({file, "IN"});
  check_targets(inputs, {{"OUT", arguments.out.string()}});
  const auto source = with_progress("reading", [&] { return frf::open_as_one(arguments.in, arguments.open); });
  const frf::FrfHeader& header = source->header();
  frf::TurnedPoints turned(header);
  {
    Progress progress;
    if (!tasks::convert(*source, arguments.out, progress.control(), &turned)) return ExitCode::interrupted;
  }
  out << "wrote " << arguments.out.string() << ": " << header.lines() << " lines, " << header.response.size() << " × "
      << header.reference.size() << " FRFs";
  if (source->has_covariance() && !tasks::is_hdf5(arguments.out)) out << ", without their covariances, which HDF5 alone holds";
  if (frf::any_own_axes(header.nodes) && !tasks::is_hdf5(arguments.out))
    out << ", without the axes of its nodes, which HDF5 alone holds";
  out << '\n';
  for (const std::string& doubt : header.doubts) out << "  note: " << printable(doubt) << '\n';
  if (const std::string text = frf::turned_points_text(turned.found()); !text.empty()) out << "  note: " << text << '\n';
  return ExitCode::done;
}

}  // namespace jointid::cli
