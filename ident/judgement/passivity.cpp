#include "ident/judgement/passivity.hpp"

#include <algorithm>
#include <cmath>

#include "base/eigen.hpp"
#include "base/text.hpp"
#include "dense/eigen.hpp"
#include "restrictions/impedance_factor.hpp"

namespace jointid::ident {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Smaller parts of the largest eigenvalue are what a slightly wrong model of the joint makes.
constexpr double least_share = 0.05;
/// Of the largest element: what rounding makes of a zero.
constexpr double rounding_share = 1e-9;

/// X(theta) in SI units with the columns of a line, and its derivative by a column along v: Σ coefficient·v_row v_column.
struct OneMatrix {
  const restrictions::MatrixTerms& terms;
  std::vector<std::size_t> columns;  ///< one per unknown of the restriction
  double unscale;

  MatrixXd at(const std::vector<double>& theta, Index size) const {
    MatrixXd x = MatrixXd::Zero(size, size);
    for (const auto& [row, column, unknown, coefficient] : terms.terms) {
      x(jointid::at(row), jointid::at(column)) += coefficient * theta[columns[unknown]] * unscale;
    }
    for (const auto& [row, column, value] : terms.known) x(jointid::at(row), jointid::at(column)) += value;
    return 0.5 * (x + x.transpose());
  }

  VectorXd gradient(const VectorXd& v, std::size_t all) const {
    VectorXd g = VectorXd::Zero(jointid::at(all));
    for (const auto& [row, column, unknown, coefficient] : terms.terms) {
      g[jointid::at(columns[unknown])] += coefficient * unscale * v[jointid::at(row)] * v[jointid::at(column)];
    }
    return g;
  }
};

VectorXd unit_diagonal(const MatrixXd& x) {
  return x.diagonal().unaryExpr([](double element) { return element == 0.0 ? 1.0 : 1.0 / std::sqrt(std::abs(element)); });
}

void find_active(const Plan& plan, const OneMatrix& matrix, const std::optional<Range>& band, const std::vector<double>& theta,
                 const MatrixXd& covariance, double deviations, std::vector<ActiveMotion>& out) {
  const MatrixXd x = matrix.at(theta, at(plan.restriction.dofs.size()));
  if (!x.allFinite()) return;
  const VectorXd scale = unit_diagonal(x);
  const dense::SymmetricEigen eigen = dense::symmetric_eigen(scale.asDiagonal() * x * scale.asDiagonal());
  const double largest = eigen.values.cwiseAbs().maxCoeff();
  for (Index i = 0; i < eigen.values.size() && eigen.values[i] < -least_share * largest; ++i) {
    const VectorXd v = scale.cwiseProduct(eigen.vectors.col(i));
    const VectorXd g = matrix.gradient(v, theta.size());
    const double deviation = std::sqrt(std::max(0.0, g.dot(covariance * g)));
    if (!(eigen.values[i] < -deviations * deviation)) continue;
    Index most = 0;
    eigen.vectors.col(i).cwiseAbs().maxCoeff(&most);
    out.push_back({matrix.terms.kind, band, eigen.values[i] / largest, deviation / largest,
                   plan.restriction.dofs[static_cast<std::size_t>(most)]});
  }
}

void find_negative(const Plan& plan, const OneMatrix& matrix, const std::optional<Range>& band, const std::vector<double>& theta,
                   const MatrixXd& covariance, double deviations, std::vector<NegativeDiagonal>& out) {
  const Index n = at(plan.restriction.dofs.size());
  const MatrixXd x = matrix.at(theta, n);
  if (!x.allFinite()) return;
  for (Index i = 0; i < n; ++i) {
    if (!(x(i, i) < 0.0)) continue;
    const VectorXd g = matrix.gradient(VectorXd::Unit(n, i), theta.size());
    const double deviation = std::sqrt(std::max(0.0, g.dot(covariance * g)));
    if (x(i, i) < -deviations * deviation && x(i, i) < -rounding_share * x.cwiseAbs().maxCoeff())
      out.push_back({matrix.terms.kind, band, plan.restriction.dofs[static_cast<std::size_t>(i)], x(i, i), deviation});
  }
}

/// Of every coordinate 1/√ of the largest element among those of its kind, translation or rotation.
VectorXd unit_of_kind(const MatrixXd& x, const Dofs& dofs) {
  double largest[] = {0.0, 0.0};
  for (Index i = 0; i < x.rows(); ++i) {
    for (Index j = 0; j < x.cols(); ++j) {
      const bool rotation = dofs[static_cast<std::size_t>(i)].is_rotation();
      if (rotation != dofs[static_cast<std::size_t>(j)].is_rotation()) continue;
      largest[rotation ? 1 : 0] = std::max(largest[rotation ? 1 : 0], std::abs(x(i, j)));
    }
  }
  VectorXd out(x.rows());
  for (Index i = 0; i < x.rows(); ++i) {
    const double own = largest[dofs[static_cast<std::size_t>(i)].is_rotation() ? 1 : 0];
    out[i] = own > 0.0 ? 1.0 / std::sqrt(own) : 0.0;
  }
  return out;
}

/// K, C and D of every band.
template <class Look>
void each_matrix(const Plan& plan, const Look& look) {
  const std::vector<double>& limits = plan.columns->limits_hz();
  for (std::size_t k = 0; k < std::max<std::size_t>(1, limits.empty() ? 1 : limits.size() - 1); ++k) {
    const bool bands = !limits.empty();
    const std::vector<std::size_t> columns = plan.columns->at(bands ? 0.5 * (limits[k] + limits[k + 1]) : 0.0);
    if (columns.empty()) continue;
    const std::optional<Range> band = bands ? std::optional(Range{limits[k], limits[k + 1]}) : std::nullopt;
    for (const restrictions::MatrixTerms& terms : plan.restriction.matrices) {
      if (terms.kind == restrictions::Kind::mass) continue;
      look(OneMatrix{terms, columns, unscale(terms.kind, plan.omega0)}, band);
    }
  }
}

}  // namespace

