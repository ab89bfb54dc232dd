#include "ident/likelihood/errors/shared_variances.hpp"

#include <algorithm>
#include <cmath>

#include "base/eigen.hpp"
#include "dense/cholesky.hpp"

namespace jointid::ident {
namespace {

constexpr std::size_t lines_kept = 512;

}  // namespace

SharedVariances::SharedVariances(std::size_t lines, std::vector<std::size_t> kind, std::size_t kinds)
    : every_((lines + lines_kept - 1) / lines_kept), kinds_(kinds), kind_(std::move(kind)) {
  every_ = std::max<std::size_t>(1, every_);
  lines_.resize(kind_.empty() ? 0 : (lines + every_ - 1) / every_);
}

void SharedVariances::add(std::size_t line, const Eigen::VectorXd& gradient, const Eigen::MatrixXd& information) {
  Squares out = Squares::Zero(gradient.size(), at(2 + kinds_));
  out.col(0) = gradient.cwiseAbs2();
  out.col(1) = information.diagonal();
  for (std::size_t l = 0; l < kind_.size(); ++l) out.col(at(2 + kind_[l])) += information.col(at(l)).cwiseAbs2();
  lines_[line / every_] = std::move(out);
}

SharedVariances& SharedVariances::operator+=(SharedVariances other) {
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    if (other.lines_[i].size() > 0) lines_[i] = std::move(other.lines_[i]);
  }
  return *this;
}

std::vector<double> SharedVariances::numbers() const {
  std::vector<double> out;
  for (const Squares& line : lines_) {
    const Squares all = line.size() > 0 ? line : Squares::Zero(at(kind_.size()), at(2 + kinds_));
    out.insert(out.end(), all.data(), all.data() + all.size());
  }
  return out;
}

void SharedVariances::take(const std::vector<double>& numbers) {
  auto from = numbers.begin();
  for (Squares& line : lines_) {
    line.resize(at(kind_.size()), at(2 + kinds_));
    std::copy_n(from, line.size(), line.data());
    from += line.size();
  }
}

/// ∂E g²/∂τ², [errors, kinds]; not below zero, where the error is known better than the FRFs to it.
Eigen::MatrixXd SharedVariances::coefficients(const Squares& line, const Eigen::VectorXd& most) const {
  Eigen::MatrixXd out = line.rightCols(at(kinds_));
  for (std::size_t k = 0; k < kind_.size(); ++k) {
    const Eigen::Index own = at(kind_[k]);
    if (most[own] > 0.0) out(at(k), own) = std::max(0.0, out(at(k), own) - line(at(k), 1) / most[own]);
  }
  return out;
}

SharedVariances::Found SharedVariances::estimate(const Eigen::VectorXd& most) const {
  constexpr int most_steps = 30;
  constexpr double settled = 1e-3;
  const Eigen::Index n = at(kinds_);
  std::vector<Eigen::MatrixXd> coefficients;
  Eigen::VectorXd any = Eigen::VectorXd::Zero(n);
  for (const Squares& line : lines_) {
    coefficients.push_back(line.size() > 0 ? this->coefficients(line, most) : Eigen::MatrixXd());
    if (line.size() > 0) any += coefficients.back().colwise().sum().transpose();
  }
  std::vector<Eigen::Index> there;
  for (Eigen::Index kind = 0; kind < n; ++kind) {
    if (any[kind] > 0.0 && most[kind] > 0.0) there.push_back(kind);
  }
  Found out{.variance = Eigen::VectorXd::Zero(n), .covariance = Eigen::MatrixXd::Zero(n, n)};
  if (there.empty()) return out;
  const Eigen::Index size = at(there.size());
  Eigen::VectorXd used = 0.5 * most(there);
  for (int step = 0; step < most_steps; ++step) {
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size), scatter = matrix;
    Eigen::VectorXd right = Eigen::VectorXd::Zero(size);
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      Eigen::VectorXd score = Eigen::VectorXd::Zero(size);
      for (Eigen::Index k = 0; k < lines_[i].rows(); ++k) {
        if (!(lines_[i](k, 1) > 0.0)) continue;
        const Eigen::VectorXd c = coefficients[i](k, there).transpose();
        const double expected = lines_[i](k, 1) + c.dot(used), weight = 1.0 / (expected * expected);
        matrix += weight * c * c.transpose();
        right += weight * (lines_[i](k, 0) - lines_[i](k, 1)) * c;
        score += weight * (lines_[i](k, 0) - expected) * c;
      }
      scatter += score * score.transpose();
    }
    const Eigen::VectorXd next = dense::solve_symmetric(matrix, right);
    const Eigen::VectorXd within = next.cwiseMax(0.0).cwiseMin(most(there));
    out.variance(there) = next;
    const Eigen::MatrixXd inverse = dense::solve_symmetric(matrix, Eigen::MatrixXd::Identity(size, size));
    out.covariance(there, there) = inverse * scatter * inverse.transpose();
    const bool done = ((within - used).cwiseAbs().array() <= settled * (within + settled * most(there)).array()).all();
    used = within;
    if (done) break;
  }
  return out;
}

Eigen::VectorXd SharedVariances::significance(const Eigen::VectorXd& most) const {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(at(kinds_)), square = sum;
  for (const Squares& line : lines_) {
    for (Eigen::Index k = 0; k < line.rows(); ++k) {
      const Eigen::Index kind = at(kind_[static_cast<std::size_t>(k)]);
      const double own = line(k, 1), both = line(k, 2 + kind), expected = own + most[kind] * both;
      if (!(own > 0.0 && expected > 0.0)) continue;
      const double weight = both / (expected * expected);
      sum[kind] += weight * (line(k, 0) - own);
      square[kind] += 2.0 * weight * weight * both;  // at least the variance: 2 w_k w_l I_kl² ≤ (w_k² + w_l²) I_kl²
    }
  }
  return square.cwiseMax(1e-300).cwiseSqrt().cwiseInverse().cwiseProduct(sum);
}

}  // namespace jointid::ident
