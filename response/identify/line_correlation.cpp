#include "response/identify/line_correlation.hpp"

#include <algorithm>
#include <set>

#include "dense/cholesky.hpp"

namespace jointid::response {
namespace {

/// B_n of some states of a line, one below the other; zero for a state whose model lacks the harmonic.
Eigen::MatrixXd stacked(const std::vector<StateModel>& models, const std::vector<StatePrediction>& predictions,
                        const std::vector<std::size_t>& states, const std::vector<Joint>& joints, int harmonic) {
  std::vector<Eigen::MatrixXd> blocks;
  Eigen::Index rows = 0, columns = 0, row = 0;
  for (const std::size_t i : states) {
    const bool has = models[i].harmonics().find(harmonic) >= 0;
    blocks.push_back(has ? models[i].by_receptances(harmonic, joints, predictions[i])
                         : Eigen::MatrixXd(measured_numbers(models[i].state()), 0));
    rows += blocks.back().rows();
    columns = std::max(columns, blocks.back().cols());
  }
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(rows, columns);
  for (const Eigen::MatrixXd& block : blocks) {
    all.block(row, 0, block.rows(), block.cols()) = block;
    row += block.rows();
  }
  return all;
}

}  // namespace

LineCorrelation::LineCorrelation(const std::vector<StateModel>& models, const std::vector<StatePrediction>& states,
                                 const std::vector<Joint>& joints) {
  Eigen::Index row = 0;
  for (std::size_t i = 0; i < models.size(); ++i) {
    const double omega = models[i].state().omega;
    auto line = std::ranges::find(lines_, omega, &Line::omega);
    if (line == lines_.end()) line = lines_.insert(lines_.end(), {omega, {}, {}, {}});
    line->states.push_back(i);
    for (Eigen::Index k = measured_numbers(models[i].state()); k > 0; --k) line->rows.push_back(row++);
  }
  for (Line& line : lines_) {
    std::set<int> harmonics;
    for (const std::size_t i : line.states) {
      harmonics.insert(models[i].harmonics().numbers().begin(), models[i].harmonics().numbers().end());
    }
    line.lower = Eigen::MatrixXd::Identity(at(line.rows.size()), at(line.rows.size()));
    for (const int n : harmonics) {
      const Eigen::MatrixXd b = stacked(models, states, line.states, joints, n);
      line.lower += b * b.transpose();
    }
    dense::cholesky_in_place(line.lower);  // I + BBᵀ is positive definite
  }
}

void LineCorrelation::whiten(Linearised& linearised) const {
  for (const Line& line : lines_) {
    Eigen::MatrixXd both(at(line.rows.size()), linearised.jacobian.cols() + 1);
    both << linearised.jacobian(line.rows, Eigen::all), linearised.residual(line.rows);
    dense::solve_lower(line.lower, both);
    linearised.jacobian(line.rows, Eigen::all) = both.leftCols(linearised.jacobian.cols());
    linearised.residual(line.rows) = both.rightCols(1);
  }
}

double LineCorrelation::log_determinant() const {
  double sum = 0.0;
  for (const Line& line : lines_) sum += 2.0 * line.lower.diagonal().array().log().sum();
  return sum;
}

}  // namespace jointid::response
