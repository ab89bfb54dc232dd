#include "modalfit/band/inputs.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <numeric>

#include "base/eigen.hpp"

namespace jointid::modalfit {
namespace {

/// Inner products take at most about this many terms per pair.
constexpr std::size_t most_terms = 20'000;

std::complex<double> weighted(const Band& band, std::size_t entry, std::size_t line) {
  const double* weight = band.weights(entry) + 2 * line;
  const std::complex<double> value = band.value(entry)[line];
  return {value.real() * weight[0], value.imag() * weight[1]};
}

Eigen::MatrixXd inner_products(const Band& band, const InputChoice& all) {
  const auto count = at(all.inputs.size());
  const std::size_t step = std::max<std::size_t>(1, all.outputs * band.lines() / most_terms);
  std::vector<std::size_t> at;
  for (std::size_t k = 0; k < all.outputs * band.lines(); k += step) at.push_back(k);
  Eigen::MatrixXcd samples(jointid::at(at.size()), count);
  for (Eigen::Index c = 0; c < count; ++c) {
    for (std::size_t k = 0; k < at.size(); ++k) {
      samples(jointid::at(k), c) =
          weighted(band, all.entry(band, at[k] / band.lines(), static_cast<std::size_t>(c)), at[k] % band.lines());
    }
  }
  return (samples.adjoint() * samples).real();
}

}  // namespace

InputChoice choose_inputs(const Band& band, std::size_t most) {
  InputChoice choice;
  choice.transposed = band.references > band.responses;
  choice.outputs = std::max(band.references, band.responses);
  choice.inputs.resize(std::min(band.references, band.responses));
  std::iota(choice.inputs.begin(), choice.inputs.end(), std::size_t{0});
  if (choice.inputs.size() <= most) return choice;
  Eigen::MatrixXd gram = inner_products(band, choice);
  std::vector<std::size_t> chosen;
  while (chosen.size() < most) {
    Eigen::Index pivot = 0;
    const double largest = gram.diagonal().maxCoeff(&pivot);
    if (!(largest > 0.0) && !chosen.empty()) break;
    chosen.push_back(static_cast<std::size_t>(pivot));
    const Eigen::VectorXd column = gram.col(pivot);
    if (largest > 0.0) gram -= column * column.transpose() / largest;
    gram.diagonal()(pivot) = 0.0;
  }
  choice.inputs = std::move(chosen);
  return choice;
}

}  // namespace jointid::modalfit
