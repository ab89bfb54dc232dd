#include "friction/fit/fit_problem.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/eigen.hpp"
#include "base/error.hpp"
#include "base/text.hpp"
#include "friction/fit/tied_limit.hpp"

namespace jointid::friction {
namespace {

/// A law whose sum of squares has several minima is fitted from so many starts.
constexpr std::size_t most_starts = 4;

void check(std::span<const Curve> curves, const FitOptions& options) {
  if (curves.empty()) refuse("there is no curve to fit");
  for (const Curve& curve : curves) validate(curve);
  if (options.limit && !(*options.limit > 0.0)) refuse("the preset friction limit is not positive");
  if (options.limit && options.friction_coefficient) {
    refuse("a preset limit and an unknown friction coefficient do not go together");
  }
  const auto has_load = [](const Curve& curve) { return curve.normal_load.has_value(); };
  if (options.friction_coefficient && !std::ranges::all_of(curves, has_load)) {
    refuse("a friction coefficient needs the normal load of every curve");
  }
}

}  // namespace

FitProblem::FitProblem(std::span<const Curve> curves, const Family& family, const FitOptions& options)
    : curves_(curves), options_(options) {
  check(curves, options);
  for (const Curve& curve : curves) {
    rows_ += curve.rows();
    weights_.push_back(row_weights(curve, options.weighting));
  }
  std::vector<std::vector<std::unique_ptr<Element>>> elements;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    elements.push_back(best_starts(c, family));
    prototypes_.push_back(elements.back().front()->clone());
  }
  parameters_ = prototypes_.front()->parameters();
  for (const Parameter& parameter : parameters_) scales_.emplace_back(parameter);
  choose_tied();
  number_unknowns();
  std::size_t most = most_starts;
  for (const auto& of_curve : elements) most = std::min(most, of_curve.size());
  for (std::size_t rank = 0; rank < most; ++rank) starts_.push_back(unknowns_of(elements, rank));
}

double FitProblem::squares(std::size_t curve, const Element& element) const {
  const std::vector<double> values = predicted(element, curves_[curve]);
  double sum = 0.0;
  for (std::size_t row = 0; row < values.size(); ++row) {
    const double r = weights_[curve][row] * (values[row] - curves_[curve].measured(row));
    sum += r * r;
  }
  return sum;
}

std::vector<std::unique_ptr<Element>> FitProblem::best_starts(std::size_t curve, const Family& family) const {
  std::vector<std::pair<double, std::unique_ptr<Element>>> found;
  for (auto& start : family.starts(features(curves_[curve]))) {
    if (options_.limit) {
      const auto parameter = tied_parameter(*start, std::vector<bool>(start->parameters().size(), false));
      if (!parameter) refuse(family.name + " has no friction limit to preset");
      start = with_limit(*start, *parameter, *options_.limit);
      if (!start) continue;
    }
    const double sum = squares(curve, *start);
    if (std::isfinite(sum)) found.emplace_back(sum, std::move(start));
  }
  if (found.empty())
    refuse("there is no " + family.name + " near the curve" +
                                (options_.limit ? " with that friction limit" : ""));
  std::ranges::stable_sort(found, {}, [](const auto& each) { return each.first; });
  std::vector<std::unique_ptr<Element>> best;
  for (std::size_t i = 0; i < std::min(found.size(), most_starts); ++i) best.push_back(std::move(found[i].second));
  return best;
}

bool FitProblem::is_shared(std::size_t parameter) const {
  return std::ranges::find(options_.shared, parameters_[parameter].name) != options_.shared.end();
}

void FitProblem::choose_tied() {
  std::vector<bool> spared;
  for (std::size_t i = 0; i < parameters_.size(); ++i) spared.push_back(is_shared(i));
  tied_ = tied_parameter(*prototypes_.front(), spared);
  const bool preset = options_.limit || options_.friction_coefficient;
  if (preset && !tied_) refuse("the law has no friction limit");
  if (options_.friction_coefficient && spared[*tied_] && curves_.size() > 1) {
    refuse(parameters_[*tied_].name + " cannot be shared: every curve's friction limit determines it");
  }
}

void FitProblem::number_unknowns() {
  for (const std::string& name : options_.shared) {
    if (std::ranges::find(parameters_, name, &Parameter::name) != parameters_.end()) continue;
    const std::string valid = comma_list(parameters_, &Parameter::name);
    refuse("there is no parameter '" + name + "' to share; valid: " + valid);
  }
  if (options_.friction_coefficient) {
    coefficient_ = 0;
    names_.emplace_back("mu");
  }
  const bool limit_unknown = !options_.limit && !options_.friction_coefficient;
  unknown_of_.resize(curves_.size());
  for (std::size_t c = 0; c < curves_.size(); ++c) {
    for (std::size_t i = 0; i < parameters_.size(); ++i) {
      const bool known = c > 0 && is_shared(i);
      unknown_of_[c].push_back(known ? unknown_of_[0][i] : names_.size());
      if (known || (tied_ == i && !limit_unknown)) continue;
      const std::string name = tied_ == i ? "friction limit" : parameters_[i].name;
      names_.push_back(is_shared(i) || curves_.size() == 1 ? name : name + " of " + curves_[c].name);
    }
  }
}

