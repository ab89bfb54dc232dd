#include "report/modalfit/band_indicators.hpp"

#include <cmath>

#include "report/decimate.hpp"
#include "tasks/modalfit/mode_indicators.hpp"

namespace jointid::report {
namespace {

/// Norm of all receptances, line by line.
std::vector<double> receptance_norms(const modalfit::Band& band) {
  std::vector<double> squares(band.lines(), 0.0);
  for (std::size_t e = 0; e < band.entries(); ++e) {
    for (std::size_t line = 0; line < band.lines(); ++line) squares[line] += std::norm(band.value(e)[line]);
  }
  for (double& square : squares) square = std::sqrt(square);
  return squares;
}

}  // namespace

Backdrop band_indicators(const modalfit::Band& band, std::size_t count, std::size_t most) {
  const std::vector<std::size_t> kept = keep_peaks(std::vector<std::vector<double>>{receptance_norms(band)}, most);
  const auto receptance = [&](std::size_t response, std::size_t reference, std::size_t line) {
    return band.value(response * band.references + reference)[line];
  };
  Backdrop out{{"CMIF (m/N)", true}, picked(band.frequency_hz, kept), {}};
  for (auto& values : tasks::mode_indicators({band.responses, band.references, receptance}, kept, count)) {
    out.series.push_back({"CMIF " + std::to_string(out.series.size() + 1), std::move(values), Style::reference});
  }
  if (out.series.size() == 1) out.series.front().name = "CMIF";
  return out;
}

}  // namespace jointid::report
