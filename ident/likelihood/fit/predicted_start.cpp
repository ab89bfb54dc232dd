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
  for (std::size_t i = 0; i < layout.sub_jn.size(); ++i) {
    const auto [p, k] = place(layout.sub_jn[i]);
    out.ba(p, k) = measured(data.sub_jn, i);
  }
  for (std::size_t i = 0; i < layout.sub_jj.size(); ++i) {
    const auto [p, q] = place(layout.sub_jj[i]);
    out.bb(p, q) = out.bb(q, p) = measured(data.sub_jj, i);
  }
  for (std::size_t i = 0; i < layout.drop_nn.size(); ++i) {
    const auto [r, k] = place(layout.drop_nn[i]);
    out.nn(r, k) = -measured(data.drop_nn, i);
  }
  out.ab = out.ba.transpose();
  return out;
}

/// Every so many lines give some 40, enough for a start; all do where the unknowns of lines differ.
std::size_t lines_apart(const Plan& plan, const std::vector<LineData>& lines) {
  constexpr std::size_t enough = 40;
  const auto has_all = [&plan](const LineData& line) {
    return plan.columns->at(hertz(line.omega)).size() == plan.columns->size();
  };
  return std::ranges::all_of(lines, has_all) ? std::max<std::size_t>(1, lines.size() / enough) : 1;
}

}  // namespace

std::vector<double> predicted_start(const Plan& plan, const LikelihoodData& data, std::vector<double> theta) {
  std::vector<ResponseLine> lines;
  const std::size_t apart = lines_apart(plan, data.lines());
  for (std::size_t i = 0; i < data.lines().size(); i += apart) {
    const LineData& line = data.lines()[i];
    lines.emplace_back(frfs_of(data.layout(), line), joint_at(plan.restriction, *plan.columns, plan.omega0, line.omega));
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
