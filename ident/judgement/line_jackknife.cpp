#include "ident/judgement/line_jackknife.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/eigen.hpp"
#include "ident/equations/assemble.hpp"
#include "ident/equations/linear_plan.hpp"
#include "ident/judgement/measured_rectangle.hpp"

namespace jointid::ident {
namespace {

constexpr std::size_t least_lines = 4, most_groups = 12;

std::vector<std::vector<Line>> groups_of(const std::vector<Line>& lines, std::size_t most_lines, bool bands) {
  const std::vector<Line> some = spread_lines(lines, most_lines);
  const std::size_t groups = std::min(some.size(), most_groups);
  std::vector<std::vector<Line>> out(groups);
  for (std::size_t i = 0; i < some.size(); ++i) out[bands ? i % groups : i * groups / some.size()].push_back(some[i]);
  return out;
}

}  // namespace

std::vector<std::vector<Line>> jackknife_groups(const Plan& plan, std::size_t most_lines) {
  if (plan.lines.size() < least_lines || linear_plan(plan) == nullptr) return {};
  return groups_of(plan.lines, most_lines, !plan.columns->limits_hz().empty());
}

double share_of_all(const Plan& plan, const std::vector<std::vector<Line>>& groups) {
  std::size_t used = 0;
  for (const auto& group : groups) used += group.size();
  return static_cast<double>(used) / static_cast<double>(plan.lines.size());
}

std::vector<minimise::Accumulator> systems_of(const Plan& plan, const std::vector<std::vector<Line>>& groups, const Control& control) {
  Control quick = control;
  quick.detail = Detail::estimates;
  quick.progress = {};
  RunTime time;
  std::vector<minimise::Accumulator> out;
  for (const std::vector<Line>& group : groups) {
    out.push_back(assemble(plan, group, time, quick).accumulator);
    out.back().flush();
    out.back().release();
  }
  return out;
}

minimise::Accumulator system_without(const Plan& plan, std::vector<minimise::Accumulator>& systems,
                                     const std::vector<std::size_t>& left_out) {
  minimise::Accumulator rest(plan.columns->size(), systems.front().reduction());
  for (std::size_t g = 0; g < systems.size(); ++g) {
    if (std::ranges::find(left_out, g) == left_out.end()) rest.merge(systems[g]);
  }
  return rest;
}

std::optional<PartialEstimate> estimate_without(const Plan& plan, std::vector<minimise::Accumulator>& systems,
                                                const std::vector<std::size_t>& left_out) {
  minimise::Accumulator rest = system_without(plan, systems, left_out);
  const minimise::LinearSolution linear = solve(plan, rest, minimise::Condition::skip);
  if (linear.rank != plan.columns->size()) return std::nullopt;
  PartialEstimate found{Eigen::Map<const Eigen::VectorXd>(linear.y.data(), at(linear.y.size())),
                        linear.residual_norm * linear.residual_norm};
  return found.theta.allFinite() ? std::optional(std::move(found)) : std::nullopt;
}

Eigen::MatrixXd jackknife_deviations(const Eigen::MatrixXd& estimates) {
  const auto g = static_cast<double>(estimates.cols());
  return std::sqrt((g - 1.0) / g) * (estimates.colwise() - estimates.rowwise().mean());
}

Eigen::MatrixXd jackknife_scatter(const Eigen::MatrixXd& estimates) {
  const Eigen::MatrixXd deviations = jackknife_deviations(estimates);
  return deviations * deviations.transpose();
}

std::optional<Eigen::VectorXd> line_scatter(const Plan& plan, std::size_t most_lines, const Control& control) {
  const std::vector<std::vector<Line>> groups = jackknife_groups(plan, most_lines);
  if (groups.empty()) return std::nullopt;
  std::vector<minimise::Accumulator> systems = systems_of(plan, groups, control);
  Eigen::MatrixXd without(at(plan.columns->size()), at(groups.size()));
  for (std::size_t group = 0; group < groups.size(); ++group) {
    const auto found = estimate_without(plan, systems, {group});
    if (!found) return std::nullopt;
    without.col(at(group)) = found->theta;
  }
  return share_of_all(plan, groups) * jackknife_deviations(without).rowwise().squaredNorm();
}

std::optional<LineJackknife> line_jackknife(const Plan& plan, std::size_t most_lines, const Control& control) {
  LineJackknife out{.groups = jackknife_groups(plan, most_lines),
                    .systems = {},
                    .all = {},
                    .without = {},
                    .residual_without = {},
                    .covariance = {}};
  if (out.groups.empty()) return std::nullopt;
  out.systems = systems_of(plan, out.groups, control);
  out.without = Eigen::MatrixXd(at(plan.columns->size()), at(out.groups.size()));
  for (std::size_t group = 0; group < out.groups.size(); ++group) {
    const auto found = estimate_without(plan, out.systems, {group});
    if (!found) return std::nullopt;
    out.without.col(at(group)) = found->theta;
    out.residual_without.push_back(found->residual);
  }
  const auto all = estimate_without(plan, out.systems, {});
  if (!all) return std::nullopt;
  out.all = all->theta;
  out.residual = all->residual;
  out.covariance = share_of_all(plan, out.groups) * jackknife_scatter(out.without);
  return out;
}

}  // namespace jointid::ident
