#include "modalfit/model/rank_one.hpp"

#include <algorithm>
#include <cmath>

#include "base/complex.hpp"
#include "base/eigen.hpp"
#include "dense/cholesky.hpp"
#include "dense/svd.hpp"
#include "minimise/damping.hpp"

namespace jointid::modalfit {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::VectorXcd;

constexpr int most_iterations = 100;

double cost_of(const std::vector<RankOneDatum>& data, const VectorXcd& phi) {
  double cost = 0.0;
  for (const RankOneDatum& datum : data) cost += datum.weight * std::norm(datum.value - phi(at(datum.row)) * phi(at(datum.column)));
  return cost;
}

/// Places of the coordinates that are rows (or columns) of the data.
struct Side {
  std::vector<std::size_t> coordinate;
  std::vector<Index> place;  ///< [n] or −1

  Side(const std::vector<RankOneDatum>& data, Index size, std::size_t RankOneDatum::*of) : place(static_cast<std::size_t>(size), -1) {
    for (const RankOneDatum& datum : data) place[datum.*of] = 0;
    for (std::size_t i = 0; i < place.size(); ++i) {
      if (place[i] < 0) continue;
      place[i] = at(coordinate.size());
      coordinate.push_back(i);
    }
  }
  bool has(std::size_t i) const { return place[i] >= 0; }
};

/// First singular vectors of the elements as measured, u on rows and v on columns, over all coordinates.
struct SingularVectors {
  VectorXcd u, v;
  double sigma = 0.0;

  SingularVectors(const std::vector<RankOneDatum>& data, const Side& rows, const Side& columns) {
    MatrixXcd matrix = MatrixXcd::Zero(at(rows.coordinate.size()), at(columns.coordinate.size()));
    for (const RankOneDatum& datum : data) matrix(rows.place[datum.row], columns.place[datum.column]) = datum.value;
    u = v = VectorXcd::Zero(at(rows.place.size()));
    if (data.empty()) return;
    const dense::ComplexSvd svd = dense::svd(matrix, dense::Vectors::thin, dense::Vectors::thin);
    for (std::size_t i = 0; i < rows.coordinate.size(); ++i) u(at(rows.coordinate[i])) = svd.u(at(i), 0);
    for (std::size_t i = 0; i < columns.coordinate.size(); ++i) v(at(columns.coordinate[i])) = std::conj(svd.v(at(i), 0));
    sigma = svd.sigma(0);
  }
};

VectorXcd made_real(VectorXcd phi) {
  if (phi.size() == 0) return phi;
  Index largest = 0;
  phi.cwiseAbs().maxCoeff(&largest);
  if (std::abs(phi(largest)) > 0.0) phi *= std::abs(phi(largest)) / phi(largest);
  return phi.real().cast<Complex>();
}

/// The singular vectors brought to one scale where a coordinate is row and column.
VectorXcd start(const std::vector<RankOneDatum>& data, Index size, bool real) {
  const Side rows(data, size, &RankOneDatum::row), columns(data, size, &RankOneDatum::column);
  const SingularVectors first(data, rows, columns);
  Complex both = 0.0;
  double square = 0.0;
  for (Index i = 0; i < size; ++i) {
    if (!rows.has(static_cast<std::size_t>(i)) || !columns.has(static_cast<std::size_t>(i))) continue;
    both += std::conj(first.v(i)) * first.u(i);
    square += std::norm(first.v(i));
  }
  const Complex ratio = std::abs(both) > 0.0 && square > 0.0 ? both / square : Complex(1.0);  // u = ratio·v
  const Complex scale = real ? std::sqrt(first.sigma / std::abs(ratio)) : std::sqrt(first.sigma / ratio);
  VectorXcd phi(size);
  for (Index i = 0; i < size; ++i) phi(i) = rows.has(static_cast<std::size_t>(i)) ? scale * first.u(i) : scale * ratio * first.v(i);
  return real ? made_real(std::move(phi)) : phi;
}

/// JᴴWJ of the core and the rest, and JᴴW(value − φφᵀ), coordinates in the order of their places.
class NormalEquations {
 public:
  explicit NormalEquations(Core core)
      : core_(std::move(core)),
        own_(at(core_.count), at(core_.count)),
        cross_(at(core_.rest()), at(core_.count)),
        rest_(at(core_.rest())),
        right_(at(core_.size())) {}

  void form(const std::vector<RankOneDatum>& data, const VectorXcd& phi, bool real) {
    own_.setZero();
    cross_.setZero();
    rest_.setZero();
    right_.setZero();
    for (const RankOneDatum& datum : data) {
      const Complex by_i = phi(at(datum.column)), by_j = phi(at(datum.row));  // both add up on the diagonal
      const Complex rest = datum.weight * (datum.value - by_i * by_j);
      const std::size_t i = core_.place[datum.row], j = core_.place[datum.column];
      right_(at(i)) += std::conj(by_i) * rest;
      right_(at(j)) += std::conj(by_j) * rest;
      add(i, i, datum.weight * std::norm(by_i));
      add(j, j, datum.weight * std::norm(by_j));
      add(i, j, datum.weight * std::conj(by_i) * by_j);
      add(j, i, datum.weight * std::conj(by_j) * by_i);
    }
    if (real) right_ = right_.real().cast<Complex>();
  }

