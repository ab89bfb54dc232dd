#include "modalfit/poles/refine.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "base/eigen.hpp"
#include "dense/cholesky.hpp"
#include "minimise/damping.hpp"
#include "modalfit/band/normal_block.hpp"

namespace jointid::modalfit {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Entries per partial sum, so that sums do not depend on the number of threads.
constexpr std::size_t entries_at_once = 8;

struct Sums {
  MatrixXd curvature;
  VectorXd gradient;
  double cost = 0.0, freedom = 0.0;
};

Sums zero(Index parameters) { return {MatrixXd::Zero(parameters, parameters), VectorXd::Zero(parameters), 0.0, 0.0}; }

void add(const NormalBlock& block, const RealBasis& basis, Sums& sums) {
  if (basis.modes > 0) {
    const auto terms = block.pole_terms(basis);
    sums.curvature += terms.curvature;
    sums.gradient += terms.gradient;
  }
  sums.cost += block.cost();
  sums.freedom += block.equations() - (block.equations() > 0.0 ? static_cast<double>(basis.columns.cols()) : 0.0);
}

class Problem {
 public:
  Problem(const Band& band, const std::vector<std::size_t>& entries, const ModelKind& kind) : band_(band), entries_(entries), kind_(kind) {}

  Sums linearise(const std::vector<Pole>& poles) const {
    const RealBasis basis(make_basis(kind_, poles, band_.frequency_hz, band_.scale_hz(), true));
    const Index parameters = 2 * at(poles.size());
    std::vector<Sums> parts((entries_.size() + entries_at_once - 1) / entries_at_once, zero(parameters));
    tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t i) {
      const std::size_t last = std::min(entries_.size(), (i + 1) * entries_at_once);
      for (std::size_t k = i * entries_at_once; k < last; ++k) add(NormalBlock(basis, band_, entries_[k]), basis, parts[i]);
    });
    Sums sums = zero(parameters);
    for (const Sums& part : parts) {
      sums.curvature += part.curvature;
      sums.gradient += part.gradient;
      sums.cost += part.cost;
      sums.freedom += part.freedom;
    }
    sums.freedom -= static_cast<double>(parameters);
    return sums;
  }

 private:
  const Band& band_;
  const std::vector<std::size_t>& entries_;
  ModelKind kind_;
};

/// A peak this much narrower than the space between two lines cannot be told from a narrower one.
constexpr double narrowest_peak = 1e-3;
constexpr double most_damping = 0.95;
/// Of residuals over σ; data without noise have less, as σ is not below rounding.
constexpr double least_mean_square = 1e-2;
/// Of ln f and damping: below it a pole cannot be told from its neighbours in double precision.
constexpr double least_step = 1e-14;

double least_damping(const Pole& pole, double spacing_hz) { return narrowest_peak * spacing_hz / pole.frequency_hz; }

/// A step in ln f and damping; damping grows at most by a factor of three at a time.
std::vector<Pole> moved(std::vector<Pole> poles, const VectorXd& step, double spacing_hz) {
  for (std::size_t r = 0; r < poles.size(); ++r) {
    const auto at = static_cast<Index>(2 * r);
    poles[r].frequency_hz *= std::exp(std::clamp(step(at), -0.1, 0.1));
    const double least = least_damping(poles[r], spacing_hz);
    poles[r].damping = std::clamp(poles[r].damping + step(at + 1), std::max(least, poles[r].damping / 3.0),
                                  std::max(2.0 * least, std::min(most_damping, poles[r].damping * 3.0)));
  }
  return poles;
}

/// Levenberg–Marquardt step; a damping that stands at its least and would fall stays.
VectorXd damped_step(const Sums& at, const std::vector<Pole>& poles, double spacing_hz, double mu) {
  MatrixXd damped = at.curvature;
  VectorXd gradient = at.gradient;
  damped.diagonal() *= 1.0 + mu;
  for (std::size_t r = 0; r < poles.size(); ++r) {
    const auto own = static_cast<Index>(2 * r + 1);
    if (gradient(own) >= 0.0 || poles[r].damping > 1.001 * least_damping(poles[r], spacing_hz)) continue;
    gradient(own) = 0.0;
    damped.row(own).setZero();
    damped.col(own).setZero();
    damped(own, own) = 1.0;
  }
  return dense::solve_symmetric(damped, gradient);
}

bool all_finite(const std::vector<Pole>& poles) {
  return std::ranges::all_of(poles, [](const Pole& pole) { return std::isfinite(pole.frequency_hz) && std::isfinite(pole.damping); });
}

}  // namespace

RefinedPoles refine(const Band& band, const std::vector<std::size_t>& entries, const ModelKind& kind, std::vector<Pole> start,
                    const RefineOptions& options, const std::function<bool()>& stop) {
  RefinedPoles out{.poles = std::move(start), .covariance = {}};
  const Problem problem(band, entries, kind);
  Sums at = problem.linearise(out.poles);
  const auto parameters = at.gradient.size();
  const double spacing_hz = (band.frequency_hz.back() - band.frequency_hz.front()) / static_cast<double>(band.lines() - 1);
  minimise::Damping damping({.first = 1e-3, .least = 0.0, .most = 1e8, .again = 1e-3});
  while (parameters > 0 && out.iterations < options.most_iterations && !(stop && stop())) {
    ++out.iterations;
    const VectorXd newton = damped_step(at, out.poles, spacing_hz, 0.0);
    const double mean_square = std::max(least_mean_square, at.cost / std::max(1.0, at.freedom));
    const double small = options.step * options.step * static_cast<double>(parameters) * mean_square;
    out.converged = std::abs(newton.dot(at.gradient)) <= small || newton.cwiseAbs().maxCoeff() <= least_step;
    if (out.converged) break;
    const std::vector<Pole> trial = moved(out.poles, damped_step(at, out.poles, spacing_hz, damping.value()), spacing_hz);
    Sums next = all_finite(trial) ? problem.linearise(trial) : at;
    if (next.cost < at.cost) {
      out.poles = trial;
      at = std::move(next);
      damping.less();
    } else {
      if (damping.is_spent()) break;
      damping.more();
    }
  }
  out.cost = at.cost;
  out.freedom = at.freedom;
  if (parameters == 0) return out;
  const MatrixXd covariance = dense::solve_symmetric(at.curvature, MatrixXd::Identity(parameters, parameters));
  out.covariance.assign(covariance.data(), covariance.data() + covariance.size());
  return out;
}

}  // namespace jointid::modalfit
