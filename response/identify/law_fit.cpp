#include "response/identify/law_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/error.hpp"
#include "base/statistics.hpp"
#include "friction/fit/tied_limit.hpp"
#include "response/identify/harmonics_fit.hpp"
#include "response/identify/harmonics_to_add.hpp"
#include "response/identify/information.hpp"

namespace jointid::response {
namespace {

constexpr double rough = 0.1;  ///< of the deviations by which harmonics that are added may move an estimate

constexpr double negligible = 0.3;  ///< deviations that a kink may leave

constexpr double finest = 1e-6;  ///< deviations: unknown receptances make the steps shrink by a factor alone

LawFitEnd status_of(const minimise::GaussNewtonResult& result) {
  if (!result.defined) return LawFitEnd::no_response;
  if (!result.converged) return LawFitEnd::not_converged;
  return result.kink > negligible ? LawFitEnd::at_kink : LawFitEnd::converged;
}

/// Joints with values and deviations, from the numbers of a minimum.
class FittedJoints {
 public:
  FittedJoints(const LawUnknowns& unknowns, const minimise::GaussNewtonResult& result)
      : unknowns_(unknowns), information_(result.at.jacobian), numbers_(result.unknowns) {}

  Eigen::MatrixXd covariance() const {
    const Eigen::VectorXd slopes = unknowns_.slopes(numbers_);
    return slopes.asDiagonal() * information_.covariance() * slopes.asDiagonal();
  }

  FittedJoint of(std::size_t j, const Joint& joint, const std::vector<StatePrediction>& states) const {
    FittedJoint out;
    out.joint = joint;
    const Eigen::VectorXd values = unknowns_.values(numbers_), slopes = unknowns_.slopes(numbers_);
    for (Eigen::Index i = 0; i < unknowns_.size(); ++i) {
      if (!moves(j, i)) continue;
      friction::Parameter parameter = unknowns_.parameter(i);
      parameter.value = values(i);
      out.parameters.push_back(described(parameter, Eigen::RowVectorXd::Unit(unknowns_.size(), i) * slopes(i)));
    }
    fill_motion(j, states, out);
    if (joint.friction) fill_law(j, *joint.friction, out);
    return out;
  }

 private:
  /// Whether unknown i is a parameter of joint j.
  bool moves(std::size_t j, Eigen::Index i) const {
    for (std::size_t k = 0; k < unknowns_.moved().size(); ++k) {
      if (unknowns_.moved_by()[k] == i && unknowns_.moved()[k].joint == j) return true;
    }
    return false;
  }

  friction::FittedValue described(const friction::Parameter& parameter, const Eigen::RowVectorXd& gradient) const {
    if (!(gradient.norm() > 0.0)) return {parameter.name, parameter.unit, parameter.value, {}, {}, friction::Knowledge::preset};
    return friction::fitted_value(parameter, information_.deviation(gradient), normal_95);
  }

  /// A derivative by all parameters of the law of joint j as one by the numbers.
  Eigen::RowVectorXd by_numbers(std::size_t j, const std::vector<double>& by_parameters) const {
    const Eigen::VectorXd slopes = unknowns_.slopes(numbers_);
    Eigen::RowVectorXd gradient = Eigen::RowVectorXd::Zero(slopes.size());
    for (std::size_t i = 0; i < unknowns_.moved().size(); ++i) {
      const auto [joint, parameter] = unknowns_.moved()[i];
      const Eigen::Index unknown = unknowns_.moved_by()[i];
      if (joint == j && parameter < by_parameters.size()) gradient(unknown) += slopes(unknown) * by_parameters[parameter];
    }
    return gradient;
  }

  static void fill_motion(std::size_t j, const std::vector<StatePrediction>& states, FittedJoint& out) {
    out.smallest_motion = std::numeric_limits<double>::infinity();
    for (const StatePrediction& state : states) {
      const Eigen::Index first = Harmonics(state.solution.harmonics).find(1);
      if (first < 0) continue;
      const double size = std::abs(state.solution.joint_motion(first, at(j)));
      out.smallest_motion = std::min(out.smallest_motion, size);
      out.largest_motion = std::max(out.largest_motion, size);
    }
    out.smallest_motion = std::min(out.smallest_motion, out.largest_motion);
  }

  void fill_law(std::size_t j, const friction::Element& law, FittedJoint& out) const {
    const double stuck = law.response(0.0).tangent, largest = out.largest_motion;
    out.stiffness = described({"initial stiffness", "N/m", stuck, 0.0, friction::infinity, true},
                              by_numbers(j, friction::stiffness_derivative(law, largest > 0.0 ? largest : 1.0)));
    const friction::Parameter limit = {"friction limit", "N", law.limit(), 0.0, friction::infinity, true};
    if (!std::isfinite(limit.value)) {
      out.limit = {limit.name, limit.unit, limit.value, {}, {}, friction::Knowledge::undetermined};
      return;
    }
    out.limit = described(limit, by_numbers(j, friction::limit_derivative(law)));
    const double slipped = 1.0 - law.response(largest).tangent / stuck;
    if (out.limit.knowledge == friction::Knowledge::determined && slipped < friction::macroslip)
      out.limit.knowledge = friction::Knowledge::extrapolated;
  }

