#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/temporary_file.hpp"
#include "cli/options/output.hpp"
#include "cli/series/measured_records.hpp"
#include "cli/series/series_command.hpp"
#include "cli/text/interrupt.hpp"
#include "records/file/open_samples.hpp"
#include "report/json_value.hpp"
#include "report/text/table.hpp"
#include "series/measurement/strain.hpp"

namespace jointid::cli {
namespace {

using records::SampleStream;

constexpr Eigen::Index block_rows = 4096;

std::vector<double> points_of(const SeriesStrainArguments& arguments) {
  return arguments.points.empty() ? std::vector<double>{arguments.length} : arguments.points;
}

/// As many as gauges unless said.
std::size_t shapes_of(const SeriesStrainArguments& arguments) {
  return arguments.shapes > 0 ? arguments.shapes : arguments.gauges.size();
}

series::StrainMap map_of(const SeriesStrainArguments& arguments) {
  const std::size_t shapes = shapes_of(arguments);
  if (arguments.static_shapes && shapes < 2)
    throw InputError(
        {ErrorKind::usage, "", "--static-shapes", "are two, and the basis has one shape", "take more gauges, or leave it out"});
  return series::strain_map({arguments.length, arguments.thickness, arguments.gauges},
                            series::beam_basis(shapes, arguments.static_shapes), points_of(arguments));
}

std::string titles(const SeriesStrainArguments& arguments) {
  std::vector<std::string> row;
  for (const double x : points_of(arguments)) row.push_back(fmt::format("y({:g}) [m]", x));
  return report::csv_line(row);
}

/// Displacements block by block; each block's text goes to `write`.
template <class Write>
std::size_t convert(const SeriesStrainArguments& arguments, const series::StrainMap& map, SampleStream& stream,
                    const Write& write) {
  RowMatrixXd block(block_rows, map.matrix.cols());
  std::size_t samples = 0;
  write(titles(arguments));
  for (;;) {
    stop_if(interrupted);
    const std::size_t count = stream.read({block.data(), static_cast<std::size_t>(block.size())});
    if (count == 0) return samples;
    const Eigen::MatrixXd y = block.topRows(at(count)) * map.matrix.transpose();
    std::string text;
    for (Eigen::Index i = 0; i < y.rows(); ++i) {
      std::vector<std::string> row;
      for (Eigen::Index k = 0; k < y.cols(); ++k) row.push_back(report::csv_number(y(i, k)));
      text += report::csv_line(row);
    }
    write(text);
    samples += count;
  }
}

/// To a file whole or not at all, or to `out`.
std::size_t write_displacements(const SeriesStrainArguments& arguments, const series::StrainMap& map, SampleStream& stream,
                                std::ostream& out) {
  if (*arguments.output == "-") return convert(arguments, map, stream, [&](const std::string& text) { out << text; });
  TemporaryFile file(*arguments.output);
  std::ofstream to(file.path(), std::ios::binary);
  const std::size_t samples = convert(arguments, map, stream, [&](const std::string& text) { to << text; });
  to.close();
  if (!to) file.fail("the disk does not take it");
  file.commit();
  return samples;
}

std::string map_text(const SeriesStrainArguments& arguments, const series::StrainMap& map) {
  std::string text =
      fmt::format("{} gauges, {} shapes{}, condition {}\n", arguments.gauges.size(), shapes_of(arguments),
                  arguments.static_shapes ? " with those of a tip force and a tip moment" : "", report::number(map.condition));
  report::Table table({{"x m"}, {"noise, m rms per unit strain rms"}});
  const std::vector<double> points = points_of(arguments);
  for (std::size_t k = 0; k < points.size(); ++k) table.add({report::number(points[k]), report::number(map.noise(at(k)))});
  return text + table.text();
}

std::string map_json(const SeriesStrainArguments& arguments, const series::StrainMap& map) {
  report::Json out = {{"status", "ok"},
                      {"condition", report::value(map.condition)},
                      {"points", report::values(points_of(arguments))},
                      {"noise", report::values(std::vector<double>(map.noise.begin(), map.noise.end()))}};
  for (Eigen::Index k = 0; k < map.matrix.rows(); ++k) {
    const Eigen::VectorXd row = map.matrix.row(k);
    out["matrix"].push_back(report::values(std::vector<double>(row.begin(), row.end())));
  }
  return report::json_text(out);
}

}  // namespace

ExitCode execute(const SeriesStrainArguments& arguments, std::ostream& out) {
  check_series_targets(arguments.file, {{"--output", arguments.output}, {"--json", arguments.json}});
  const series::StrainMap map = map_of(arguments);
  const auto stream = records::open_samples(arguments.file, {arguments.channels, 0, 1});
  if (stream->channels().size() != arguments.gauges.size()) {
    throw InputError({ErrorKind::data, stream->file(), "",
                      fmt::format("has {} channels for {} gauges", stream->channels().size(), arguments.gauges.size()),
                      "name the channels of the gauges with --channels, in the order of --gauges"});
  }
  std::size_t samples = 0;
  if (arguments.output) samples = write_displacements(arguments, map, *stream, out);
  if (arguments.json) write_target(*arguments.json, map_json(arguments, map), out);
  if (takes_output({arguments.output, arguments.json})) return ExitCode::done;
  out << map_text(arguments, map);
  if (arguments.output) out << fmt::format("wrote {}: {} samples\n", *arguments.output, samples);
  return ExitCode::done;
}

}  // namespace jointid::cli
