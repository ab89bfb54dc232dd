#include "models/proportional_form.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/eigen.hpp"

namespace jointid::models {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

constexpr double by_rounding = 1e-12;  ///< of an element over what it is made of, or a tenth of the largest, √(K_ii K_jj) as unit

/// X = m M + k K + rest.
struct Combination {
  double m = 0.0, k = 0.0;
  Sparse rest;
};

/// Elements of X, M and K at the same places, over √(K_ii K_jj), those of M so that they are as large as K's.
struct Elements {
  Eigen::ArrayXd x, m, k;
  double mass_unit = 1.0;
  Sparse places;
};

Elements elements_of(const Sparse& x, const Sparse& mass, const Sparse& stiffness) {
  const Sparse nowhere = 0.0 * (stiffness + mass + x);
  const Eigen::VectorXd scale = stiffness.diagonal().cwiseAbs().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const auto of = [&](const Sparse& matrix) {
    Sparse out = nowhere + Sparse(scale.asDiagonal() * matrix * scale.asDiagonal());
    out.makeCompressed();
    return out;
  };
  const auto values = [](const Sparse& matrix) { return Eigen::Map<const Eigen::ArrayXd>(matrix.valuePtr(), matrix.nonZeros()); };
  const Sparse k = of(stiffness);
  Elements out{values(of(x)), values(of(mass)), values(k), 1.0, k};
  out.mass_unit = out.k.abs().maxCoeff() / out.m.abs().maxCoeff();
  out.m *= out.mass_unit;
  return out;
}

/// The least-squares combination over the elements that fit best, found in turn with these (least trimmed squares): damping that is
/// proportional but at few coordinates leaves nothing anywhere else.
Combination combination(const Sparse& x, const Sparse& mass, const Sparse& stiffness) {
  Combination out{0.0, 0.0, Sparse(mass.rows(), mass.rows())};
  if (x.rows() == 0 || x.nonZeros() == 0) return out;
  const Elements all = elements_of(x, mass, stiffness);
  const double size = all.x.abs().maxCoeff();
  Eigen::ArrayXd rest = all.x, made_of;
  Eigen::ArrayXd weight = Eigen::ArrayXd::Ones(rest.size());
  constexpr int passes = 40;
  for (int pass = 0; pass < passes; ++pass) {
    const double mm = (weight * all.m.square()).sum(), kk = (weight * all.k.square()).sum(), mk = (weight * all.m * all.k).sum();
    const double mx = (weight * all.m * all.x).sum(), kx = (weight * all.k * all.x).sum(), determinant = mm * kk - mk * mk;
    if (!(determinant > 0.0)) break;
    out.m = (mx * kk - kx * mk) / determinant;
    out.k = (kx * mm - mx * mk) / determinant;
    rest = all.x - out.m * all.m - out.k * all.k;
    std::vector<double> sizes(static_cast<std::size_t>(rest.size()));
    std::ranges::transform(rest, sizes.begin(), [](double each) { return std::abs(each); });
    const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
    std::ranges::nth_element(sizes, middle);
    made_of = all.x.abs() + (out.m * all.m).abs() + (out.k * all.k).abs();
    const Eigen::ArrayXd next = (rest.abs() <= (10.0 * by_rounding * made_of).max(3.0 * *middle)).cast<double>();
    if ((next == weight).all()) break;
    weight = next;
  }
  // A share that is rounding of the other one is none.
  if (std::abs(out.m) < by_rounding * size) out.m = 0.0;
  if (std::abs(out.k) < by_rounding * size) out.k = 0.0;
  out.m *= all.mass_unit;
  std::vector<Eigen::Triplet<double>> left;
  Eigen::Index place = 0;
  for (Eigen::Index c = 0; c < all.places.outerSize(); ++c) {
    for (Sparse::InnerIterator e(all.places, c); e; ++e, ++place) {
      if (std::abs(rest(place)) <= by_rounding * std::max(made_of(place), 0.1 * size)) continue;
      const double value = x.coeff(e.row(), c) - out.m * mass.coeff(e.row(), c) - out.k * stiffness.coeff(e.row(), c);
      left.emplace_back(static_cast<int>(e.row()), static_cast<int>(c), value);
    }
  }
  out.rest.setFromTriplets(left.begin(), left.end());
  return out;
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
