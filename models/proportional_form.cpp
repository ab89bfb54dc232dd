#include "models/proportional_form.hpp"

#include <algorithm>
#include <set>

#include "base/eigen.hpp"

namespace jointid::models {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

constexpr double by_rounding = 1e-13;  ///< of the norm of a damping matrix

/// X = m M + k K + rest.
struct Combination {
  double m = 0.0, k = 0.0;
  Sparse rest;
};

/// The nearest combination of M and K if nothing but rounding is left of it; else all of X is left.
Combination combination(const Sparse& x, const Sparse& mass, const Sparse& stiffness) {
  if (x.rows() == 0) return {0.0, 0.0, Sparse(mass.rows(), mass.rows())};
  const auto inner = [](const Sparse& a, const Sparse& b) { return a.cwiseProduct(b).sum(); };
  const double mm = inner(mass, mass), kk = inner(stiffness, stiffness), mk = inner(mass, stiffness);
  const double mx = inner(mass, x), kx = inner(stiffness, x), determinant = mm * kk - mk * mk;
  Combination out{(mx * kk - kx * mk) / determinant, (kx * mm - mx * mk) / determinant, {}};
  out.rest = x - out.m * mass - out.k * stiffness;
  // A share that is rounding of the other one is none.
  const double size = x.norm();
  if (std::abs(out.m) * mass.norm() < by_rounding * size) out.m = 0.0;
  if (std::abs(out.k) * stiffness.norm() < by_rounding * size) out.k = 0.0;
  if (out.rest.norm() <= by_rounding * size) return {out.m, out.k, Sparse(mass.rows(), mass.rows())};
  return {0.0, 0.0, x};
}

void add_coordinates(const Sparse& matrix, std::set<std::size_t>& to) {
  for (Eigen::Index c = 0; c < matrix.outerSize(); ++c) {
    for (Sparse::InnerIterator e(matrix, c); e; ++e) {
      if (e.value() != 0.0) to.insert({static_cast<std::size_t>(c), static_cast<std::size_t>(e.row())});
    }
  }
}

Eigen::MatrixXd elements_at(const Sparse& matrix, const std::vector<std::size_t>& places) {
  Eigen::MatrixXd out(at(places.size()), at(places.size()));
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t j = 0; j < places.size(); ++j) out(at(i), at(j)) = matrix.coeff(at(places[i]), at(places[j]));
  }
  return out;
}

}  // namespace

std::optional<ProportionalForm> proportional_form(const StructureMatrices& matrices, std::size_t most_dampers) {
  const Combination c = combination(matrices.viscous_damping, matrices.mass, matrices.stiffness);
  const Combination d = combination(matrices.hysteretic_damping, matrices.mass, matrices.stiffness);
  std::set<std::size_t> dampers;
  add_coordinates(c.rest, dampers);
  add_coordinates(d.rest, dampers);
  if (dampers.size() > most_dampers) return std::nullopt;
  ProportionalForm out;
  out.loss = matrices.loss_factor + d.k;
  out.d_m = d.m;
  out.c_k = c.k;
  out.c_m = c.m;
  out.dampers.assign(dampers.begin(), dampers.end());
  out.rest_c = elements_at(c.rest, out.dampers);
  out.rest_d = elements_at(d.rest, out.dampers);
  return out;
}

}  // namespace jointid::models
