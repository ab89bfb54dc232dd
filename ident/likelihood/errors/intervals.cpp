#include "ident/likelihood/errors/intervals.hpp"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

#include "base/eigen.hpp"
#include "base/statistics.hpp"
#include "minimise/linear/covariance.hpp"

namespace jointid::ident {

Intervals::Intervals(Eigen::MatrixXd covariance)
    : first_(covariance.diagonal().cwiseSqrt()), width_(Eigen::VectorXd::Zero(covariance.rows())),
      quantile_(Eigen::VectorXd::Constant(covariance.rows(), normal_95)) {
  cases_.push_back({Eigen::VectorXd::Zero(covariance.rows()), std::move(covariance)});
}

void Intervals::add_gain(const FileGain& gain) {
  const Eigen::VectorXd answer = gain.answer.head(first_.size());
  const std::size_t count = cases_.size();
  for (std::size_t i = 0; i < count; ++i) {
    cases_.push_back({cases_[i].shift + gain.posterior_mean() * answer,
                      cases_[i].covariance + gain.posterior_variance() * answer * answer.transpose()});
  }
}

void Intervals::add_shared(const SharedErrors& shared, const Eigen::MatrixXd& information) {
  const Eigen::MatrixXd scatter = shared.scatter();
  if (scatter.size() == 0) return;
  const Eigen::MatrixXd inverse = minimise::covariance_of(information);
  const Eigen::MatrixXd more = (inverse * scatter * inverse).topLeftCorner(first_.size(), first_.size());
  for (Case& each : cases_) each.covariance += more;
}

void Intervals::add_bias(const std::vector<Eigen::VectorXd>& shifts, const Eigen::MatrixXd& scatter) {
  const std::size_t count = cases_.size();
  Eigen::VectorXd low = Eigen::VectorXd::Zero(first_.size()), high = low;
  for (const Eigen::VectorXd& shift : shifts) {
    for (std::size_t i = 0; i < count; ++i) {
      cases_.push_back({cases_[i].shift + shift, cases_[i].covariance});
      if (scatter.size() > 0) cases_.back().covariance += scatter;
    }
    low = low.cwiseMin(shift);
    high = high.cwiseMax(shift);
  }
  width_ += high - low;
}

void Intervals::widen_to(const Eigen::VectorXd& deviation, const Eigen::VectorXd& freedom) {
  const Eigen::VectorXd now = covariance().diagonal().cwiseSqrt();
  Eigen::VectorXd factor(first_.size());
  for (Eigen::Index u = 0; u < first_.size(); ++u) {
    const double t = boost::math::quantile(boost::math::students_t_distribution<double>(freedom[u]), 0.975);
    const double scattered = deviation[u] / now[u];
    factor[u] = std::max(1.0, scattered);
    quantile_[u] = std::max(normal_95, std::max(t * scattered, quantile_[u]) / factor[u]);
  }
  for (Case& each : cases_) each.covariance = factor.asDiagonal() * each.covariance * factor.asDiagonal();
}

void Intervals::include_misfit(const Jackknife& jackknife, double inflation) {
  for (Case& each : cases_) each.covariance *= inflation * inflation;
  widen_to(jackknife.variance.cwiseSqrt(), Eigen::VectorXd::Constant(first_.size(), static_cast<double>(jackknife.blocks) - 1.0));
  add_bias({jackknife.step.head(first_.size())}, {});
}

void Intervals::include_sensors(const SensorScatter& sensors) {
  widen_to(sensors.variance.head(first_.size()).cwiseSqrt(), sensors.freedom);
}

const Eigen::MatrixXd& Intervals::covariance() const { return cases_.front().covariance; }

/// By bisection between the quantiles of two ends and of one.
double Intervals::quantile(Eigen::Index unknown) const {
  constexpr double covered = 0.95;
  const boost::math::normal_distribution<double> normal;
  double deviation = 0.0;
  for (const Case& each : cases_) deviation = std::max(deviation, std::sqrt(each.covariance(unknown, unknown)));
  const double wide = quantile_[unknown] / normal_95, width = width_[unknown] / (wide * deviation);
  if (!(width > 1e-3)) return quantile_[unknown];
  double low = 0.0, high = normal_95;
  while (high - low > 1e-9) {
    const double middle = 0.5 * (low + high);
    (boost::math::cdf(normal, middle + width) - boost::math::cdf(normal, -middle) < covered ? low : high) = middle;
  }
  return wide * high;
}

std::array<double, 2> Intervals::ends(Eigen::Index unknown) const {
  std::array<double, 2> out = {0.0, 0.0};
  const double quantile = this->quantile(unknown);
  for (const Case& each : cases_) {
    const double half = quantile * std::sqrt(each.covariance(unknown, unknown));
    out = {std::min(out[0], each.shift[unknown] - half), std::max(out[1], each.shift[unknown] + half)};
  }
  return out;
}

Eigen::VectorXd Intervals::half_widths() const { return quantile_.cwiseProduct(covariance().diagonal().cwiseSqrt()); }

double Intervals::cost() const {
  double cost = 1.0;
  for (Eigen::Index u = 0; u < first_.size(); ++u) {
    const auto [low, high] = ends(u);
    if (first_[u] > 0.0) cost = std::max(cost, (high - low) / (2.0 * normal_95 * first_[u]));
  }
  return cost;
}

void Intervals::state(const Plan& plan, Solution& out) const {
  out.intervals = IntervalKind::cramer_rao;
  const Eigen::MatrixXd& own = covariance();
  for (std::size_t column = 0; column < out.unknowns.size(); ++column) {
    Estimate& estimate = out.unknowns[column];
    if (!estimate.determined) continue;
    const auto c = at(column);
    const double unit = plan.unscale(column);
    const auto [low, high] = ends(c);
    estimate.std_error = std::sqrt(own(c, c)) * unit;
    if (cases_.size() == 1) {
      const double half = quantile_[c] * *estimate.std_error;
      estimate.ci95 = {estimate.value - half, estimate.value + half};
    } else {
      estimate.ci95 = {estimate.value + low * unit, estimate.value + high * unit};
    }
  }
}

}  // namespace jointid::ident
