#include "response/identify/lifted_line.hpp"

#include <utility>

#include "dense/cholesky.hpp"
#include "dense/qr.hpp"
#include "response/identify/response_residuals.hpp"

namespace jointid::response {

LiftedLines::LiftedLines(const LineLayout& layout, const std::vector<StateModel>& models, const LawUnknowns& unknowns,
                         const Eigen::VectorXd& numbers, const std::vector<Eigen::MatrixXcd>& force, const LineErrors& errors,
                         const std::vector<Eigen::VectorXd>& tolerance)
    : layout_(layout), errors_(errors), joints_(force.front().cols()) {
  const std::vector<Joint> joints = *unknowns.at_numbers(numbers);
  const Eigen::VectorXd slopes = unknowns.slopes(numbers);
  for (const StateModel& model : models) harmonics_.push_back(model.harmonics());
  Eigen::Index rows_of_all = 0;
  for (std::size_t l = 0; l < layout.lines().size(); ++l) {
    const LineLayout::Line& own = layout.lines()[l];
    Eigen::Index rows = 0, forces = 0;
    for (const std::size_t i : own.states) {
      forces += joints_ * harmonics_[i].unknowns();
      rows += measured_numbers(models[i].state()) + joints_ * harmonics_[i].unknowns();
    }
    Line line;
    line.by_errors.setZero(rows, own.errors);
    line.by_force.setZero(rows, forces);
    line.residual.resize(rows);
    line.by_parameter.resize(rows, slopes.size());
    Eigen::Index row = 0, column = 0;
    for (const std::size_t i : own.states) {
      const LiftedState state(models[i], joints, force[i], tolerance[i]);
      const LiftedRows of_state = state.rows(unknowns, slopes);
      const Eigen::Index count = of_state.residual.size(), width = of_state.by_force.cols();
      line.residual.segment(row, count) = of_state.residual;
      line.by_parameter.middleRows(row, count) = of_state.by_parameter;
      line.by_force.block(row, column, count, width) = of_state.by_force;
      for (const auto& [number, first, errors_of] : own.harmonics) {
        if (errors_of > 0 && harmonics_[i].find(number) >= 0)
          line.by_errors.block(row, first, count, errors_of) = state.by_errors(number);
      }
      row += count;
      column += width;
    }
    line.residual -= line.by_errors * errors[l];
    eliminate(line);
    rows_of_all += rows;
    lines_.push_back(std::move(line));
  }
  const Linearised priors = prior_residuals(unknowns, numbers);
  rows_of_all += priors.residual.size();
  reduced_ = {Eigen::VectorXd(rows_of_all), Eigen::MatrixXd(rows_of_all, slopes.size())};
  Eigen::Index row = 0;
  for (const Line& line : lines_) append(line, row);
  reduced_.residual.tail(priors.residual.size()) = priors.residual;
  reduced_.jacobian.bottomRows(priors.residual.size()) = priors.jacobian;
}

void LiftedLines::eliminate(Line& line) const {
  const Eigen::Index forces = line.by_force.cols(), parameters = line.by_parameter.cols();
  Eigen::MatrixXd all(line.residual.size(), forces + parameters + 1);
  all << line.by_force, line.by_parameter, line.residual;
  if (line.by_errors.cols() > 0) {
    line.lower = Eigen::MatrixXd::Identity(all.rows(), all.rows()) + line.by_errors * line.by_errors.transpose();
    dense::cholesky_in_place(line.lower);  // I + BBᵀ is positive definite
    dense::solve_lower(line.lower, all);
  }
  line.basis = dense::orthonormal_columns(all.leftCols(forces));
  line.triangle = line.basis.transpose() * all.leftCols(forces);
  line.whitened_parameter = all.middleCols(forces, parameters);
  line.whitened_residual = all.rightCols(1);
}

void LiftedLines::append(const Line& line, Eigen::Index& row) {
  const Eigen::Index rows = line.residual.size();
  reduced_.residual.segment(row, rows) = line.whitened_residual - line.basis * (line.basis.transpose() * line.whitened_residual);
  reduced_.jacobian.middleRows(row, rows) =
      line.whitened_parameter - line.basis * (line.basis.transpose() * line.whitened_parameter);
  row += rows;
}

LiftedChange LiftedLines::change(const Eigen::VectorXd& step) const {
  LiftedChange out;
  out.force.resize(harmonics_.size());
  for (std::size_t l = 0; l < lines_.size(); ++l) {
    const Line& line = lines_[l];
    Eigen::MatrixXd forces = -line.basis.transpose() * (line.whitened_residual + line.whitened_parameter * step);
    dense::solve_lower_transposed(line.triangle.transpose(), forces);
    Eigen::Index place = 0;
    for (const std::size_t i : layout_.lines()[l].states) {
      const Eigen::Index size = harmonics_[i].unknowns();
      out.force[i].resize(harmonics_[i].size(), joints_);
      for (Eigen::Index j = 0; j < joints_; ++j, place += size)
        out.force[i].col(j) = harmonics_[i].unpack(forces.col(0).segment(place, size));
    }
    if (line.by_errors.cols() == 0) {
      out.errors.emplace_back(Eigen::VectorXd::Zero(0));
      continue;
    }
    Eigen::MatrixXd left = line.residual + line.by_parameter * step + line.by_force * forces;
    dense::solve_lower(line.lower, left);
    dense::solve_lower_transposed(line.lower, left);
    out.errors.emplace_back(-line.by_errors.transpose() * left - errors_[l]);
  }
  return out;
}

}  // namespace jointid::response
