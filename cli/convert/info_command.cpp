#include "cli/convert/info_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "base/text.hpp"
#include "cli/options/command_options.hpp"
#include "cli/options/open_options.hpp"
#include "report/text/frf_summary.hpp"
#include "cli/text/interrupt.hpp"
#include "cli/text/progress.hpp"
#include "frf/file/file_format.hpp"
#include "frf/uff/uff_file.hpp"
#include "report/text/table.hpp"

namespace jointid::cli {
namespace {

std::string datasets_text(const frf::UffSummary& summary) {
  std::string text = "  datasets";
  for (const auto& [dataset, count] : summary.datasets) text += fmt::format("  {} × {}", count, dataset);
  return text + "\n";
}

/// Records of one kind (function, quantity, units, points) are one row.
std::string records_text(const frf::UffSummary& summary) {
  std::vector<std::pair<std::vector<std::string>, std::size_t>> kinds;
  for (const auto& record : summary.functions) {
    const std::string unit = printable(record.unit);
    const std::vector<std::string> kind = {record.dataset, record.function, record.quantity, unit.empty() ? "–" : unit,
                                           fmt::format("{}", record.points)};
    const auto found = std::ranges::find(kinds, kind, [](const auto& known) { return known.first; });
    if (found == kinds.end()) {
      kinds.emplace_back(kind, 1);
    } else {
      ++found->second;
    }
  }
  report::Table table({{"records"},
                       {"dataset", report::Align::left},
                       {"function", report::Align::left},
                       {"quantity", report::Align::left},
                       {"unit", report::Align::left},
                       {"points"}});
  for (const auto& [kind, count] : kinds) {
    table.add({fmt::format("{}", count), kind[0], kind[1], kind[2], kind[3], kind[4]});
  }
  return table.text();
}

/// What is put right on reading, and what looks wrong, a line each.
std::string notes_text(const frf::FrfHeader& header) {
  std::string text;
  for (const auto* notes : {&header.changes, &header.doubts}) {
    for (const std::string& note : *notes) text += "  note: " + printable(note) + "\n";
  }
  return text;
}

}  // namespace

void add_info(CLI::App& app, Chosen& chosen) {
  auto [command, arguments] = add_command<InfoArguments>(app, chosen, "info", "Show the content of an FRF file");
  command->add_option("FILE", arguments->file, "UFF, HDF5, MAT, numpy (.npz, .npy), CSV or text export of an analyser")
      ->required();
  add_open_options(command, arguments->open);
  command->footer("Example:\n  jointid info beam_long.uff");
}

ExitCode execute(const InfoArguments& arguments, std::ostream& out) {
  const frf::FileFormat format = frf::detect_format(arguments.file);
  out << printable(arguments.file.string()) << ": " << frf::name(format) << '\n';
  if (format == frf::FileFormat::uff) {
    const frf::UffSummary summary = frf::summarize_uff(arguments.file);
    out << datasets_text(summary) << records_text(summary);
  }
  const auto source = frf::open(arguments.file, arguments.open);
  const tasks::FrfCensus census = with_progress("reading", [&] { return tasks::take_census(*source, interrupted); });
  out << "FRFs\n" << report::summary_text(source->header(), census) << notes_text(source->header());
  return census.complete ? ExitCode::done : ExitCode::interrupted;
}

}  // namespace jointid::cli
