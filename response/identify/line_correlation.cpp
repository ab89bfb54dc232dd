#include "response/identify/line_correlation.hpp"

#include <algorithm>
#include <set>

#include "base/parallel.hpp"

namespace jointid::response {

LineLayout::LineLayout(const std::vector<StateModel>& models, const Receptance& structure) {
  Eigen::Index row = 0;
  std::vector<std::set<int>> numbers;
  for (std::size_t i = 0; i < models.size(); ++i) {
    const double omega = models[i].state().omega;
    auto line = std::ranges::find(lines_, omega, &Line::omega);
    if (line == lines_.end()) {
      line = lines_.insert(lines_.end(), {omega, {}, {}, {}, {}, 0});
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
    for (const std::size_t state : lines_[i].states) add_forces(state, models[state], lines_[i]);
  }
}

void LineLayout::add_forces(std::size_t state, const StateModel& model, Line& line) {
  const MeasuredState& measured = model.state();
  if (!measured.knows_force_errors()) return;
  for (std::size_t n = 0; n < measured.force.harmonics.size(); ++n) {
    const int number = measured.force.harmonics[n];
    const bool exact = !(measured.force_deviation.row(at(n)).array() > 0.0).any();
    if (number == 0 || exact || model.harmonics().find(number) < 0) continue;
    const Eigen::Index count = 2 * measured.force_deviation.cols();
    line.forces.push_back({state, number, line.errors, count});
    line.errors += count;
  }
}

LineErrors LineLayout::no_errors() const {
  LineErrors none;
  for (const Line& line : lines_) none.emplace_back(Eigen::VectorXd::Zero(line.errors));
  return none;
}

LineCorrelation::LineCorrelation(const LineLayout& layout, std::size_t threads)
    : layout_(&layout), threads_(threads), by_errors_(layout.lines().size()) {}

void LineCorrelation::set(const std::vector<StateModel>& models, const std::vector<StatePrediction>& states,
                          const std::vector<JointForce>& joints) {
  for_each_index(by_errors_.size(), threads_, [&](std::size_t l) {
    const LineLayout::Line& line = layout_->lines()[l];
    Eigen::MatrixXd b = Eigen::MatrixXd::Zero(at(line.rows.size()), line.errors);
    Eigen::Index row = 0;
    for (const std::size_t i : line.states) {
      const Eigen::Index rows = measured_numbers(models[i].state());
      const ReceptanceResponse response(models[i], joints, states[i]);
      for (const auto& [number, first, count] : line.harmonics) {
        if (count > 0 && models[i].harmonics().find(number) >= 0) b.block(row, first, rows, count) = response.by_errors(number);
      }
      for (const LineLayout::Force& force : line.forces) {
        if (force.state == i) b.block(row, force.first, rows, force.count) = response.by_forces(force.number);
      }
      row += rows;
    }
    by_errors_[l].emplace(std::move(b));
  });
}

Eigen::VectorXd LineCorrelation::without(const LineErrors& errors, const Eigen::VectorXd& residual) const {
  Eigen::VectorXd left = residual;
  for (std::size_t i = 0; i < by_errors_.size(); ++i) left(layout_->lines()[i].rows) -= by_errors_[i]->b() * errors[i];
  return left;
}

minimise::Linearised LineCorrelation::whitened(const Eigen::VectorXd& without, const Eigen::MatrixXd& jacobian) const {
  std::vector<Eigen::MatrixXd> left(by_errors_.size());
  for_each_index(left.size(), threads_, [&](std::size_t l) {
    const std::vector<Eigen::Index>& rows = layout_->lines()[l].rows;
    Eigen::MatrixXd both(at(rows.size()), jacobian.cols() + 1);
    both << jacobian(rows, Eigen::all), without(rows);
    left[l] = by_errors_[l]->left(both);
  });
  std::vector<bool> is_of_line(static_cast<std::size_t>(without.size()), false);
  for (const LineLayout::Line& line : layout_->lines()) {
    for (const Eigen::Index row : line.rows) is_of_line[static_cast<std::size_t>(row)] = true;
  }
  for (Eigen::Index row = 0; row < without.size(); ++row) {
    if (is_of_line[static_cast<std::size_t>(row)]) continue;
    left.emplace_back(1, jacobian.cols() + 1) << jacobian.row(row), without(row);
  }
  return minimise::stacked(left);
}

LineErrors LineCorrelation::best_errors(const Eigen::VectorXd& without) const {
  LineErrors best(by_errors_.size());
  for_each_index(best.size(), threads_, [&](std::size_t l) { best[l] = by_errors_[l]->best(without(layout_->lines()[l].rows)); });
  return best;
}

}  // namespace jointid::response
