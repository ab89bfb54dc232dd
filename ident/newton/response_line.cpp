#include "ident/newton/response_line.hpp"

#include <cmath>

#include "coupling/joint_loop.hpp"

namespace jointid::ident {
namespace {

bool finite(Complex value) { return std::isfinite(value.real()) && std::isfinite(value.imag()); }

}  // namespace

ResponseLine::ResponseLine(ReachableFrfs frfs, JointImpedance joint) : frfs_(std::move(frfs)), joint_(std::move(joint)) {
  if (joint_.columns().empty() || !frfs_.bb.allFinite()) return;
  reciprocal_ = frfs_.bb == frfs_.bb.transpose() && frfs_.ab.rows() == frfs_.ba.cols() && frfs_.ab.transpose() == frfs_.ba;
  for (Eigen::Index row = 0; row < frfs_.nn.rows(); ++row) {
    const bool to_joint = frfs_.ab.row(row).allFinite();
    for (Eigen::Index column = 0; column < frfs_.nn.cols(); ++column) {
      const Complex change = frfs_.aa(row, column) - frfs_.nn(row, column);
      if (!to_joint || !frfs_.ba.col(column).allFinite() || !finite(change)) continue;
      entries_.push_back({row, column});
      change_ += std::norm(change);
    }
  }
}

/// H_jn of the prediction.
Eigen::MatrixXcd ResponseLine::to_joint(const Eigen::MatrixXcd& z) const {
  return coupling::motion_with_joint(frfs_.bb, z, frfs_.ba);
}

bool ResponseLine::residual_of(const Eigen::MatrixXcd& z, const Eigen::MatrixXcd& h_jn, double* f) const {
  const Eigen::MatrixXcd change = frfs_.ab * (z * h_jn);
  bool defined = true;
  for (std::size_t e = 0; e < entries_.size(); ++e) {
    const auto [row, column] = entries_[e];
    const Complex value = frfs_.nn(row, column) - frfs_.aa(row, column) + change(row, column);
    defined = defined && finite(value);
    f[e] = value.real();
    f[entries_.size() + e] = value.imag();
  }
  return defined;
}

bool ResponseLine::residual(const std::vector<double>& theta, double* f) const {
  const Eigen::MatrixXcd z = joint_.at(theta);
  return residual_of(z, to_joint(z), f);
}

bool ResponseLine::linearise(const std::vector<double>& theta, double* f, double* jacobian) const {
  const Eigen::MatrixXcd z = joint_.at(theta), h_jn = to_joint(z);
  if (!residual_of(z, h_jn, f)) return false;
  Eigen::MatrixXcd h_nj;  // transposed: a column per response
  if (!reciprocal_) {
    h_nj = coupling::motion_from_joint(frfs_.ab, z, frfs_.bb).transpose();
  }
  const Eigen::MatrixXcd& from_joint = reciprocal_ ? h_jn : h_nj;
  const std::size_t count = columns().size();
  std::vector<Complex> derivative(count);
  for (std::size_t e = 0; e < entries_.size(); ++e) {
    joint_.sensitivity(from_joint.col(entries_[e].row).data(), h_jn.col(entries_[e].column).data(), derivative.data());
    for (std::size_t t = 0; t < count; ++t) {
      if (!finite(derivative[t])) return false;
      jacobian[e * count + t] = derivative[t].real();
      jacobian[(entries_.size() + e) * count + t] = derivative[t].imag();
    }
  }
  return true;
}

double ResponseLine::correlation(const double* f) const {
  double product = 0.0, predicted = 0.0, measured = 0.0;
  for (std::size_t e = 0; e < entries_.size(); ++e) {
    const Complex there = frfs_.nn(entries_[e].row, entries_[e].column);
    const Complex here = there - Complex(f[e], f[entries_.size() + e]);
    product += std::real(std::conj(here) * there);
    predicted += std::norm(here);
    measured += std::norm(there);
  }
  const double norms = std::sqrt(predicted) * std::sqrt(measured);
  return norms > 0.0 ? product / norms : 0.0;
}

}  // namespace jointid::ident
