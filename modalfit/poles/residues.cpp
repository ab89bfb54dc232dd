#include "modalfit/poles/residues.hpp"

#include <tbb/parallel_for.h>

#include "dense/cholesky.hpp"
#include "modalfit/band/normal_block.hpp"

namespace jointid::modalfit {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Three standard deviations.
constexpr double bounded_square = 9.0;

/// diag(J C Jᵀ) with J = ∂c/∂θ = −(XᵀW²X)⁻¹XᵀW²D: what the poles' covariance adds.
VectorXd pole_share(const NormalBlock& block, const RealBasis& basis, const MatrixXd& covariance) {
  const MatrixXd slope = block.solve(block.pole_terms(basis).cross);
  return (slope * covariance).cwiseProduct(slope).rowwise().sum();
}

/// What leaving out each mode would add to the cost.
void fill_growth(const VectorXd& coefficients, const MatrixXd& covariance, Index per_mode, double* growth) {
  for (Index mode = 0; mode * per_mode + 4 < coefficients.size(); ++mode) {
    const VectorXd own = coefficients.segment(mode * per_mode, per_mode);
    const MatrixXd block = covariance.block(mode * per_mode, mode * per_mode, per_mode, per_mode);
    if (block.diagonal().minCoeff() > 0.0) growth[mode] = own.dot(dense::solve_symmetric(block, own).col(0));
  }
}

}  // namespace

Residues fit_residues(const Band& band, const std::vector<std::size_t>& entries, const ModelKind& kind, const std::vector<Pole>& poles,
                      const std::vector<double>& pole_covariance) {
  const bool with_poles = !pole_covariance.empty();
  const RealBasis basis(make_basis(kind, poles, band.frequency_hz, band.scale_hz(), with_poles));
  const Index columns = basis.columns.cols(), parameters = 2 * basis.modes;
  const MatrixXd covariance =
      with_poles ? MatrixXd(Eigen::Map<const MatrixXd>(pole_covariance.data(), parameters, parameters)) : MatrixXd();
  const std::size_t size = static_cast<std::size_t>(columns), count = entries.size();
  Residues out{size, 1.0, std::vector<double>(count * size), std::vector<double>(count * size), std::vector<double>(count),
               std::vector<double>(count), std::vector<double>(count), std::vector<double>(poles.size())};
  std::vector<double> growth(count * poles.size());
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t k) {
    const NormalBlock block(basis, band, entries[k]);
    if (block.equations() == 0.0) return;
    const MatrixXd inverse = block.solve(MatrixXd::Identity(columns, columns));
    VectorXd variance = inverse.diagonal();
    if (with_poles) variance += pole_share(block, basis, covariance);
    Eigen::Map<VectorXd>(out.coefficients.data() + k * size, columns) = block.coefficients();
    Eigen::Map<VectorXd>(out.variance.data() + k * size, columns) = variance;
    out.cost[k] = block.cost();
    out.bounded_cost[k] = block.residual().cwiseAbs2().cwiseMin(bounded_square).sum();
    out.freedom[k] = std::max(0.0, block.equations() - static_cast<double>(columns));
    fill_growth(block.coefficients(), inverse, basis.per_mode, growth.data() + k * poles.size());
  });
  for (std::size_t i = 0; i < growth.size(); ++i) out.growth[i % poles.size()] += growth[i];
  return out;
}

}  // namespace jointid::modalfit
