#include "cli/report/cmif.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/eigen.hpp"
#include "cli/report/decimate.hpp"
#include "dense/svd.hpp"

namespace jointid::cli::report {
namespace {

constexpr std::size_t most_references = 12;

/// Norm of all receptances, line by line.
std::vector<double> receptance_norms(const modalfit::Band& band) {
  std::vector<double> squares(band.lines(), 0.0);
  for (std::size_t e = 0; e < band.entries(); ++e) {
    for (std::size_t line = 0; line < band.lines(); ++line) squares[line] += std::norm(band.value(e)[line]);
  }
  for (double& square : squares) square = std::sqrt(square);
  return squares;
}

std::vector<std::size_t> selected_references(std::size_t references) {
  const std::size_t count = std::min(references, most_references);
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < count; ++i) out.push_back(i * references / count);
  return out;
}

Eigen::VectorXd singular_values_at(const modalfit::Band& band, const std::vector<std::size_t>& references, std::size_t line) {
  Eigen::MatrixXcd h(at(band.responses), at(references.size()));
  for (std::size_t r = 0; r < band.responses; ++r) {
    for (std::size_t c = 0; c < references.size(); ++c) {
      h(at(r), at(c)) = band.value(r * band.references + references[c])[line];
    }
  }
  return dense::svd(h, dense::Vectors::none, dense::Vectors::none).sigma;
}

}  // namespace

Backdrop mode_indicators(const modalfit::Band& band, std::size_t count, std::size_t most) {
  const std::vector<std::size_t> references = selected_references(band.references);
  const std::size_t shown = std::min({count, band.responses, references.size()});
  const std::vector<std::size_t> kept = keep_peaks(std::vector<std::vector<double>>{receptance_norms(band)}, most);
  Backdrop out{{"CMIF (m/N)", true}, picked(band.frequency_hz, kept), {}};
  for (std::size_t i = 0; i < shown; ++i) {
    out.series.push_back({shown == 1 ? std::string("CMIF") : "CMIF " + std::to_string(i + 1), {}, Style::reference});
  }
  for (const std::size_t line : kept) {
    const Eigen::VectorXd sigma = singular_values_at(band, references, line);
    for (std::size_t i = 0; i < shown; ++i) {
      const double value = sigma(at(i));
      out.series[i].y.push_back(value > 0.0 ? value : std::numeric_limits<double>::quiet_NaN());
    }
  }
  return out;
}

}  // namespace jointid::cli::report