/// The unknown that is the logarithm of a curve's limit, or of μ.
std::optional<std::size_t> FitProblem::limit_unknown(std::size_t curve) const {
  if (!tied_ || options_.limit) return std::nullopt;
  return coefficient_ ? *coefficient_ : unknown_of_[curve][*tied_];
}

std::vector<double> FitProblem::unknowns_of(std::span<const std::vector<std::unique_ptr<Element>>> elements, std::size_t rank) const {
  std::vector<double> sum(names_.size(), 0.0), count(names_.size(), 0.0);
  const auto add = [&](std::size_t unknown, double q) {
    sum[unknown] += q;
    count[unknown] += 1.0;
  };
  for (std::size_t c = 0; c < curves_.size(); ++c) {
    const Element& element = *elements[c][rank];
    const std::vector<double> values = element.values();
    if (const auto unknown = limit_unknown(c)) add(*unknown, std::log(element.limit() / (coefficient_ ? *curves_[c].normal_load : 1.0)));
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (tied_ != i) add(unknown_of_[c][i], scales_[i].free(values[i]));
    }
  }
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] /= count[i];
  return sum;
}

double FitProblem::target_limit(std::size_t curve, std::span<const double> q) const {
  if (options_.limit) return *options_.limit;
  return std::exp(q[*limit_unknown(curve)]) * (coefficient_ ? *curves_[curve].normal_load : 1.0);
}

std::optional<CurveState> FitProblem::state(std::size_t curve, std::span<const double> q, bool with_derivative) const {
  std::vector<double> values = prototypes_[curve]->values();
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (tied_ != i) values[i] = scales_[i].value(q[unknown_of_[curve][i]]);
  }
  if (!prototypes_[curve]->admits(values)) return std::nullopt;
  CurveState out;
  out.element = prototypes_[curve]->with(values);
  if (tied_) out.element = with_limit(*out.element, *tied_, target_limit(curve, q));
  if (!out.element) return std::nullopt;
  if (!with_derivative) return out;
  out.by_unknown = Eigen::MatrixXd::Zero(at(values.size()), at(unknowns()));
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t unknown = unknown_of_[curve][i];
    if (tied_ != i) out.by_unknown(at(i), at(unknown)) = scales_[i].slope(q[unknown]);
  }
  if (!tied_) return out;
  // The limit L(p) stays at its target: Σ ∂L/∂p_i dp_i = L dln L.
  const std::vector<double> by = limit_derivative(*out.element);
  Eigen::RowVectorXd missing = Eigen::RowVectorXd::Zero(at(unknowns()));
  if (const auto unknown = limit_unknown(curve)) missing[at(*unknown)] = out.element->limit();
  for (std::size_t i = 0; i < values.size(); ++i) missing -= by[i] * out.by_unknown.row(at(i));
  out.by_unknown.row(at(*tied_)) = missing / by[*tied_];
  return out;
}

bool FitProblem::evaluate(std::span<const double> q, std::span<double> r, std::span<double> jacobian) const {
  std::size_t first = 0;
  for (std::size_t c = 0; c < curves_.size(); ++c) {
    if (options_.interrupted && options_.interrupted()) return false;  // a minimiser of another library is between
    const auto found = state(c, q, !jacobian.empty());
    if (!found) return false;
    const std::vector<double> values = predicted(*found->element, curves_[c]);
    const std::size_t rows = values.size();
    for (std::size_t row = 0; row < rows; ++row) {
      r[first + row] = weights_[c][row] * (values[row] - curves_[c].measured(row));
      if (!std::isfinite(r[first + row])) return false;
    }
    if (!jacobian.empty()) {
      const std::vector<double> by = predicted_derivative(*found->element, curves_[c]);
      const Eigen::Map<const RowMatrixXd> by_parameter(by.data(), at(rows), at(parameters_.size()));
      const Eigen::Map<const Eigen::VectorXd> weight(weights_[c].data(), at(rows));
      Eigen::Map<RowMatrixXd> out(jacobian.data() + first * unknowns(), at(rows), at(unknowns()));
      out.noalias() = weight.asDiagonal() * (by_parameter * found->by_unknown);
      if (!out.allFinite()) return false;
    }
    first += rows;
  }
  return true;
}

}  // namespace jointid::friction