std::string of_matrix(restrictions::Kind kind) {
  std::string matrix = restrictions::key(kind);
  std::ranges::replace(matrix, '_', ' ');
  return matrix + " " + restrictions::symbol(kind);
}

std::vector<ActiveMotion> active_motions(const Plan& plan, const std::vector<double>& theta, const MatrixXd& covariance,
                                         double deviations) {
  std::vector<ActiveMotion> out;
  each_matrix(plan, [&](const OneMatrix& matrix, const std::optional<Range>& band) {
    find_active(plan, matrix, band, theta, covariance, deviations, out);
  });
  std::ranges::stable_sort(out, {}, &ActiveMotion::eigenvalue);
  return out;
}

std::vector<NegativeDiagonal> negative_diagonals(const Plan& plan, const std::vector<double>& theta, const MatrixXd& covariance,
                                                 double deviations) {
  std::vector<NegativeDiagonal> out;
  each_matrix(plan, [&](const OneMatrix& matrix, const std::optional<Range>& band) {
    find_negative(plan, matrix, band, theta, covariance, deviations, out);
  });
  std::ranges::stable_sort(out, {}, [](const NegativeDiagonal& each) { return each.value / each.deviation; });
  return out;
}

std::vector<Indefinite> indefinite_matrices(const Plan& plan, const std::vector<double>& theta, double share) {
  std::vector<Indefinite> out;
  each_matrix(plan, [&](const OneMatrix& matrix, const std::optional<Range>& band) {
    const MatrixXd x = matrix.at(theta, at(plan.restriction.dofs.size()));
    if (!x.allFinite()) return;
    const VectorXd scale = unit_of_kind(x, plan.restriction.dofs);
    const VectorXd values = dense::symmetric_eigen(scale.asDiagonal() * x * scale.asDiagonal()).values;
    const double largest = values.cwiseAbs().maxCoeff();
    if (values.minCoeff() < -share * largest) out.push_back({matrix.terms.kind, band, values.minCoeff() / largest});
  });
  std::ranges::stable_sort(out, {}, &Indefinite::share);
  return out;
}

std::string text(const ActiveMotion& motion) {
  return of_matrix(motion.kind) + " has a negative eigenvalue, " + digits(motion.eigenvalue) + " ± " +
         digits(motion.deviation, "%.1g") + " of its largest, with most motion at " + motion.most_moved.name();
}

std::string text(const NegativeDiagonal& element) {
  return of_matrix(element.kind) + " is negative at " + element.dof.name() + ", " + digits(element.value, "%.3g") + " ± " +
         digits(element.deviation);
}

}  // namespace jointid::ident
