#include "ident/likelihood/findings/systematic_estimates.hpp"

#include <algorithm>
#include <cmath>

#include "base/eigen.hpp"
#include "base/text.hpp"
#include "ident/judgement/judge.hpp"
#include "ident/likelihood/data/likelihood_plan.hpp"
#include "minimise/linear/covariance.hpp"

namespace jointid::ident {
namespace {

constexpr double worth_telling = 0.05, half = 0.5;
constexpr std::size_t most_told = 3;

SystematicEstimate estimate_of(const NamedSystematic& of, double phi, double deviation) {
  const double sigma = of.unknown.deviation;
  SystematicEstimate out{
      .name = of.name, .unit = of.unit, .value = 0.0, .std_error = {}, .prior = of.known, .prior_deviation = sigma};
  if (of.unknown.kind == Systematic::gain || of.unknown.kind == Systematic::scale) {
    out.prior = 1.0;
    out.value = std::exp(sigma * phi);
    out.std_error = out.value * sigma * deviation;
    return out;
  }
  out.value = of.known + sigma * phi;
  out.std_error = sigma * deviation;
  return out;
}

CalibrationShare share_of(const std::string& name, Eigen::Index column, Eigen::Index joint, double variance_alone,
                          const Eigen::MatrixXd& covariance, const std::vector<NamedSystematic>& systematic) {
  CalibrationShare out{.unknown = name, .all = 1.0 - variance_alone / covariance(column, column), .largest = {}};
  for (std::size_t u = 0; u < systematic.size(); ++u) {
    const Eigen::Index k = joint + at(u);
    const double share = covariance(column, k) * covariance(column, k) / (covariance(column, column) * covariance(k, k));
    if (share >= worth_telling) out.largest.emplace_back(systematic[u].name, share);
  }
  std::ranges::stable_sort(out.largest, [](const auto& a, const auto& b) { return a.second > b.second; });
  if (out.largest.size() > most_told) out.largest.resize(most_told);
  return out;
}

bool is_scale(const NamedSystematic& each) { return each.unknown.kind == Systematic::scale; }

std::string sentence(const CalibrationShare& share, const std::vector<NamedSystematic>& systematic) {
  const bool of_models = std::ranges::any_of(systematic, is_scale), of_sensors = !std::ranges::all_of(systematic, is_scale);
  const std::string what = !of_models   ? "calibration costs"
                           : of_sensors ? "calibration and errors of models cost"
                                        : "the model's error costs";
  std::string text = percent(share.all) + " of the variance of " + share.unknown + " is what " + what;
  for (std::size_t i = 0; i < share.largest.size(); ++i) {
    text += (i == 0 ? ": " : ", ") + percent(share.largest[i].second) + " the " + share.largest[i].first;
  }
  return text + ".";
}

}  // namespace

std::vector<SystematicEstimate> systematic_estimates(const Plan& plan, const LikelihoodFit& fit,
                                                     const Eigen::MatrixXd& information) {
  const SystematicPlan* systematic = likelihood_plan(plan)->observations->systematic_plan();
  if (systematic == nullptr) return {};
  const Eigen::MatrixXd covariance = minimise::covariance_of(information);
  std::vector<SystematicEstimate> out;
  for (std::size_t u = 0; u < systematic->all().size(); ++u) {
    const std::size_t column = plan.columns->size() + u;
    out.push_back(estimate_of(systematic->all()[u], fit.theta[column], std::sqrt(covariance(at(column), at(column)))));
  }
  return out;
}

void tell_calibration(const Plan& plan, const Eigen::MatrixXd& information, Solution& out) {
  const SystematicPlan* systematic = likelihood_plan(plan)->observations->systematic_plan();
  if (systematic == nullptr || !out.identifiability) return;
  const Eigen::Index joint = at(plan.columns->size());
  const Eigen::MatrixXd covariance = minimise::covariance_of(information),
                        alone = minimise::covariance_of(information.topLeftCorner(joint, joint));
  const CalibrationShare* worst = nullptr;
  std::vector<CalibrationShare>& shares = out.identifiability->calibration;
  for (std::size_t column = 0; column < out.unknowns.size(); ++column) {
    if (!out.unknowns[column].determined) continue;
    const Eigen::Index c = at(column);
    shares.push_back(share_of(out.unknowns[column].name, c, joint, alone(c, c), covariance, systematic->all()));
  }
  for (const CalibrationShare& share : shares) {
    if (share.all >= half && (worst == nullptr || share.all > worst->all)) worst = &share;
  }
  if (worst != nullptr) out.identifiability->findings.push_back({FindingKind::calibration, sentence(*worst, systematic->all())});
}

void tell_model_errors(const Plan& plan, const LikelihoodFit& fit, const Eigen::MatrixXd& information, Solution& out) {
  constexpr double contradicts = 3.0;  // standard deviations of what an estimate scatters by where the prior holds
  const SystematicPlan* systematic = likelihood_plan(plan)->observations->systematic_plan();
  if (systematic == nullptr) return;
  const Eigen::MatrixXd covariance = minimise::covariance_of(information);
  for (std::size_t u = 0; u < systematic->all().size(); ++u) {
    const NamedSystematic& each = systematic->all()[u];
    const std::size_t column = plan.columns->size() + u;
    const double known = 1.0 - covariance(at(column), at(column)), phi = fit.theta[column];
    if (!is_scale(each) || !(known > 0.0) || !(std::abs(phi) > contradicts * std::sqrt(known))) continue;
    const SystematicEstimate found = estimate_of(each, phi, std::sqrt(covariance(at(column), at(column))));
    tell(out, Status::doubtful,
         "The data call for a " + each.name + " of " + digits(found.value, "%.4f") + " ± " + digits(*found.std_error, "%.1g") +
             " times the model's. The model states an error of " + percent(each.unknown.deviation) + ", and this is " +
             digits(std::abs(phi), "%.2g") + " times as much: correct the model, or state a larger error.");
  }
}

}  // namespace jointid::ident
