#include "tasks/worth.hpp"

#include <algorithm>
#include <cmath>

#include "base/eigen.hpp"
#include "base/statistics.hpp"
#include "base/text.hpp"
#include "dense/eigen.hpp"
#include "ident/judgement/passivity.hpp"
#include "ident/judgement/value_scales.hpp"
#include "tasks/joint/joint_springs.hpp"

namespace jointid::tasks {
namespace {

using ident::Solution;

constexpr double least_value = 0.1;       // of the largest of its matrix and unit: smaller values are compared with this
constexpr double least_share = 0.05;      // of the largest eigenvalue: less is what a slightly wrong model of the joint makes
constexpr double likely_misfit = 1.5;     // squares of residuals over expected ones
constexpr double poor_misfit = 4.0;
constexpr double no_effect = 0.8;         // JointVisibility::effect; 0.7 is expected of no joint
constexpr std::size_t compared_frfs = 9;

std::vector<double> values_of(const Solution& solution) {
  std::vector<double> values;
  for (const ident::Estimate& each : solution.unknowns) values.push_back(each.value);
  return values;
}

WorthAnswer undetermined(const Solution& solution) {
  WorthAnswer answer{.question = WorthQuestion::determined, .light = Light::bad};
  std::size_t count = 0;
  for (const ident::Estimate& each : solution.unknowns) {
    if (each.determined) continue;
    if (count == 0) answer.unknown = each.name;
    ++count;
  }
  answer.text = "The data do not determine " + std::to_string(count) + " of " + std::to_string(solution.unknowns.size()) +
                " unknowns, first " + answer.unknown + ".";
  return answer;
}

WorthAnswer determined(const ident::Plan& plan, const Solution& solution) {
  WorthAnswer answer{.question = WorthQuestion::determined};
  if (solution.unknowns.empty()) {
    answer.text = "There are no values.";
    return answer;
  }
  if (std::ranges::any_of(solution.unknowns, [](const ident::Estimate& each) { return !each.determined; }))
    return undetermined(solution);
  const Eigen::VectorXd largest = ident::largest_of_kind(plan, values_of(solution));
  double worst = -1.0;
  for (std::size_t u = 0; u < solution.unknowns.size(); ++u) {
    const ident::Estimate& each = solution.unknowns[u];
    const std::optional<double> half = half_width(each);
    if (!half) continue;
    const double share = *half / std::max(std::abs(each.value), least_value * largest[at(u)]);
    if (share <= worst) continue;
    worst = share;
    answer.unknown = each.name;
  }
  if (worst < 0.0) {
    answer.text = "The method states no errors of the unknowns.";
    return answer;
  }
  answer.light = worst < 1.0 ? Light::good : Light::doubtful;
  answer.text = "The least determined unknown is " + answer.unknown + ": its value is known to ± " + percent(worst) +
                (worst < 1.0 ? "." : ", so it may be zero.");
  return answer;
}

/// The smallest eigenvalue of a joint matrix, whose rows and columns are scaled to unit diagonal.
struct Least {
  double share = 0.0;  ///< of the largest size
  double error = 0.0;  ///< the largest that the intervals of the unknowns allow, however their errors correlate, in the same
  MatrixElement element{};
  bool has_errors = true;
};

/// The largest error of every element: those of the unknowns in it, added.
Eigen::MatrixXd element_errors(const ident::Plan& plan, const Solution& solution, const ident::BandMatrices& band,
                               const restrictions::MatrixTerms& terms, bool& has_errors) {
  const double inside = band.band_hz ? 0.5 * ((*band.band_hz)[0] + (*band.band_hz)[1]) : 0.0;
  const std::vector<std::size_t> columns = plan.columns->at(inside);
  const Eigen::Index n = at(plan.restriction.dofs.size());
  Eigen::MatrixXd errors = Eigen::MatrixXd::Zero(n, n);
  for (const auto& [row, column, unknown, coefficient] : terms.terms) {
    const std::optional<double> half = half_width(solution.unknowns[columns[unknown]]);
    has_errors = has_errors && half.has_value();
    errors(at(row), at(column)) += std::abs(coefficient) * half.value_or(0.0);
  }
  return errors;
}

std::optional<Least> least_eigenvalue(const ident::Plan& plan, const Solution& solution, std::size_t band,
                                      const restrictions::MatrixTerms& terms) {
  const ident::Matrix& elements = solution.bands[band].matrices.at(terms.kind);
  const Eigen::Index n = at(elements.size());
  Eigen::MatrixXd x(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) x(i, j) = elements[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  }
  if (!x.allFinite() || x.isZero(0.0)) return std::nullopt;
  const Eigen::VectorXd scale =
      x.diagonal().unaryExpr([](double element) { return element == 0.0 ? 1.0 : 1.0 / std::sqrt(std::abs(element)); });
  const Eigen::MatrixXd scaled = scale.asDiagonal() * (0.5 * (x + x.transpose())) * scale.asDiagonal();
  const dense::SymmetricEigen eigen = dense::symmetric_eigen(scaled);
  const double largest = eigen.values.cwiseAbs().maxCoeff();
  Least least{.share = eigen.values[0] / largest, .element = {.band = band, .kind = terms.kind}};
  const Eigen::VectorXd motion = scale.cwiseProduct(eigen.vectors.col(0)).cwiseAbs();
  least.error = motion.dot(element_errors(plan, solution, solution.bands[band], terms, least.has_errors) * motion) / largest;
  Eigen::Index most = 0;
  eigen.vectors.col(0).cwiseAbs().maxCoeff(&most);
  least.element.row = least.element.column = static_cast<std::size_t>(most);
  return least;
}

/// Of all matrices the one whose smallest eigenvalue is furthest below zero.
std::optional<Least> least_of_all(const ident::Plan& plan, const Solution& solution) {
  std::optional<Least> least;
  for (std::size_t band = 0; band < solution.bands.size(); ++band) {
    for (const restrictions::MatrixTerms& terms : plan.restriction.matrices) {
      if (!solution.bands[band].matrices.contains(terms.kind)) continue;
      const std::optional<Least> found = least_eigenvalue(plan, solution, band, terms);
      if (found && (!least || found->share < least->share)) least = found;
    }
  }
  return least;
}

WorthAnswer passive(const ident::Plan& plan, const Solution& solution) {
  WorthAnswer answer{.question = WorthQuestion::passive};
  const std::optional<Least> least = least_of_all(plan, solution);
  if (!least) {
    answer.text = "There is no joint matrix.";
    return answer;
  }
  if (least->share >= -least_share) {
    answer.light = Light::good;
    answer.text = "The joint is passive: springs, dampers and masses can be its matrices.";
    return answer;
  }
  const bool is_certain = least->has_errors && least->share < -least->error;
  answer.light = is_certain ? Light::bad : Light::doubtful;
  answer.element = least->element;
  answer.text = "The joint is not passive: " + ident::of_matrix(least->element.kind) + " has a negative eigenvalue, " +
                digits(least->share) + " of its largest, with most motion at " +
                solution.dofs[least->element.row].name() +
                (is_certain            ? ". Its error is smaller."
                 : least->has_errors ? ". Its error may be as large."
                                     : ". Its error is not known.");
  return answer;
}

/// How many times the noise the residuals are, as squares, and how many chance leaves.
struct Misfit {
  double value = 0.0, likely = likely_misfit;
};

std::optional<Misfit> misfit_of(const ident::Fit& fit) {
  if (fit.chi_square && fit.chi_square->degrees_of_freedom > 0.0) {
    const ident::ChiSquare& found = *fit.chi_square;
    return Misfit{found.value / found.degrees_of_freedom, found.likely > 0.0 ? found.likely : likely_misfit};
  }
  if (fit.misfit) return Misfit{*fit.misfit};
  return std::nullopt;
}

WorthAnswer explained(const Solution& solution, const std::optional<FrfEntry>& worst) {
  WorthAnswer answer{.question = WorthQuestion::noise, .frf = worst};
  const std::optional<Misfit> misfit = misfit_of(solution.fit);
  if (!misfit || !std::isfinite(misfit->value)) {
    answer.text = "The noise of the FRFs is not known: coherences, repeated tests or [noise] state it.";
    return answer;
  }
  const bool is_poor = misfit->value > poor_misfit || solution.status == ident::Status::poor_fit;
  answer.light = misfit->value <= misfit->likely ? Light::good : is_poor ? Light::bad : Light::doubtful;
  answer.text = "The residuals are " + digits(std::sqrt(misfit->value)) + " times their expected noise" +
                (answer.light == Light::good ? "." : ": this joint does not explain the FRFs.");
  return answer;
}

/// |predicted − measured|² over |predicted|² + |measured|², which is 1 where nothing is predicted: mean over lines.
struct Distance {
  double sum = 0.0, count = 0.0;

