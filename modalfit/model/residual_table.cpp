#include "modalfit/model/residual_table.hpp"

#include <algorithm>

#include "base/eigen.hpp"
#include "dense/minimum_norm.hpp"

namespace jointid::modalfit {
namespace {

/// Directions below this share of the largest would be blown-up noise.
constexpr double least_direction = 1e-2;

void scale(ResidualTerms& terms, double factor) {
  terms.lower *= factor;
  terms.upper *= factor;
  for (double& each : terms.covariance) each *= factor * factor;
}

}  // namespace

void ResidualTable::put(std::size_t a, std::size_t b, const ResidualTerms& terms) {
  if (!core_.has(b)) std::swap(a, b);
  ResidualTerms& there = terms_[index(a, b)];
  if (there.measured) {
    there.lower = 0.5 * (there.lower + terms.lower);
    there.upper = 0.5 * (there.upper + terms.upper);
    for (std::size_t i = 0; i < 16; ++i) there.covariance[i] = 0.25 * (there.covariance[i] + terms.covariance[i]);
  } else {
    there = terms;
  }
  if (core_.has(a)) terms_[index(b, a)] = there;
}

std::vector<std::size_t> ResidualTable::complete_columns() const {
  std::vector<std::size_t> complete;
  for (std::size_t c = 0; c < core_.size(); ++c) {
    bool all = core_.has(c);
    for (std::size_t r = 0; all && r < core_.size(); ++r) all = terms_[index(r, c)].measured;
    if (all) complete.push_back(c);
  }
  return complete;
}

ResidualTable::Completion ResidualTable::completion(std::complex<double> ResidualTerms::*term) const {
  const std::size_t n = core_.size(), k = columns_.size();
  Eigen::MatrixXcd tall(at(n), at(k)), square(at(k), at(k));
  for (std::size_t c = 0; c < k; ++c) {
    for (std::size_t r = 0; r < n; ++r) tall(at(r), at(c)) = terms_[index(r, columns_[c])].*term;
    for (std::size_t r = 0; r < k; ++r) square(at(r), at(c)) = terms_[index(columns_[r], columns_[c])].*term;
  }
  Eigen::MatrixXcd wide = dense::ComplexMinimumNorm(square, least_direction).solve(tall.transpose());
  return {std::move(tall), std::move(wide)};
}

void ResidualTable::complete() {
  columns_ = complete_columns();
  if (columns_.empty() || columns_.size() == core_.size()) {
    columns_.clear();
    return;
  }
  lower_ = completion(&ResidualTerms::lower);
  upper_ = completion(&ResidualTerms::upper);
}

ResidualTerms ResidualTable::between(std::size_t a, std::size_t b) const {
  if (!core_.has(b)) std::swap(a, b);
  const ResidualTerms measured = core_.has(b) ? terms_[index(a, b)] : ResidualTerms{};
  if (measured.measured || columns_.empty()) return measured;
  ResidualTerms out;
  const auto of = [&](const Completion& by) { return by.tall.row(at(a)).transpose().cwiseProduct(by.wide.col(at(b))).sum(); };
  out.lower = of(lower_);
  out.upper = of(upper_);
  const ResidualTerms &one = terms_[index(a, columns_.front())], &other = terms_[index(b, columns_.front())];
  for (std::size_t i = 0; i < 16; ++i) out.covariance[i] = std::max(one.covariance[i], other.covariance[i]);
  return out;
}

void ResidualTable::multiply(double factor) {
  for (ResidualTerms& terms : terms_) scale(terms, factor);
  for (Completion* each : {&lower_, &upper_}) each->tall *= factor;
}

}  // namespace jointid::modalfit
