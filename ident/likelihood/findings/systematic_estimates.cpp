#include "ident/likelihood/findings/systematic_estimates.hpp"

#include <algorithm>
#include <cmath>

#include "base/eigen.hpp"
#include "base/text.hpp"
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
  if (of.unknown.kind == Systematic::gain) {
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

std::string sentence(const CalibrationShare& share) {
  std::string text = percent(share.all) + " of the variance of " + share.unknown + " is what calibration costs";
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
  if (worst != nullptr) out.identifiability->findings.push_back({FindingKind::calibration, sentence(*worst)});
}

}  // namespace jointid::ident
