#include "tasks/modalfit/mode_indicators.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/control.hpp"
#include "base/eigen.hpp"
#include "dense/svd.hpp"

namespace jointid::tasks {
namespace {

constexpr std::size_t most_references = 12;

std::vector<std::size_t> selected_references(std::size_t references) {
  const std::size_t count = std::min(references, most_references);
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < count; ++i) out.push_back(i * references / count);
  return out;
}

Eigen::VectorXd singular_values_at(const FrfMatrix& frfs, const std::vector<std::size_t>& references, std::size_t line) {
  Eigen::MatrixXcd h(at(frfs.responses), at(references.size()));
  for (std::size_t r = 0; r < frfs.responses; ++r) {
    for (std::size_t c = 0; c < references.size(); ++c) {
      const std::complex<double> value = frfs.receptance(r, references[c], line);
      h(at(r), at(c)) = std::isfinite(std::abs(value)) ? value : 0.0;
    }
  }
  return dense::svd(h, dense::Vectors::none, dense::Vectors::none).sigma;
}

}  // namespace

std::vector<std::vector<double>> mode_indicators(const FrfMatrix& frfs, const std::vector<std::size_t>& lines, std::size_t count,
                                                 const std::function<bool()>& interrupted) {
  const std::vector<std::size_t> references = selected_references(frfs.references);
  std::vector<std::vector<double>> out(std::min({count, frfs.responses, references.size()}));
  for (const std::size_t line : lines) {
    stop_if(interrupted);
    const Eigen::VectorXd sigma = singular_values_at(frfs, references, line);
    for (std::size_t i = 0; i < out.size(); ++i) {
      const double value = sigma(at(i));
      out[i].push_back(value > 0.0 ? value : std::numeric_limits<double>::quiet_NaN());
    }
  }
  return out;
}

}  // namespace jointid::tasks
