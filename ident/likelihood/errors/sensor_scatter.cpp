#include "ident/likelihood/errors/sensor_scatter.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/eigen.hpp"
#include "base/random.hpp"
#include "dense/cholesky.hpp"
#include "ident/likelihood/data/likelihood_plan.hpp"
#include "ident/likelihood/errors/error_trials.hpp"
#include "ident/likelihood/errors/line_scores.hpp"

namespace jointid::ident {
namespace {

constexpr std::size_t least_sensors = 3;

/// Response and reference coordinates, each with all files.
struct Sensors {
  SystematicPlan plan;
  std::array<std::size_t, 2> count = {0, 0};  ///< of responses, of references

  std::size_t size() const { return count[0] + count[1]; }
};

Sensors sensors_of(const Plan& plan) {
  Sensors out;
  for (const bool is_reference : {false, true}) {
    for (const frf::Dof& dof : likelihood_plan(plan)->observations->layout().coordinates) {
      std::vector<SensorRole> roles;
      for_each_file(plan, [&](bool of_assembly, std::size_t file, const frf::FrfHeader& header) {
        if (frf::has(is_reference ? header.reference : header.response, dof)) roles.push_back({of_assembly, file, is_reference, dof});
      });
      if (roles.empty()) continue;
      out.plan.add({{Systematic::gain, 1.0}, dof.name(), "", 0.0}, roles);
      ++out.count[is_reference ? 1 : 0];
    }
  }
  return out;
}

/// A standard deviation of either sign in real and imaginary part.
Complex probe(std::size_t line, std::size_t element, Complex weight) {
  const auto signs = uniform_numbers({.seed = 1, .trial = line}, element);
  const auto part = [](double number, double of) { return of > 0.0 ? (number < 0.5 ? -1.0 : 1.0) / of : 0.0; };
  return {part(signs[0], weight.real()), part(signs[1], weight.imag())};
}

/// Of each sensor what the fit leaves of its FRFs and, behind these, probes of them; in place of gains.
SystematicTerms terms_of(std::size_t line, const LineData& data, std::size_t sensors) {
  const std::vector<Complex> weights = weights_of(data);
  SystematicTerms out;
  out.unknowns = 2 * sensors;
  out.first = {0};
  auto frf = data.systematic->begin();
  for (std::size_t element = 0; element < weights.size(); ++element) {
    for (; frf != data.systematic->end() && frf->element == element; ++frf) {
      for (const SystematicWay& way : frf->ways) {
        for (const SystematicFactor& factor : way.factors) {
          const double share = way.share * frf->share;
          out.terms.push_back({factor.unknown, 1.0, 0.0, -share});
          out.terms.push_back({sensors + factor.unknown, 1.0, std::sqrt(share) * probe(line, element, weights[element]), 0.0});
        }
      }
    }
    out.first.push_back(out.terms.size());
  }
  return out;
}

/// By sensor.
struct SensorSums {
  Eigen::MatrixXd scores;                    ///< [unknowns, sensors]
  std::vector<Eigen::MatrixXd> information;  ///< of the unknowns

  SensorSums(std::size_t known, std::size_t sensors)
      : scores(Eigen::MatrixXd::Zero(at(known), at(sensors))), information(sensors, Eigen::MatrixXd::Zero(at(known), at(known))) {}

  void add(const ScoredLine& line) {
    const Eigen::Index known = scores.rows(), sensors = scores.cols();
    Eigen::MatrixXd cross = Eigen::MatrixXd::Zero(known, 2 * sensors);
    for (Eigen::Index i = 0; i < std::ssize(line.columns) - 2 * sensors; ++i)
      cross.row(at(line.columns[static_cast<std::size_t>(i)])) = line.reduced.information.row(i).tail(2 * sensors);
    scores += line.weight * cross.leftCols(sensors);
    for (std::size_t s = 0; s < information.size(); ++s) {
      const auto of_probe = cross.col(sensors + at(s));
      information[s] += line.weight * of_probe * of_probe.transpose();
    }
  }
  SensorSums& operator+=(const SensorSums& other) {
    scores += other.scores;
    for (std::size_t s = 0; s < information.size(); ++s) information[s] += other.information[s];
    return *this;
  }
  void exchange(const LineShares& shares) {
    shares.sum({scores.data(), static_cast<std::size_t>(scores.size())});
    for (Eigen::MatrixXd& each : information) shares.sum({each.data(), static_cast<std::size_t>(each.size())});
  }
};

SensorSums sums_of(const Plan& plan, const LinearisedLikelihood& estimator, const LikelihoodFit& fit, const Sensors& sensors,
                   const Control& control) {
  const Observations& observations = *likelihood_plan(plan)->observations;
  const SystematicLines lines(sensors.plan, *plan.substructures, *plan.assembly, observations.layout().coordinates);
  SensorSums all = sum_over_lines(plan, estimator, fit, lines, control, SensorSums(fit.theta.size(), sensors.size()),
                                  [&](std::size_t line, const LineData& data) { return terms_of(line, data, sensors.size()); });
  all.exchange(observations.shares());
  return all;
}

}  // namespace

std::optional<SensorScatter> sensor_scatter(const Plan& plan, const LinearisedLikelihood& estimator, const LikelihoodFit& fit,
                                            const Eigen::MatrixXd& information, const Control& control) {
  const Sensors sensors = sensors_of(plan);
  if (std::min(sensors.count[0], sensors.count[1]) < least_sensors) return std::nullopt;
  const SensorSums sums = sums_of(plan, estimator, fit, sensors, control);
  const Eigen::Index n = information.rows();
  const Eigen::MatrixXd unit = Eigen::MatrixXd::Identity(n, n), inverse = dense::solve_positive(information, unit);
  Eigen::VectorXd variance = Eigen::VectorXd::Zero(n), expected = variance, squares = variance;
  for (std::size_t s = 0; s < sensors.size(); ++s) {
    const Eigen::MatrixXd rest = information - sums.information[s];
    const auto moved = dense::solve_definite(rest, sums.scores.col(at(s)));
    if (!moved || !(moved->reciprocal_condition > 1e-13)) return std::nullopt;
    variance += moved->x.cwiseAbs2();
    const Eigen::VectorXd of_noise = (dense::solve_positive(rest, unit) - inverse).diagonal().cwiseMax(0.0);
    expected += of_noise;
    squares += of_noise.cwiseAbs2();
  }
  if (!(squares.minCoeff() > 0.0)) return std::nullopt;
  return SensorScatter{variance, expected.cwiseAbs2().cwiseQuotient(squares).cwiseMax(1.0)};
}

}  // namespace jointid::ident
