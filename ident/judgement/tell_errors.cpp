#include "ident/judgement/tell_errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "base/eigen.hpp"
#include "base/statistics.hpp"
#include "base/text.hpp"
#include "ident/judgement/passivity.hpp"
#include "ident/judgement/value_scales.hpp"
#include "ident/scene/method_traits.hpp"

namespace jointid::ident {
namespace {

int degree(Status status) {
  if (status == Status::ok) return 0;
  if (status == Status::doubtful) return 1;
  return status == Status::poor_fit ? 2 : 3;
}

constexpr double least_value = 0.1;  // of the largest of its matrix and unit
/// Standard deviations of an eigenvalue; without FRFs at the assembly's joint, where other minima are near, it takes fewer.
constexpr double sure = 5.0, sure_of_prediction = 2.0;

void tell_negative(const Plan& plan, const std::vector<double>& theta, const Eigen::MatrixXd& covariance, Solution& out) {
  const double beyond = traits(plan.scene.identify.method).joint_on_assembly ? sure : sure_of_prediction;
  std::string what;
  if (const auto found = negative_diagonals(plan, theta, covariance, normal_95); !found.empty()) {
    what = text(found.front());
  } else if (const auto motions = active_motions(plan, theta, covariance, beyond); !motions.empty() && out.status == Status::ok) {
    what = text(motions.front());
  }
  if (what.empty()) return;
  tell(out, Status::doubtful,
       "The joint is not passive: " + what +
           ". Springs and dampers cannot do that. Do not use this matrix, or constrain it (definite = true).");
}

/// Joints that springs and dampers cannot be by half of their size, however large their errors: these are as large then. Of
/// methods without FRFs at the assembly's joint, where another joint may explain the rest as well.
void tell_indefinite(const Plan& plan, const std::vector<double>& theta, Solution& out) {
  constexpr double half = 0.5;
  if (out.status != Status::ok || traits(plan.scene.identify.method).joint_on_assembly) return;
  const bool has_stiffness = plan.restriction.has(restrictions::Kind::stiffness);
  for (const Indefinite& each : indefinite_matrices(plan, theta, half)) {
    if (has_stiffness && each.kind != restrictions::Kind::stiffness) continue;
    tell(out, Status::doubtful,
         "The joint is not passive, or its errors are as large as it is: " + of_matrix(each.kind) + " has the eigenvalue " +
             digits(each.share) +
             " of its largest, where springs and dampers have none below zero. Another joint may explain the FRFs as well: "
             "measure the "
             "assembly at the joint, or restrict the matrix (definite = true, springs).");
    return;
  }
}

double error_of(const Estimate& unknown) {
  if (!unknown.determined) return std::numeric_limits<double>::infinity();
  return unknown.error().value_or(0.0);
}

/// Error over value of every unknown; a small value counts as a tenth of the largest.
std::vector<double> relative_errors(const Plan& plan, const Solution& out) {
  std::vector<double> values, shares;
  for (const Estimate& unknown : out.unknowns) values.push_back(unknown.value);
  const Eigen::VectorXd largest = largest_of_kind(plan, values);
  for (std::size_t u = 0; u < values.size(); ++u) {
    const double size = std::max(std::abs(values[u]), least_value * largest[at(u)]);
    shares.push_back(error_of(out.unknowns[u]) / size);
  }
  return shares;
}

/// "K(1,1), K(1,2) and 3 more"
std::string some_of(const std::vector<std::string>& names) {
  constexpr std::size_t most = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, names.size()); ++i) text += (i > 0 ? ", " : "") + names[i];
  return names.size() > most ? text + " and " + std::to_string(names.size() - most) + " more" : text;
}

std::string names_above(const std::vector<double>& shares, double limit, const Solution& out) {
  std::vector<std::string> names;
  for (std::size_t u = 0; u < shares.size(); ++u) {
    if (shares[u] > limit) names.push_back(out.unknowns[u].name);
  }
  return some_of(names);
}

/// Unknowns of one matrix and unit, whose largest value has no digit: an error among them is at least as large.
struct WithoutDigit {
  restrictions::Kind kind = restrictions::Kind::stiffness;
  std::string unit;
  double share = 0.0;  ///< that error over the largest value
  std::vector<std::string> names;  ///< of unknowns whose errors are as large as their values
};

std::vector<WithoutDigit> without_digit(const Plan& plan, const Solution& out) {
  struct Group {
    double value = 0.0, error = 0.0;
    std::vector<std::string> names{};
  };
  std::map<std::pair<restrictions::Kind, std::string>, Group> groups;
  for (std::size_t u = 0; u < out.unknowns.size(); ++u) {
    const restrictions::Unknown& unknown = plan.restriction.unknowns[plan.columns->unknown_of(u)];
    Group& group = groups[{unknown.kind, unknown.unit}];
    group.value = std::max(group.value, std::abs(out.unknowns[u].value));
    group.error = std::max(group.error, error_of(out.unknowns[u]));
    if (error_of(out.unknowns[u]) >= std::abs(out.unknowns[u].value)) group.names.push_back(out.unknowns[u].name);
  }
  std::vector<WithoutDigit> found;
  for (const auto& [of, group] : groups) {
    if (group.error > 0.0 && group.error >= group.value) found.push_back({of.first, of.second, group.error / group.value, group.names});
  }
  return found;
}

std::string text(const WithoutDigit& of) {
  return of_matrix(of.kind) + " has no valid digit in " + of.unit + " (" + some_of(of.names) + "): errors reach " + digits(of.share) +
         " times its largest value";
}

void tell_useless(const Plan& plan, Solution& out) {
  if (out.unknowns.empty()) return;
  const std::vector<double> shares = relative_errors(plan, out);
  const auto useless = static_cast<std::size_t>(std::ranges::count_if(shares, [](double share) { return share > 1.0; }));
  const std::string remedy = " Measure what sees the joint better (`jointid plan SCENE --bound`), or tie unknowns.";
  if (2 * useless > shares.size()) {
    tell(out, Status::doubtful,
         "Errors are larger than values in " + std::to_string(useless) + " of " + std::to_string(shares.size()) +
             " unknowns: " + names_above(shares, 1.0, out) + "." + remedy);
    return;
  }
  const bool has_stiffness = plan.restriction.has(restrictions::Kind::stiffness);
  bool told = false;
  std::string others;
  for (const WithoutDigit& each : without_digit(plan, out)) {
    const bool counts = each.kind == restrictions::Kind::stiffness || !has_stiffness;
    if (counts && !told) tell(out, Status::doubtful, "The " + text(each) + "." + remedy);
    told = told || counts;
    if (counts) continue;
    out.warnings.push_back("The " + text(each) + ".");
    others += (others.empty() ? "the " : ", the ") + text(each);
  }
  if (!others.empty())
    tell(out, Status::ok, "The status is that of the stiffness K alone: " + others + ". Do not use these values.");
}

}  // namespace

void tell(Solution& out, Status status, const std::string& sentence) {
  if (degree(status) > degree(out.status)) out.status = status;
  if (!out.message.empty() && out.message.back() != ' ') out.message += " ";
  out.message += sentence;
}

void tell_useless_errors(const Plan& plan, Solution& out) { tell_useless(plan, out); }

void tell_errors(const Plan& plan, const std::vector<double>& theta, const Eigen::MatrixXd& covariance, Solution& out) {
  tell_negative(plan, theta, covariance, out);
  tell_useless(plan, out);
  tell_indefinite(plan, theta, out);
}

}  // namespace jointid::ident
