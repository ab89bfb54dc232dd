#include "correlation/criteria.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "modalfit/model/mac.hpp"

namespace jointid::correlation {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Inner products of what both have.
struct Products {
  Complex cross{};  ///< aᴴb
  double aa = 0.0, bb = 0.0;

  void add(Complex a, Complex b) {
    if (!is_number(a) || !is_number(b)) return;
    cross += std::conj(a) * b;
    aa += std::norm(a);
    bb += std::norm(b);
  }

  double shape() const { return std::norm(cross) / (aa * bb); }
};

Products products_of(std::span<const Complex> a, std::span<const Complex> b) {
  Products out;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) out.add(a[i], b[i]);
  return out;
}

std::span<const Complex> column(const MatrixXcd& of, Index c) { return {of.col(c).data(), static_cast<std::size_t>(of.rows())}; }

}  // namespace

bool is_number(Complex a) { return std::isfinite(a.real()) && std::isfinite(a.imag()); }

double frac(std::span<const Complex> a, std::span<const Complex> b) { return products_of(a, b).shape(); }

MatrixXd fdac(const MatrixXcd& a, const MatrixXcd& b) {
  MatrixXd out(a.cols(), b.cols());
  for (Index i = 0; i < a.cols(); ++i) {
    for (Index j = 0; j < b.cols(); ++j) out(i, j) = products_of(column(a, i), column(b, j)).shape();
  }
  return out;
}

double amplitude_criterion(std::span<const Complex> a, std::span<const Complex> b) {
  const Products of = products_of(a, b);
  return 2.0 * std::abs(of.cross) / (of.aa + of.bb);
}

double lac(Complex a, Complex b) { return 2.0 * std::abs(a) * std::abs(b) / (std::norm(a) + std::norm(b)); }

double coherence_criterion(Complex a, Complex b) { return std::norm(a + b) / (2.0 * (std::norm(a) + std::norm(b))); }

MatrixXd mac_matrix(const MatrixXcd& one, const MatrixXcd& other) {
  MatrixXd out(one.cols(), other.cols());
  for (Index i = 0; i < one.cols(); ++i) {
    for (Index j = 0; j < other.cols(); ++j) out(i, j) = modalfit::mac(column(one, i), column(other, j));
  }
  return out;
}

std::vector<std::optional<std::size_t>> paired(const MatrixXd& mac, double least) {
  std::vector<std::tuple<double, Index, Index>> all;
  for (Index i = 0; i < mac.rows(); ++i) {
    for (Index j = 0; j < mac.cols(); ++j) {
      if (mac(i, j) >= least) all.emplace_back(-mac(i, j), i, j);
    }
  }
  std::ranges::sort(all);
  std::vector<std::optional<std::size_t>> out(static_cast<std::size_t>(mac.rows()));
  std::vector<bool> taken(static_cast<std::size_t>(mac.cols()), false);
  for (const auto& [value, i, j] : all) {
    auto& partner = out[static_cast<std::size_t>(i)];
    if (partner || taken[static_cast<std::size_t>(j)]) continue;
    partner = static_cast<std::size_t>(j);
    taken[static_cast<std::size_t>(j)] = true;
  }
  return out;
}

VectorXd comac(const MatrixXcd& one, const MatrixXcd& other) {
  const VectorXd cross = one.cwiseProduct(other.conjugate()).cwiseAbs().rowwise().sum();
  return cross.cwiseAbs2().cwiseQuotient(one.rowwise().squaredNorm().cwiseProduct(other.rowwise().squaredNorm()));
}

VectorXd ecomac(const MatrixXcd& one, const MatrixXcd& other) {
  VectorXd sum = VectorXd::Zero(one.rows());
  for (Index r = 0; r < one.cols(); ++r) {
    const Complex cross = products_of(column(one, r), column(other, r)).cross;
    const Complex turn = cross == Complex(0.0) ? Complex(1.0) : std::conj(cross) / std::abs(cross);
    sum += (one.col(r).normalized() - turn * other.col(r).normalized()).cwiseAbs();
  }
  return sum / (2.0 * static_cast<double>(one.cols()));
}

}  // namespace jointid::correlation
