#include "ident/admissible/admissible_linear.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/eigen.hpp"
#include "ident/admissible/eigenfrequencies.hpp"
#include "ident/admissible/outcome.hpp"
#include "minimise/linear/null_space.hpp"
#include "minimise/linear/reduced_system.hpp"

namespace jointid::ident {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr std::size_t many_unknowns = 150;  ///< a dense step costs the cube of them

/// The compressed rows as a whole: ‖Rθ − q‖², and RᵀR.
class CompressedRows {
 public:
  explicit CompressedRows(const minimise::Accumulator& accumulator) : accumulator_(accumulator) {}

  double residual(const VectorXd& theta) const {
    double sum = 0.0;
    each([&](const auto& columns, const minimise::Triangle& triangle) {
      for (std::size_t i = 0; i <= columns.size(); ++i) {
        double row = -triangle(i, columns.size());
        for (std::size_t j = i; j < columns.size(); ++j) row += triangle(i, j) * theta[at(columns[j])];
        sum += row * row;
      }
    });
    return std::sqrt(sum);
  }

  double right_side() const { return residual(VectorXd::Zero(at(accumulator_.columns()))); }

  Eigen::SparseMatrix<double> information() const {
    std::vector<Eigen::Triplet<double, int>> all;
    each([&](const auto& columns, const minimise::Triangle& triangle) {
      const std::size_t n = columns.size();
      Eigen::MatrixXd root = Eigen::MatrixXd::Zero(at(n), at(n));
      for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = i; j < n; ++j) root(at(i), at(j)) = triangle(i, j);
      }
      const Eigen::MatrixXd product = root.transpose() * root;
      for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
          if (columns[i] >= columns[j] && product(at(i), at(j)) != 0.0)
            all.emplace_back(static_cast<int>(columns[i]), static_cast<int>(columns[j]), product(at(i), at(j)));
        }
      }
    });
    const Index n = at(accumulator_.columns());
    Eigen::SparseMatrix<double> out(n, n);
    out.setFromTriplets(all.begin(), all.end());
    return out;
  }

 private:
  template <class Visit>
  void each(const Visit& visit) const {
    for (const auto& [columns, triangle] : accumulator_.triangles()) visit(columns, triangle);
  }

  const minimise::Accumulator& accumulator_;
};

/// How far a residual is spread: exact data go as far as arithmetic does.
double unit_of(double residual, double right_side, std::size_t rows, std::size_t unknowns) {
  const double deviation = rows > unknowns ? residual / std::sqrt(static_cast<double>(rows - unknowns)) : 0.0;
  return std::max(deviation, 1e-11 * right_side);
}

/// constrain() for many unknowns without ties; empty where the dense way is needed.
std::optional<Admissibility> constrain_sparse(const Plan& plan, const minimise::Accumulator& accumulator, std::size_t rows,
                                              minimise::LinearSolution& linear) {
  const AdmissibleSet& set = *plan.admissible;
  const std::size_t unknowns = linear.y.size();
  if (unknowns < many_unknowns || !set.ties.empty() || !plan.scene.identify.frequencies_hz.empty() ||
      accumulator.reduction() == minimise::Reduction::normal)
    return std::nullopt;
  const CompressedRows all(accumulator);
  const VectorXd theta = Eigen::Map<const VectorXd>(linear.y.data(), at(unknowns));
  const double unit = unit_of(all.residual(theta), all.right_side(), rows, unknowns);
  const auto fit = nearest_admissible(set, theta, all.information(), unit);
  if (!fit) return std::nullopt;
  linear.y.assign(fit->theta.begin(), fit->theta.end());
  linear.residual_norm = all.residual(fit->theta);
  return outcome_of(set, *fit, rows > unknowns ? unit : std::numeric_limits<double>::quiet_NaN());
}

}  // namespace

void tell_rank(const AdmissibleFit& fit, minimise::LinearSolution& linear) {
  linear.rank = linear.y.size() - static_cast<std::size_t>(fit.null_space.cols());
  linear.condition = fit.condition;
  linear.free_directions.clear();
  linear.undetermined.clear();
  if (fit.null_space.cols() > 0) minimise::tell_null_space(fit.null_space, linear);
}

Admissibility constrain(const Plan& plan, const minimise::Accumulator& accumulator, std::size_t rows,
                        minimise::LinearSolution& linear, bool& converged) {
  if (auto found = constrain_sparse(plan, accumulator, rows, linear)) return *found;
  const Eigen::MatrixXd system = minimise::reduced_system(accumulator);
  const Index n = system.cols() - 1;
  const Eigen::MatrixXd root = system.leftCols(n);
  const VectorXd theta = Eigen::Map<const VectorXd>(linear.y.data(), n);
  const double residual = (root * theta - system.col(n)).norm();
  const bool measurable = rows > linear.y.size();
  const double unit = unit_of(residual, system.col(n).norm(), rows, linear.y.size());
  const bool has_frequencies = !plan.scene.identify.frequencies_hz.empty();
  AdmissibleSet within;
  const AdmissibleFit fit = has_frequencies ? Eigenfrequencies(plan).nearest(plan.admissible.get(), theta, root, unit, within)
                                            : nearest_admissible(*plan.admissible, theta, root, unit);
  const AdmissibleSet& set = has_frequencies ? within : *plan.admissible;
  converged = fit.converged;
  linear.y.assign(fit.theta.begin(), fit.theta.end());
  linear.residual_norm = (root * fit.theta - system.col(n)).norm();
  if (!set.ties.empty()) tell_rank(fit, linear);
  return outcome_of(set, fit, measurable ? unit : std::numeric_limits<double>::quiet_NaN());
}

}  // namespace jointid::ident
