#include "oscillation/pod/pod.hpp"

#include <cmath>

#include "base/error.hpp"
#include "base/statistics.hpp"
#include "dense/cholesky.hpp"
#include "dense/svd.hpp"

namespace jointid::oscillation {
namespace {

Eigen::VectorXd shares(const Eigen::VectorXd& parts) {
  Eigen::VectorXd out(parts.size());
  double sum = 0.0;
  for (Eigen::Index i = 0; i < parts.size(); ++i) out(i) = sum += parts(i);
  return sum > 0.0 ? Eigen::VectorXd(out / sum) : out;
}

/// L of M = LLᵀ; empty for the plain inner product.
Eigen::MatrixXd factor(const Eigen::MatrixXd& mass, Eigen::Index channels) {
  if (mass.size() == 0) return {};
  const auto wrong = [](const std::string& problem) {
    return InputError({ErrorKind::data, "", "mass matrix", problem, "give the mass matrix of the channels, in their order"});
  };
  if (mass.rows() != channels || mass.cols() != channels) {
    throw wrong("is " + std::to_string(mass.rows()) + " by " + std::to_string(mass.cols()) + " for " + std::to_string(channels) +
                " channels");
  }
  const auto lower = dense::cholesky(mass);
  if (!lower) throw wrong("is not positive definite");
  return lower->triangularView<Eigen::Lower>();
}

void turn_largest_positive(Eigen::MatrixXd& modes) {
  for (Eigen::Index k = 0; k < modes.cols(); ++k) {
    Eigen::Index largest = 0;
    modes.col(k).cwiseAbs().maxCoeff(&largest);
    if (modes(largest, k) < 0.0) modes.col(k) *= -1.0;
  }
}

}  // namespace

Eigen::VectorXd Pod::square_fractions() const { return shares(sigma.array().square()); }

Eigen::VectorXd Pod::sigma_fractions() const { return shares(sigma); }

std::size_t Pod::modes_for(double share) const {
  const Eigen::VectorXd fractions = square_fractions();
  std::size_t count = 1;
  while (count < static_cast<std::size_t>(fractions.size()) && fractions(at(count) - 1) < share) ++count;
  return count;
}

Pod pod(const RecordTriangle& record, const PodOptions& options) {
  if (record.samples() == 0) {
    throw InputError(
        {ErrorKind::data, "", "record", "has no sample with all channels", "leave out channels that are never there"});
  }
  Pod out;
  out.samples = record.samples();
  out.missing = record.missing();
  out.mean = options.remove_mean ? record.mean() : Eigen::VectorXd::Zero(at(record.channels()));
  Eigen::MatrixXd triangle = options.remove_mean ? record.centred() : record.uncentred();
  const Eigen::MatrixXd lower = factor(options.mass, triangle.cols());
  if (lower.size() > 0) triangle = triangle * lower;
  dense::RealSvd svd = dense::jacobi_svd(triangle, dense::Vectors::none, dense::Vectors::full);
  out.modes = std::move(svd.v);
  if (lower.size() > 0) dense::solve_lower_transposed(lower, out.modes);
  turn_largest_positive(out.modes);
  out.sigma = std::move(svd.sigma);
  out.values = out.sigma.array().square() / static_cast<double>(out.samples);
  return out;
}

Pod pod(const Eigen::Ref<const Samples>& record, const PodOptions& options) {
  RecordTriangle triangle(static_cast<std::size_t>(record.cols()));
  triangle.add(record);
  return pod(triangle, options);
}

Eigen::MatrixXd pod_coordinates(const Pod& pod, const Eigen::Ref<const Samples>& block, std::size_t count,
                                const PodOptions& options) {
  Eigen::MatrixXd weighted = pod.modes.leftCols(at(count));
  if (options.mass.size() > 0) weighted = options.mass * weighted;
  return (block.rowwise() - pod.mean.transpose()) * weighted;
}

std::optional<std::size_t> rank_above_noise(const Pod& pod) {
  if (pod.sigma.size() < 8 || pod.samples < static_cast<std::size_t>(pod.sigma.size())) return std::nullopt;
  const double beta = static_cast<double>(pod.sigma.size()) / static_cast<double>(pod.samples);
  const double factor = ((0.56 * beta - 0.95) * beta + 1.82) * beta + 1.43;
  const double threshold = factor * median(std::vector<double>(pod.sigma.begin(), pod.sigma.end()));
  std::size_t rank = 0;
  while (rank < static_cast<std::size_t>(pod.sigma.size()) && pod.sigma(at(rank)) > threshold) ++rank;
  return rank;
}

}  // namespace jointid::oscillation