  const LawUnknowns& unknowns_;
  Information information_;
  Eigen::VectorXd numbers_;
};

void describe_fit(const LawUnknowns& unknowns, FitOfHarmonics fit, LawFit& out) {
  if (!fit.result.defined) return;
  out.values = unknowns.values(fit.result.unknowns);
  out.chi_square = fit.result.at.residual.squaredNorm();
  out.aic = out.chi_square + 2.0 * static_cast<double>(unknowns.size());
  const FittedJoints fitted(unknowns, fit.result);
  out.covariance = fitted.covariance();
  out.states = std::move(fit.states);
  const std::vector<Joint> joints = *unknowns.at_numbers(fit.result.unknowns);
  for (std::size_t j = 0; j < joints.size(); ++j) out.joints.push_back(fitted.of(j, joints[j], out.states));
}

/// A fit yet to be made of valid states: its numbers and its freedom.
LawFit numbers_of(const Receptance& structure, const std::vector<MeasuredState>& states, const LawUnknowns& unknowns) {
  require_valid(states, structure);
  if (unknowns.size() == 0) {
    throw InputError({.kind = ErrorKind::usage,
                      .file = "",
                      .place = "joints",
                      .problem = "no parameter is unknown",
                      .remedy = "give a joint a friction law whose parameters are to be found"});
  }
  LawFit out;
  out.numbers = measured_numbers(states) + unknowns.priors();
  out.freedom = out.numbers - unknowns.size();
  if (out.freedom <= 0) out.status = LawFitEnd::too_few_data;
  return out;
}

}  // namespace

std::string_view word(LawFitEnd status) {
  constexpr std::string_view words[] = {"converged",    "not_converged",        "no_response",
                                        "too_few_data", "harmonics_not_enough", "at_kink"};
  return words[static_cast<std::size_t>(status)];
}

bool is_minimum(LawFitEnd status) {
  return status == LawFitEnd::converged || status == LawFitEnd::harmonics_not_enough || status == LawFitEnd::at_kink;
}

std::vector<Joint> joints_of(const LawFit& fit) {
  std::vector<Joint> joints;
  for (const FittedJoint& joint : fit.joints) joints.push_back(joint.joint);
  return joints;
}

double chi_square_of_one(const LawFit& fit) { return fit.chi_square / static_cast<double>(fit.freedom); }

LawFit fit_laws(std::shared_ptr<const Receptance> structure, const std::vector<MeasuredState>& states,
                const LawUnknowns& unknowns, const LawFitOptions& options) {
  LawFit out = numbers_of(*structure, states, unknowns);
  if (out.status == LawFitEnd::too_few_data) return out;
  const HarmonicsToAdd add(*structure, states, options.largest);
  const bool adds = options.harmonics.empty();
  const bool nuisance = options.receptance_errors && knows_errors(*structure, states);
  const HarmonicsFits fits(structure, states, unknowns, {.nuisance = nuisance, .work = options.work, .steps = options.steps});
  const double enough = adds ? rough * options.settled : 0.0;
  FitOfHarmonics fit;
  if (options.from) fit = *options.from;
  std::vector<int> harmonics;
  Eigen::VectorXd numbers = unknowns.start();
  for (int largest = add.first(); largest > 0; largest = add.after(largest)) {
    harmonics = adds ? add.to(largest) : options.harmonics;
    fit = out.rounds.empty() && !options.from ? fits.first(harmonics, enough) : fits.next(harmonics, fit, enough);
    out.steps += fit.result.steps;
    out.status = status_of(fit.result);
    if (!fit.result.defined) break;
    const double moved = out.rounds.empty() ? 0.0 : (fit.result.at.jacobian * (fit.result.unknowns - numbers)).norm();
    numbers = fit.result.unknowns;
    out.rounds.push_back({adds ? largest : 0, unknowns.values(numbers), fit.result.at.residual.squaredNorm(), moved});
    if (!fit.result.converged || !adds || (out.rounds.size() > 1 && moved < options.settled)) break;
    if (add.after(largest) == 0) out.status = LawFitEnd::harmonics_not_enough;
  }
  if (adds && fit.result.converged) {  // the last round ended roughly
    fit = fits.next(harmonics, fit, nuisance ? finest : 0.0);
    out.steps += fit.result.steps;
    if (out.status != LawFitEnd::harmonics_not_enough || !fit.result.converged) out.status = status_of(fit.result);
  }
  out.end = std::make_shared<const FitOfHarmonics>(fit);
  describe_fit(unknowns, std::move(fit), out);
  return out;
}

LawFit bound_of_laws(std::shared_ptr<const Receptance> structure, const std::vector<MeasuredState>& states, const LawUnknowns& unknowns,
                     const std::vector<int>& harmonics) {
  constexpr double exact = 1e-4;  // χ² of states that are those of the model
  LawFit out = numbers_of(*structure, states, unknowns);
  if (out.status == LawFitEnd::too_few_data) return out;
  const bool nuisance = knows_errors(*structure, states);
  const HarmonicsFits fits(structure, states, unknowns, {.nuisance = nuisance});
  FitOfHarmonics fit = fits.at(harmonics, unknowns.start());
  out.status = status_of(fit.result);
  describe_fit(unknowns, std::move(fit), out);
  if (out.chi_square > exact) out.status = LawFitEnd::not_converged;
  return out;
}

}  // namespace jointid::response