  double mean() const { return count > 0.0 ? sum / count : nan; }
};

Distance distance(const RegeneratedFrf& frf) {
  Distance out;
  for (std::size_t i = 0; i < frf.measured.size(); ++i) {
    const double size = std::norm(frf.measured[i]) + std::norm(frf.predicted[i]);
    const double share = std::norm(frf.predicted[i] - frf.measured[i]) / size;
    if (!std::isfinite(share)) continue;
    out.sum += share;
    out.count += 1.0;
  }
  return out;
}

/// Some FRFs of the assembly, with the joint and without.
struct Comparison {
  double with = nan, without = nan;  ///< root of the mean distance
  std::optional<FrfEntry> worst{};
};

std::vector<ident::BandMatrices> without_joint(std::vector<ident::BandMatrices> bands) {
  for (ident::BandMatrices& band : bands) {
    for (auto& [kind, matrix] : band.matrices) {
      for (std::vector<double>& row : matrix) std::ranges::fill(row, 0.0);
    }
  }
  return bands;
}

Comparison compare(const ident::Plan& plan, const Solution& solution, const ident::Control& control) {
  const std::vector<FrfEntry> entries = choose_entries(plan, compared_frfs);
  if (solution.bands.empty() || entries.empty()) return {};
  Comparison out;
  Distance with, without;
  double largest = -1.0;
  for (const RegeneratedFrf& frf : regenerate(plan, solution.bands, entries, control).frfs) {
    const Distance found = distance(frf);
    with.sum += found.sum;
    with.count += found.count;
    if (!(found.mean() > largest)) continue;
    largest = found.mean();
    out.worst = frf.entry;
  }
  for (const RegeneratedFrf& frf : regenerate(plan, without_joint(solution.bands), entries, control).frfs) {
    const Distance found = distance(frf);
    without.sum += found.sum;
    without.count += found.count;
  }
  out.with = std::sqrt(with.mean());
  out.without = std::sqrt(without.mean());
  return out;
}

WorthAnswer better(const Solution& solution, const Comparison& compared) {
  WorthAnswer answer{.question = WorthQuestion::better_than_none, .frf = compared.worst};
  if (!std::isfinite(compared.with) || !std::isfinite(compared.without)) {
    answer.text = "No FRF of the assembly can be synthesised.";
    return answer;
  }
  answer.light = compared.with < 0.5 * compared.without ? Light::good
                 : compared.with < compared.without     ? Light::doubtful
                                                        : Light::bad;
  answer.text = "The synthesised FRFs of the assembly are off by " + percent(compared.with) + " with the joint and by " +
                percent(compared.without) + " without it.";
  if (const auto& seen = solution.identifiability; seen && seen->joint.effect && *seen->joint.effect < no_effect) {
    answer.light = Light::bad;
    answer.text += " The noise hides the joint.";
  }
  return answer;
}

}  // namespace

std::vector<WorthAnswer> worth(const ident::Plan& plan, const Solution& solution, const ident::Control& control) {
  const Comparison compared = compare(plan, solution, control);
  return {determined(plan, solution), passive(plan, solution), explained(solution, compared.worst), better(solution, compared)};
}

}  // namespace jointid::tasks
