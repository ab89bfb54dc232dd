#include <fmt/format.h>

#include <fstream>

#include "base/temporary_file.hpp"
#include "cli/options/output.hpp"
#include "cli/series/series_command.hpp"
#include "cli/text/interrupt.hpp"
#include "report/series/strain_report.hpp"

namespace jointid::cli {
namespace {

std::size_t write_displacements(const tasks::StrainResult& found, records::SampleStream& gauges, std::ostream& to) {
  ident::Control control;
  control.interrupted = interrupted;
  to << report::displacements_title(found);
  return tasks::find_displacements(
      found, gauges, [&](const Eigen::MatrixXd& block) { to << report::displacements_csv(block); }, control);
}

/// To a file whole or not at all, or to `out`.
std::size_t write_displacements(const std::string& target, const tasks::StrainResult& found, records::SampleStream& gauges,
                                std::ostream& out) {
  if (target == "-") return write_displacements(found, gauges, out);
  TemporaryFile file(target);
  std::ofstream to(file.path(), std::ios::binary);
  const std::size_t samples = write_displacements(found, gauges, to);
  to.close();
  if (!to) file.fail("the disk does not take it");
  file.commit();
  return samples;
}

}  // namespace

ExitCode execute(const SeriesStrainArguments& arguments, std::ostream& out) {
  check_targets({{arguments.file, "FILE"}},
                {{"--output", arguments.output}, {"--json", arguments.json}, {"--report", arguments.report}});
  const tasks::StrainResult found = tasks::run_strain(arguments);
  const auto gauges = tasks::open_gauges(found.task);
  std::size_t samples = 0;
  if (arguments.output) samples = write_displacements(*arguments.output, found, *gauges, out);
  if (arguments.json) write_target(*arguments.json, report::strain_json(found), out);
  if (arguments.report) write_target(*arguments.report, report::strain_page(found, report::strain_plots(found)), out);
  if (takes_output({arguments.output, arguments.json, arguments.report})) return ExitCode::done;
  out << report::strain_text(found);
  if (arguments.output) out << fmt::format("wrote {}: {} samples\n", *arguments.output, samples);
  return ExitCode::done;
}

}  // namespace jointid::cli
