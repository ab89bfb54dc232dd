#include "tasks/series/strain.hpp"

#include <fmt/format.h>

#include "base/control.hpp"
#include "base/eigen.hpp"
#include "base/error.hpp"
#include "records/file/open_samples.hpp"
#include "tasks/tell.hpp"

namespace jointid::tasks {
namespace {

oscillation::StrainMap map_of(const StrainTask& task) {
  if (task.static_shapes && task.shapes < 2)
    throw InputError(
        {ErrorKind::usage, "", "--static-shapes", "are two, and the basis has one shape", "take more gauges, or leave it out"});
  return oscillation::strain_map({task.length, task.thickness, task.gauges}, oscillation::beam_basis(task.shapes, task.static_shapes),
                            task.points);
}

/// Displacements of the next samples, [samples, points]; no rows at the end.
Eigen::MatrixXd next_displacements(records::SampleStream& stream, const oscillation::StrainMap& map, std::size_t samples) {
  RowMatrixXd block(at(samples), map.matrix.cols());
  const std::size_t count = stream.read({block.data(), static_cast<std::size_t>(block.size())});
  return block.topRows(at(count)) * map.matrix.transpose();
}

}  // namespace

StrainResult run_strain(const StrainTask& task) {
  StrainResult out;
  out.task = task;
  if (out.task.points.empty()) out.task.points = {task.length};
  if (out.task.shapes == 0) out.task.shapes = task.gauges.size();
  out.map = map_of(out.task);
  return out;
}

std::unique_ptr<records::SampleStream> open_gauges(const StrainTask& task) {
  auto stream = records::open_samples(task.file, {task.channels, 0, 1});
  if (stream->channels().size() != task.gauges.size()) {
    throw InputError({ErrorKind::data, stream->file(), "",
                      fmt::format("has {} channels for {} gauges", stream->channels().size(), task.gauges.size()),
                      "name the channels of the gauges with --channels, in the order of --gauges"});
  }
  return stream;
}

std::size_t find_displacements(const StrainResult& found, records::SampleStream& gauges,
                               const std::function<void(const Eigen::MatrixXd& block)>& take, const ident::Control& control) {
  constexpr std::size_t block_rows = 4096;
  for (std::size_t samples = 0;;) {
    stop_if(control.interrupted);
    tell(control, "displacements", samples);
    const Eigen::MatrixXd y = next_displacements(gauges, found.map, block_rows);
    if (y.rows() == 0) return samples;
    take(y);
    samples += static_cast<std::size_t>(y.rows());
  }
}

FirstDisplacements first_displacements(const StrainResult& found, std::size_t most) {
  const auto gauges = open_gauges(found.task);
  Eigen::MatrixXd first = next_displacements(*gauges, found.map, most);
  return {std::move(first), gauges->rate_hz()};
}

}  // namespace jointid::tasks
