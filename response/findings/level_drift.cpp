#include "response/findings/level_drift.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "base/statistics.hpp"
#include "response/identify/corrected_models.hpp"
#include "response/identify/harmonics_fit.hpp"
#include "response/identify/information.hpp"

namespace jointid::response {
namespace {

/// Rows of all states at the end of a fit, whitened: [∂/∂θ of all, ∂/∂θ of the first level alone, of the second …].
struct Whitened {
  minimise::Linearised rows;
  Eigen::Index unknowns = 0;

  Eigen::MatrixXd with_level(std::size_t place) const {
    Eigen::MatrixXd both(rows.jacobian.rows(), 2 * unknowns);
    both << rows.jacobian.leftCols(unknowns), rows.jacobian.middleCols(unknowns * (1 + at(place)), unknowns);
    return both;
  }
};

/// Nothing where the states of the fit cannot be found again.
std::optional<Whitened> whitened_by_level(const std::shared_ptr<const Receptance>& structure,
                                          const std::vector<MeasuredState>& states, const std::vector<std::size_t>& level,
                                          const std::vector<std::size_t>& levels, const LawUnknowns& unknowns,
                                          const FitOfHarmonics& end) {
  std::set<int> numbers;
  for (const StatePrediction& state : end.states)
    numbers.insert(state.solution.harmonics.begin(), state.solution.harmonics.end());
  const std::vector<int> harmonics(numbers.begin(), numbers.end());
  const std::optional<LineLayout>& layout = end.layout;
  std::vector<StateModel> models;
  if (layout) {
    models = corrected_models(structure, states, *layout, end.errors, harmonics);
  } else {
    for (const MeasuredState& state : states) models.emplace_back(structure, state, harmonics);
  }
  const ResponseResiduals residuals(models, unknowns);
  const auto value = residuals.evaluate(end.result.unknowns, end.states);
  if (!value) return std::nullopt;
  const Eigen::MatrixXd& jacobian = value->linearised.jacobian;
  const Eigen::Index size = unknowns.size();
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(jacobian.rows(), size * (1 + at(levels.size())));
  all.leftCols(size) = jacobian;
  Eigen::Index row = 0;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const Eigen::Index rows = measured_numbers(states[i]);
    const auto place = std::ranges::find(levels, level[i]) - levels.begin();
    all.block(row, size * (1 + place), rows, size) = jacobian.middleRows(row, rows);
    row += rows;
  }
  if (!layout) return Whitened{{value->linearised.residual, std::move(all)}, size};
  LineCorrelation correlation(*layout, 1);
  correlation.set(models, value->states, joint_forces(*unknowns.at_numbers(end.result.unknowns)));
  return Whitened{correlation.whitened(correlation.without(end.errors, value->linearised.residual), all), size};
}

/// rᵀJ(JᵀJ)⁺Jᵀr: by how much Σr² falls at its minimum.
double fall(const Information& information, const Eigen::VectorXd& gradient) {
  return gradient.dot(information.covariance() * gradient);
}

}  // namespace

bool LevelDrift::is_told() const { return freedom > 0 && chi_square > chi_square_quantile(static_cast<double>(freedom), 4.0); }

std::vector<LevelDrift> test_level_drift(const std::shared_ptr<const Receptance>& structure,
                                         const std::vector<MeasuredState>& states, const std::vector<std::size_t>& level,
                                         const LawUnknowns& unknowns, const LawFit& fit) {
  const std::set<std::size_t> different(level.begin(), level.end());
  const std::vector<std::size_t> levels(different.begin(), different.end());
  if (levels.size() < 2 || !is_minimum(fit.status) || !fit.end || fit.end->states.empty()) return {};
  const auto rows = whitened_by_level(structure, states, level, levels, unknowns, *fit.end);
  if (!rows) return {};
  const Eigen::Index size = rows->unknowns;
  const Eigen::MatrixXd& own = rows->rows.jacobian;
  const Information of_all(own.leftCols(size));
  const double known = fall(of_all, own.leftCols(size).transpose() * rows->rows.residual);
  const Eigen::VectorXd values = unknowns.values(fit.end->result.unknowns), slopes = unknowns.slopes(fit.end->result.unknowns);
  const Eigen::VectorXd relative = slopes.cwiseQuotient(values);
  std::vector<LevelDrift> drifts;
  for (std::size_t place = 0; place < levels.size(); ++place) {
    const Eigen::MatrixXd both = rows->with_level(place);
    const Information information(both);
    const Eigen::VectorXd gradient = both.transpose() * rows->rows.residual;
    LevelDrift drift;
    drift.level = levels[place];
    drift.freedom = information.rank() - of_all.rank();
    drift.chi_square = fall(information, gradient) - known;
    drift.change = -(information.covariance() * gradient).tail(size).cwiseProduct(relative);
    drift.deviation.resize(size);
    for (Eigen::Index i = 0; i < size; ++i) {
      const auto deviation = information.deviation(Eigen::RowVectorXd::Unit(2 * size, size + i));
      drift.deviation(i) = deviation ? *deviation * std::abs(relative(i)) : nan;
    }
    drifts.push_back(std::move(drift));
  }
  std::ranges::sort(drifts, std::greater{}, &LevelDrift::chi_square);
  return drifts;
}

}  // namespace jointid::response
