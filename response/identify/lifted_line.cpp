#include "response/identify/lifted_line.hpp"

#include <utility>

#include "base/parallel.hpp"
#include "dense/cholesky.hpp"
#include "response/identify/response_residuals.hpp"

namespace jointid::response {

LiftedLines::LiftedLines(const LineLayout& layout, const LawUnknowns& unknowns, std::size_t threads)
    : layout_(layout), unknowns_(unknowns), threads_(threads), lines_(layout.lines().size()) {}

void LiftedLines::set(const std::vector<StateModel>& models, const Eigen::VectorXd& numbers,
                      const std::vector<Eigen::MatrixXcd>& force, const LineErrors& errors,
                      const std::vector<Eigen::VectorXd>& tolerance) {
  const std::vector<JointForce> joints = joint_forces(*unknowns_.at_numbers(numbers));
  const Eigen::VectorXd slopes = unknowns_.slopes(numbers);
  errors_ = errors;
  joints_ = force.front().cols();
  harmonics_.clear();
  for (const StateModel& model : models) harmonics_.push_back(model.harmonics());
  std::vector<Eigen::MatrixXd> reduced(lines_.size());
  for_each_index(lines_.size(), threads_, [&](std::size_t l) {
    std::vector<LiftedState> states;
    for (const std::size_t i : layout_.lines()[l].states) states.emplace_back(models[i], joints, force[i], tolerance[i], true);
    lines_[l] = eliminated(layout_.lines()[l], states, slopes, errors[l]);
    reduced[l] = lines_[l].errors->left(lines_[l].left);
  });
  const minimise::Linearised priors = prior_residuals(unknowns_, numbers);
  reduced.emplace_back(priors.residual.size(), slopes.size() + 1) << priors.jacobian, priors.residual;
  reduced_ = minimise::stacked(reduced);
}

LiftedLines::Line LiftedLines::eliminated(const LineLayout::Line& own, const std::vector<LiftedState>& states,
                                          const Eigen::VectorXd& slopes, const Eigen::VectorXd& errors) const {
  Line line;
  Eigen::Index rows = 0;
  for (std::size_t s = 0; s < states.size(); ++s) {
    const LiftedRows of_state = states[s].rows(unknowns_, slopes);
    Eigen::MatrixXd others = Eigen::MatrixXd::Zero(of_state.residual.size(), own.errors + slopes.size() + 1);
    for (const auto& [number, first, count] : own.harmonics) {
      if (count > 0 && harmonics_[own.states[s]].find(number) >= 0)
        others.middleCols(first, count) = states[s].by_errors(number);
    }
    for (const LineLayout::Force& each : own.forces) {
      if (each.state == own.states[s]) others.middleCols(each.first, each.count) = states[s].by_forces(each.number);
    }
    others.middleCols(own.errors, slopes.size()) = of_state.by_parameter;
    others.rightCols(1) = of_state.residual - others.leftCols(own.errors) * errors;
    line.states.push_back(dense::eliminate(of_state.by_force, others));
    rows += line.states.back().left.rows();
  }
  Eigen::MatrixXd by_errors(rows, own.errors);
  line.left.resize(rows, slopes.size() + 1);
  Eigen::Index row = 0;
  for (dense::Elimination& state : line.states) {
    by_errors.middleRows(row, state.left.rows()) = state.left.leftCols(own.errors);
    line.left.middleRows(row, state.left.rows()) = state.left.rightCols(slopes.size() + 1);
    row += state.left.rows();
    state.left.resize(0, 0);
  }
  line.errors.emplace(std::move(by_errors));
  return line;
}

LiftedChange LiftedLines::change(const Eigen::VectorXd& step) const {
  Eigen::VectorXd moved(step.size() + 1);
  moved << step, 1.0;
  LiftedChange out;
  out.force.resize(harmonics_.size());
  for (std::size_t l = 0; l < lines_.size(); ++l) {
    const Line& line = lines_[l];
    const LineLayout::Line& own = layout_.lines()[l];
    const Eigen::VectorXd best = line.errors->best(line.left * moved);
    for (std::size_t s = 0; s < own.states.size(); ++s) {
      const dense::Elimination& state = line.states[s];
      Eigen::MatrixXd forces = -(state.taken.leftCols(own.errors) * best + state.taken.rightCols(moved.size()) * moved);
      dense::solve_lower_transposed(state.triangle.transpose(), forces);
      const Harmonics& harmonics = harmonics_[own.states[s]];
      Eigen::MatrixXcd& force = out.force[own.states[s]];
      force.resize(harmonics.size(), joints_);
      for (Eigen::Index j = 0; j < joints_; ++j)
        force.col(j) = harmonics.unpack(forces.col(0).segment(j * harmonics.unknowns(), harmonics.unknowns()));
    }
    out.errors.emplace_back(best - errors_[l]);
  }
  return out;
}

}  // namespace jointid::response
