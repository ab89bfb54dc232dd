#include "models/krylov_basis.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
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
      positive_(positive_factors(stiffness.rows())),
      factors_(std::make_unique<Factors>()) {
  make_room(8 * at(inputs_.size()));
}

KrylovBasis::~KrylovBasis() = default;

bool KrylovBasis::begin() {
  if (!positive_->factorize(stiffness_ + sigma_ * mass_)) return false;
  append(positive_->solve(forces(Eigen::MatrixXd::Identity(at(inputs_.size()), at(inputs_.size())))));
  add_power();
  return true;
}

void KrylovBasis::add_power() { append(std::move(power_)); }

bool KrylovBasis::add(double shift, const Eigen::MatrixXd& combinations) {
  const Sparse shifted = stiffness_ - shift * mass_;
  if (!factors_->factorize(shifted)) return false;
  Eigen::MatrixXd x = forces(combinations);
  if (!factors_->solve(shifted, x)) return false;
  Eigen::MatrixXd derivative = mass_ * x;
  if (!factors_->solve(shifted, derivative)) return false;
  Eigen::MatrixXd both(x.rows(), 2 * x.cols());
  both << x, derivative;
  append(std::move(both));
  return true;
}

/// Unit forces at the inputs, combined.
Eigen::MatrixXd KrylovBasis::forces(const Eigen::MatrixXd& combinations) const {
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(stiffness_.rows(), combinations.cols());
  for (std::size_t j = 0; j < inputs_.size(); ++j) out.row(at(inputs_[j])) = combinations.row(at(j));
  return out;
}

void KrylovBasis::make_room(Eigen::Index columns) {
  basis_.conservativeResize(stiffness_.rows(), columns);
  for (Eigen::MatrixXd* reduced : {&reduced_stiffness_, &reduced_mass_, &reached_}) reduced->conservativeResize(columns, columns);
}

/// At right angles to what is there as one block, twice, and then to each other.
void KrylovBasis::append(Eigen::MatrixXd block) {
  if (block.cols() == 0) return;
  const Eigen::Index first = size_;
  if (size_ + block.cols() > basis_.cols()) make_room(std::max(2 * size_, size_ + block.cols()));
  Eigen::VectorXd left = Eigen::VectorXd::Ones(block.cols());
  for (int pass = 0; pass < 3; ++pass) {
    if (pass > 0) block -= basis_.leftCols(first) * (basis_.leftCols(first).transpose() * block);
    for (Eigen::Index j = 0; j < block.cols(); ++j) {
      const double norm = block.col(j).norm();
      if (pass > 0) left[j] *= norm;
      if (norm > 0.0) block.col(j) /= norm;
    }
  }
  for (Eigen::Index j = 0; j < block.cols(); ++j) take(block.col(j), left[j], first);
  if (size_ > first) reduce_from(first);
}

/// What is new of a vector of length 1, of which `left` was there before the projections. It is at right angles to the first
/// vectors.
void KrylovBasis::take(Eigen::VectorXd vector, double left, Eigen::Index first) {
  constexpr int most_passes = 4;
  Eigen::Index from = first;
  for (int pass = 0; pass < most_passes; ++pass) {
    const auto others = basis_.middleCols(from, size_ - from);
    vector -= others * (others.transpose() * vector);
    const double norm = vector.norm();
    left *= norm;
    if (!(left > known_already)) return;
    vector /= norm;
    if (norm > 0.5) break;  // at right angles to rounding
    from = 0;               // what cancels here lets rounding along the first vectors grow
  }
  basis_.col(size_++) = vector;
}

void KrylovBasis::reduce_from(Eigen::Index first) {
  const Eigen::Index count = size_ - first;
  const auto all = basis_.leftCols(size_), added = basis_.middleCols(first, count);
  const auto put = [&](const Eigen::MatrixXd& product, Eigen::MatrixXd& reduced) {
    reduced.block(0, first, size_, count) = all.transpose() * product;
    reduced.block(first, 0, count, first) = reduced.block(0, first, first, count).transpose();
  };
  const Eigen::MatrixXd mass = mass_ * added;
  power_ = positive_->solve(mass);
  put(stiffness_ * added, reduced_stiffness_);
  put(mass, reduced_mass_);
  put(mass_ * power_, reached_);
}

Eigen::MatrixXd KrylovBasis::inputs() const {
  Eigen::MatrixXd out(at(inputs_.size()), size_);
  for (std::size_t i = 0; i < inputs_.size(); ++i) out.row(at(i)) = basis_.row(at(inputs_[i])).head(size_);
  return out;
}

}  // namespace jointid::models
