#include "models/krylov_basis.hpp"

#include <Eigen/SparseCholesky>
#include <utility>

#include "base/eigen.hpp"

namespace jointid::models {
namespace {

constexpr double known_already = 1e-11;  ///< what is left of a unit vector that the basis has
constexpr double well_solved = 1e-10, unsolved = 1e-6;  ///< residual over right-hand side: without refinement, after it

}  // namespace

/// K − sM = L D Lᵀ without pivots, the order of elimination found once.
struct KrylovBasis::Factors {
  Eigen::SimplicialLDLT<Sparse> ldlt;
  bool ordered = false;

  bool factorize(const Sparse& shifted) {
    if (!std::exchange(ordered, true)) ldlt.analyzePattern(shifted);
    ldlt.factorize(shifted);
    return ldlt.info() == Eigen::Success;
  }

  /// In place, refined once where it takes that: pivots of an indefinite matrix may be small.
  bool solve(const Sparse& shifted, Eigen::MatrixXd& x) const {
    const Eigen::MatrixXd right = x;
    x = ldlt.solve(right);
    Eigen::MatrixXd rest = right - shifted * x;
    const auto error = [&] { return (rest.colwise().norm().array() / right.colwise().norm().array()).maxCoeff(); };
    if (error() <= well_solved) return true;
    x += ldlt.solve(rest);
    rest = right - shifted * x;
    return error() <= unsolved;
  }
};

KrylovBasis::KrylovBasis(const Sparse& stiffness, const Sparse& mass, const std::vector<std::size_t>& inputs, double sigma)
    : stiffness_(stiffness),
      mass_(mass),
      inputs_(inputs),
      sigma_(sigma),
      positive_(std::make_unique<Factors>()),
      factors_(std::make_unique<Factors>()) {
  make_room(8 * at(inputs_.size()));
}

KrylovBasis::~KrylovBasis() = default;

bool KrylovBasis::begin() {
  const Sparse shifted = stiffness_ + sigma_ * mass_;
  return positive_->factorize(shifted) && (positive_->ldlt.vectorD().array() > 0.0).all() &&
         add(*positive_, shifted, Eigen::MatrixXd::Identity(at(inputs_.size()), at(inputs_.size())));
}

bool KrylovBasis::add(double shift, const Eigen::MatrixXd& combinations) {
  const Sparse shifted = stiffness_ - shift * mass_;
  return factors_->factorize(shifted) && add(*factors_, shifted, combinations);
}

bool KrylovBasis::add(const Factors& factors, const Sparse& shifted, const Eigen::MatrixXd& combinations) {
  Eigen::MatrixXd x = Eigen::MatrixXd::Zero(shifted.rows(), combinations.cols());
  for (std::size_t j = 0; j < inputs_.size(); ++j) x.row(at(inputs_[j])) = combinations.row(at(j));
  if (!factors.solve(shifted, x)) return false;
  Eigen::MatrixXd derivative = mass_ * x;
  if (!factors.solve(shifted, derivative)) return false;
  for (const Eigen::MatrixXd* block : {&x, &derivative}) {
    for (Eigen::Index j = 0; j < block->cols(); ++j) append(block->col(j));
  }
  return true;
}

void KrylovBasis::make_room(Eigen::Index columns) {
  basis_.conservativeResize(stiffness_.rows(), columns);
  for (Eigen::MatrixXd* reduced : {&reduced_stiffness_, &reduced_mass_, &reached_}) reduced->conservativeResize(columns, columns);
}

void KrylovBasis::append(Eigen::VectorXd vector) {
  double norm = vector.norm();
  if (!(norm > 0.0)) return;
  vector /= norm;
  double left = 1.0;
  constexpr int most_passes = 4;
  for (int pass = 0; pass < most_passes; ++pass) {
    vector -= basis_.leftCols(size_) * (basis_.leftCols(size_).transpose() * vector);
    norm = vector.norm();
    left *= norm;
    if (!(left > known_already)) return;
    vector /= norm;
    if (norm > 0.5) break;  // at right angles to rounding
  }
  if (size_ == basis_.cols()) make_room(2 * size_);
  basis_.col(size_) = vector;
  const Eigen::Index row = size_++;
  const Eigen::VectorXd mass = mass_ * vector;
  const auto put = [&](const Eigen::VectorXd& product, Eigen::MatrixXd& reduced) {
    reduced.col(row).head(size_) = basis_.leftCols(size_).transpose() * product;
    reduced.row(row).head(size_) = reduced.col(row).head(size_).transpose();
  };
  put(stiffness_ * vector, reduced_stiffness_);
  put(mass, reduced_mass_);
  put(mass_ * positive_->ldlt.solve(mass), reached_);
}

Eigen::MatrixXd KrylovBasis::inputs() const {
  Eigen::MatrixXd out(at(inputs_.size()), size_);
  for (std::size_t i = 0; i < inputs_.size(); ++i) out.row(at(i)) = basis_.row(at(inputs_[i])).head(size_);
  return out;
}

}  // namespace jointid::models
