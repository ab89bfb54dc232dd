#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ident/result/control.hpp"
#include "oscillation/measurement/strain.hpp"
#include "records/file/sample_stream.hpp"

namespace jointid::tasks {

/// Displacements of a clamped beam from strain gauges, as they are asked for.
struct StrainTask {
  std::filesystem::path file;
  std::vector<std::string> channels;     ///< of the gauges; empty: all but the time
  double length = 0.0, thickness = 0.0;  ///< m
  std::vector<double> gauges, points;    ///< m from the clamp; no points: the tip
  std::size_t shapes = 0;                ///< 0: as many as gauges
  bool static_shapes = false;            ///< two of them are of a tip force and a tip moment
};

/// What run_strain() finds.
struct StrainResult {
  StrainTask task;        ///< points and shapes filled in
  oscillation::StrainMap map;  ///< displacements [points] = matrix · strains [gauges], m per unit strain
};

/// The map; reads nothing. Throws InputError.
StrainResult run_strain(const StrainTask& task);

/// The gauges' channels. Throws InputError where they are not as many as the gauges.
std::unique_ptr<records::SampleStream> open_gauges(const StrainTask& task);

/// Displacements of all samples of the gauges, a block [samples, points] at a time, m. Returns how many samples there were. The
/// progress is told the samples done, of 0, as nobody knows how many there are. Throws InputError, and Interrupted between
/// blocks.
std::size_t find_displacements(const StrainResult& found, records::SampleStream& gauges,
                               const std::function<void(const Eigen::MatrixXd& block)>& take, const ident::Control& control = {});

/// Those of the first samples, at most `most`, and the rate where the file states one.
struct FirstDisplacements {
  Eigen::MatrixXd displacements;  ///< [samples, points], m
  std::optional<double> rate_hz;
};
FirstDisplacements first_displacements(const StrainResult& found, std::size_t most);

}  // namespace jointid::tasks