  /// (JᴴWJ + mu·diagonal)⁻¹ JᴴW(value − φφᵀ), in the order of coordinates.
  VectorXcd step(double mu) const {
    const Scaled scaled(*this, 1.0 + mu);
    const Index k = own_.rows(), m = rest_.size();
    const VectorXcd y = scaled.scale.cwiseProduct(right_);
    VectorXcd z(k + m);
    z.head(k) = dense::solve_positive(scaled.core, y.head(k) - scaled.cross.adjoint() * y.tail(m) / diagonal);
    z.tail(m) = (y.tail(m) - scaled.cross * z.head(k)) / diagonal;
    VectorXcd out(k + m);
    for (std::size_t i = 0; i < core_.size(); ++i) out(at(i)) = scaled.scale(at(core_.place[i])) * z(at(core_.place[i]));
    return out;
  }

  ShapeCovariance covariance() const {
    const Scaled scaled(*this, 1.0);
    const Index k = own_.rows(), m = rest_.size();
    const MatrixXcd inverse = dense::solve_positive(scaled.core, MatrixXcd::Identity(k, k));
    const auto of_core = scaled.scale.head(k), of_rest = scaled.scale.tail(m);
    MatrixXcd with_core(k + m, k), slope = -(of_rest.asDiagonal() * scaled.cross) / diagonal;
    with_core.topRows(k) = of_core.asDiagonal() * inverse * of_core.asDiagonal();
    with_core.bottomRows(m) = slope * inverse * of_core.asDiagonal();
    for (Index c = 0; c < k; ++c) slope.col(c) *= of_core(c) > 0.0 ? 1.0 / of_core(c) : 0.0;
    return {core_, std::move(with_core), std::move(slope), of_rest.cwiseAbs2() / diagonal};
  }

  /// Coordinates that the data say something of.
  std::size_t told() const {
    return static_cast<std::size_t>((own_.diagonal().real().array() > 0.0).count() + (rest_.array() > 0.0).count());
  }

 private:
  static constexpr double diagonal = 1.0 + 1e-12;

  /// Unit diagonal, the rest eliminated from the core.
  struct Scaled {
    Eigen::VectorXd scale;  ///< [k+m] 0 where nothing tells
    MatrixXcd core, cross;

    Scaled(const NormalEquations& of, double factor) : scale(of.own_.rows() + of.rest_.size()) {
      const Index k = of.own_.rows();
      scale << of.own_.diagonal().real(), of.rest_;
      scale = (scale * factor).cwiseSqrt().cwiseInverse();
      for (double& each : scale) each = std::isfinite(each) ? each : 0.0;
      core = scale.head(k).asDiagonal() * of.own_ * scale.head(k).asDiagonal();
      core.diagonal().setConstant(diagonal);
      cross = scale.tail(of.rest_.size()).asDiagonal() * of.cross_ * scale.head(k).asDiagonal();
      if (cross.rows() > 0) core -= cross.adjoint() * cross / diagonal;
    }
  };

  /// Element (i, j) by places; those of the rest with the core are kept once.
  void add(std::size_t i, std::size_t j, Complex value) {
    if (i < core_.count && j < core_.count) own_(at(i), at(j)) += value;
    if (i >= core_.count && j < core_.count) cross_(at(i - core_.count), at(j)) += value;
    if (i >= core_.count && j == i) rest_(at(i - core_.count)) += value.real();
  }

  Core core_;
  MatrixXcd own_, cross_;
  Eigen::VectorXd rest_;
  VectorXcd right_;
};

}  // namespace

Core core_of(const std::vector<RankOneDatum>& data, std::size_t size) {
  std::vector<bool> row(size), column(size);
  for (const RankOneDatum& datum : data) row[datum.row] = column[datum.column] = true;
  return Core(std::ranges::count(column, true) <= std::ranges::count(row, true) ? column : row);
}

RankOne fit_rank_one(const std::vector<RankOneDatum>& data, std::size_t size, bool real) {
  const Index n = at(size);
  VectorXcd phi = start(data, n, real);
  NormalEquations equations(core_of(data, size));
  double cost = cost_of(data, phi);
  minimise::Damping damping({.first = 0.0, .least = 0.0, .most = 1e10, .again = 1e-3});
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    equations.form(data, phi, real);
    const VectorXcd step = equations.step(damping.value());
    const double next = cost_of(data, phi + step);
    const bool small = step.norm() <= 1e-12 * phi.norm();
    if (next <= cost) {
      phi += step;
      cost = next;
      damping.less();
    } else {
      damping.more();
    }
    if (small || damping.is_spent()) break;
  }
  equations.form(data, phi, real);
  Index largest = 0;
  if (n > 0) phi.cwiseAbs().maxCoeff(&largest);
  if (n > 0 && phi(largest).real() < 0.0) phi = -phi;
  const double freedom = static_cast<double>(data.size()) - static_cast<double>(equations.told());
  return {{phi.data(), phi.data() + n}, equations.covariance(), freedom > 0.0 ? cost / freedom : std::nan("")};
}

}  // namespace jointid::modalfit
