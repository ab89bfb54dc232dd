#include "ident/likelihood/fit/predicted_start.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/eigen.hpp"
#include "ident/newton/iteration.hpp"

namespace jointid::ident {
namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

Complex measured(const Channel& channel, std::size_t i) {
  return channel.weight[i] == Complex(0.0) ? Complex(missing, missing) : channel.value[i];
}

/// X, Y and D in the form of docs/formulas.md §7 (6.12); D alone stands for both systems.
ReachableFrfs frfs_of(const LineLayout& layout, const LineData& data) {
  const auto n = at(layout.others), joint = at(layout.joint);
  ReachableFrfs out = {Eigen::MatrixXcd::Zero(n, n), {}, Eigen::MatrixXcd::Zero(joint, n), Eigen::MatrixXcd::Zero(joint, joint),
                       Eigen::MatrixXcd::Constant(n, n, Complex(missing, missing))};
  const auto place = [](const Element& element) {
    return std::pair(at(element.row), at(element.column));
  };
  for (std::size_t i = 0; i < layout.x.size(); ++i) {
    const auto [p, k] = place(layout.x[i]);
    out.ba(p, k) = measured(data.x, i);
  }
  for (std::size_t i = 0; i < layout.y.size(); ++i) {
    const auto [p, q] = place(layout.y[i]);
    out.bb(p, q) = out.bb(q, p) = measured(data.y, i);
  }
  for (std::size_t i = 0; i < layout.d.size(); ++i) {
    const auto [r, k] = place(layout.d[i]);
    out.nn(r, k) = -measured(data.d, i);
  }
  out.ab = out.ba.transpose();
  return out;
}

JointImpedance joint_at(const Plan& plan, const LineData& line) {
  return {plan.restriction, *plan.columns, plan.omega0, line.omega};
}

/// Some 40 lines, enough for a start; all where the unknowns of lines differ.
std::vector<const LineData*> spread_lines(const Plan& plan, const LikelihoodData& data) {
  constexpr std::size_t enough = 40;
  std::vector<const LineData*> lines;
  for (const LineData& line : data.lines()) lines.push_back(&line);
  const auto has_all = [&plan](const LineData* line) { return joint_at(plan, *line).columns().size() == plan.columns->size(); };
  const std::size_t every = lines.size() / enough;
  if (every < 2 || !std::ranges::all_of(lines, has_all)) return lines;
  std::vector<const LineData*> out;
  for (std::size_t i = 0; i < lines.size(); i += every) out.push_back(lines[i]);
  return out;
}

}  // namespace

std::vector<double> predicted_start(const Plan& plan, const LikelihoodData& data, std::vector<double> theta) {
  std::vector<ResponseLine> lines;
  for (const LineData* line : spread_lines(plan, data)) {
    lines.emplace_back(frfs_of(data.layout(), *line), joint_at(plan, *line));
  }
  ResponseProblem problem(std::move(lines), theta.size());
  NewtonOptions options;
  options.patience = 20;  // where it does not settle it goes about the place from which the likelihood does
  const NewtonFit fit = damped_newton(problem, problem.scaled(theta), options);
  std::vector<double> end = problem.theta(fit.q);
  for (const double value : end) {
    if (!std::isfinite(value)) return theta;
  }
  return end;
}

}  // namespace jointid::ident
