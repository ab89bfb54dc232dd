#include "ident/likelihood/fit/spring_starts.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/eigen.hpp"
#include "base/statistics.hpp"
#include "dense/minimum_norm.hpp"
#include "ident/plan/joint_guess.hpp"

namespace jointid::ident {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using Indices = std::vector<std::size_t>;

/// 1/√|H_ii| of every joint coordinate, by the medians over the lines; empty where one has not been measured.
std::vector<double> roots_of_stiffness(const LikelihoodData& data) {
  const LineLayout& layout = data.layout();
  std::vector<double> roots(layout.joint, 0.0);
  for (std::size_t i = 0; i < layout.sub_jj.size(); ++i) {
    if (layout.sub_jj[i].row != layout.sub_jj[i].column) continue;
    std::vector<double> sizes;
    for (const LineData& line : data.lines()) {
      if (line.sub_jj.weight[i] != Complex(0.0)) sizes.push_back(std::abs(line.sub_jj.value[i]));
    }
    if (!sizes.empty()) roots[layout.sub_jj[i].row] = 1.0 / std::sqrt(median(sizes));
  }
  const bool all = std::ranges::all_of(roots, [](double root) { return std::isnormal(root); });
  return all ? roots : std::vector<double>();
}

void add_spring(const Dofs& joint, std::size_t i, std::size_t j, MatrixXd& k) {
  const double sign = joint[i].sign * joint[j].sign;
  k(at(i), at(i)) += 1.0;
  k(at(j), at(j)) += 1.0;
  k(at(i), at(j)) -= sign;
  k(at(j), at(i)) -= sign;
}

/// Springs between coordinates of one direction, those of each substructure in a list of their own.
void add_springs(const Dofs& joint, const std::vector<Indices>& parts, MatrixXd& k) {
  const bool alike =
      parts.size() > 1 && std::ranges::all_of(parts, [&](const Indices& part) { return part.size() == parts[0].size(); });
  if (alike) {
    for (std::size_t a = 0; a < parts.size(); ++a) {
      for (std::size_t b = a + 1; b < parts.size(); ++b) {
        for (std::size_t i = 0; i < parts[a].size(); ++i) add_spring(joint, parts[a][i], parts[b][i], k);
      }
    }
    return;
  }
  Indices all;
  for (const Indices& part : parts) all.insert(all.end(), part.begin(), part.end());
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = i + 1; j < all.size(); ++j) add_spring(joint, all[i], all[j], k);
  }
}

/// K of unit springs.
MatrixXd unit_springs(const Plan& plan) {
  const Dofs& joint = plan.coordinates.joint;
  std::map<frf::Direction, std::map<std::size_t, Indices>> by_direction;
  for (std::size_t i = 0; i < joint.size(); ++i) {
    by_direction[joint[i].direction][plan.substructures->source_of(joint[i])].push_back(i);
  }
  MatrixXd k = MatrixXd::Zero(at(joint.size()), at(joint.size()));
  for (const auto& [direction, by_source] : by_direction) {
    std::vector<Indices> parts;
    for (const auto& [source, part] : by_source) parts.push_back(part);
    add_springs(joint, parts, k);
  }
  return k;
}

/// The joint of the restriction whose K is nearest to that of the springs, elements measured in roots_i roots_j.
std::vector<double> nearest_joint(const Plan& plan, const restrictions::MatrixTerms& stiffness, MatrixXd springs,
                                  const std::vector<double>& roots) {
  const std::size_t n = roots.size();
  const auto measured = [&roots](double value, const auto& place) { return value / (roots[place.row] * roots[place.column]); };
  MatrixXd elements = MatrixXd::Zero(at(n * n), at(plan.restriction.unknowns.size()));
  for (const auto& term : stiffness.terms)
    elements(at(term.row * n + term.column), at(term.unknown)) += measured(term.coefficient, term);
  for (const auto& known : stiffness.known) springs(at(known.row), at(known.column)) -= measured(known.value, known);
  const VectorXd of_unknowns = dense::RealMinimumNorm(elements).solve(springs.reshaped());
  std::vector<double> values;
  for (std::size_t column = 0; column < plan.columns->size(); ++column)
    values.push_back(of_unknowns[at(plan.columns->unknown_of(column))]);
  return scaled(plan, values);
}

}  // namespace

std::vector<std::vector<double>> spring_starts(const Plan& plan, const LikelihoodData& data) {
  const auto stiffness =
      std::ranges::find(plan.restriction.matrices, restrictions::Kind::stiffness, &restrictions::MatrixTerms::kind);
  if (stiffness == plan.restriction.matrices.end() || stiffness->terms.empty()) return {};
  const MatrixXd springs = unit_springs(plan);
  std::vector<double> roots = roots_of_stiffness(data);
  if (springs.isZero(0.0) || roots.empty()) return {};
  std::vector<std::vector<double>> guesses = {nearest_joint(plan, *stiffness, springs, roots)};
  const Dofs& joint = plan.coordinates.joint;
  const auto rotations = std::ranges::count_if(joint, &frf::Dof::is_rotation);
  if (rotations == 0 || rotations == std::ssize(joint)) return guesses;
  for (const double factor : {10.0, 0.01}) {  // of roots, and the second in addition to the first
    for (std::size_t i = 0; i < joint.size(); ++i) {
      if (joint[i].is_rotation()) roots[i] *= factor;
    }
    guesses.push_back(nearest_joint(plan, *stiffness, springs, roots));
  }
  return guesses;
}

}  // namespace jointid::ident
