#include "ident/likelihood/findings/chi_square.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace jointid::ident {
namespace {

/// The lines that say something of the joint, and how many of them are outlying.
struct UsedLines {
  std::size_t all = 0, outlying = 0;

  bool sets_aside() const { return 3 * outlying <= all; }
};

UsedLines used_lines(const LikelihoodFit& fit) {
  UsedLines out;
  for (const double weight : fit.line_weight) {
    out.all += weight > 0.0;
    out.outlying += weight > 0.0 && weight < 0.5;
  }
  return out;
}

}  // namespace

ChiSquare chi_square_of(const Observations& observations, const std::vector<ScaledPrior>& priors, const LikelihoodFit& fit) {
  const UsedLines lines = used_lines(fit);
  ChiSquare out{.outlying_lines = lines.outlying, .by_line = {}};
  for (std::size_t i = 0; i < fit.line_cost.size(); ++i) {
    const double redundancy = observations.lines()[i].redundancy(observations.layout());
    const bool used = fit.line_weight[i] > 0.0;
    out.by_line.push_back(used ? fit.line_cost[i] / redundancy : std::numeric_limits<double>::quiet_NaN());
    if (!used || (lines.sets_aside() && fit.line_weight[i] < 0.5)) continue;
    out.value += fit.line_cost[i];
    out.degrees_of_freedom += redundancy;
  }
  for (const auto& [column, value, weight] : priors) {
    out.value += weight * weight * (value - fit.theta[column]) * (value - fit.theta[column]);
    out.degrees_of_freedom += 1.0;
  }
  out.degrees_of_freedom -= static_cast<double>(fit.theta.size());
  return out;
}

double fitting_ratio(const ChiSquare& chi_square, const LikelihoodFit& fit) {
  constexpr double gross = 10.0;
  double sum = 0.0, count = 0.0;
  for (std::size_t i = 0; i < fit.line_weight.size(); ++i) {
    if (!(fit.line_weight[i] > 0.0 && chi_square.by_line[i] <= gross)) continue;
    sum += chi_square.by_line[i];
    ++count;
  }
  const double freedom = std::max(1.0, chi_square.degrees_of_freedom);
  if (!(2.0 * count > static_cast<double>(fit.line_weight.size()))) return chi_square.value / freedom;
  return sum / count * (freedom + static_cast<double>(fit.theta.size())) / freedom;
}

double excess_of(const ChiSquare& chi_square, const Observations& observations, const std::vector<double>& weights) {
  double excess = 0.0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const double by_line = chi_square.by_line[i];
    if (weights[i] > 0.0 && std::isfinite(by_line))
      excess += weights[i] * (by_line - 1.0) * observations.lines()[i].redundancy(observations.layout());
  }
  return excess;
}

}  // namespace jointid::ident
