#include "response/identify/line_correlation.hpp"

#include <algorithm>
#include <set>

#include "dense/cholesky.hpp"

namespace jointid::response {

LineLayout::LineLayout(const std::vector<StateModel>& models, const Receptance& structure) {
  Eigen::Index row = 0;
  std::vector<std::set<int>> numbers;
  for (std::size_t i = 0; i < models.size(); ++i) {
    const double omega = models[i].state().omega;
    auto line = std::ranges::find(lines_, omega, &Line::omega);
    if (line == lines_.end()) {
      line = lines_.insert(lines_.end(), {omega, {}, {}, {}, 0});
      numbers.emplace_back();
    }
    line->states.push_back(i);
    for (Eigen::Index k = measured_numbers(models[i].state()); k > 0; --k) line->rows.push_back(row++);
    const std::vector<int>& own = models[i].harmonics().numbers();
    numbers[static_cast<std::size_t>(line - lines_.begin())].insert(own.begin(), own.end());
  }
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    for (const int n : numbers[i]) {
      const Eigen::Index count = 2 * at(structure.errors(n * lines_[i].omega).size());
      lines_[i].harmonics.push_back({n, lines_[i].errors, count});
      lines_[i].errors += count;
    }
  }
}

LineErrors LineLayout::no_errors() const {
  LineErrors none;
  for (const Line& line : lines_) none.emplace_back(Eigen::VectorXd::Zero(line.errors));
  return none;
}

LineCorrelation::LineCorrelation(const LineLayout& layout, const std::vector<StateModel>& models,
                                 const std::vector<StatePrediction>& states, const std::vector<Joint>& joints)
    : layout_(layout) {
  for (const LineLayout::Line& line : layout.lines()) {
    Eigen::MatrixXd b = Eigen::MatrixXd::Zero(at(line.rows.size()), line.errors);
    Eigen::Index row = 0;
    for (const std::size_t i : line.states) {
      const Eigen::Index rows = measured_numbers(models[i].state());
      const ReceptanceResponse response(models[i], joints, states[i]);
      for (const auto& [number, first, count] : line.harmonics) {
        if (models[i].harmonics().find(number) >= 0) b.block(row, first, rows, count) = response.by_errors(number);
      }
      row += rows;
    }
    lower_.emplace_back(Eigen::MatrixXd::Identity(b.rows(), b.rows()) + b * b.transpose());
    dense::cholesky_in_place(lower_.back());  // I + BBᵀ is positive definite
    by_errors_.push_back(std::move(b));
  }
}

void LineCorrelation::whiten(Linearised& linearised) const {
  for (std::size_t i = 0; i < lower_.size(); ++i) {
    const std::vector<Eigen::Index>& rows = layout_.lines()[i].rows;
    Eigen::MatrixXd both(at(rows.size()), linearised.jacobian.cols() + 1);
    both << linearised.jacobian(rows, Eigen::all), linearised.residual(rows);
    dense::solve_lower(lower_[i], both);
    linearised.jacobian(rows, Eigen::all) = both.leftCols(linearised.jacobian.cols());
    linearised.residual(rows) = both.rightCols(1);
  }
}

Eigen::VectorXd LineCorrelation::without(const LineErrors& errors, const Eigen::VectorXd& residual) const {
  Eigen::VectorXd left = residual;
  for (std::size_t i = 0; i < by_errors_.size(); ++i) left(layout_.lines()[i].rows) -= by_errors_[i] * errors[i];
  return left;
}

LineErrors LineCorrelation::best_errors(const Eigen::VectorXd& without) const {
  LineErrors best;
  for (std::size_t i = 0; i < by_errors_.size(); ++i) {
    Eigen::MatrixXd solved = without(layout_.lines()[i].rows);
    dense::solve_lower(lower_[i], solved);
    dense::solve_lower_transposed(lower_[i], solved);
    best.emplace_back(-by_errors_[i].transpose() * solved);
  }
  return best;
}

}  // namespace jointid::response
