#include "minimise/linear/sparse_covariance.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <limits>

#include "base/eigen.hpp"

namespace jointid::minimise {
namespace {

using NormalMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, std::int64_t>;
using Factor = Eigen::SimplicialLDLT<NormalMatrix, Eigen::Lower, Eigen::AMDOrdering<std::int64_t>>;

/// y = Z(S,S) l of a column with the rows S, from the columns of Z that are known.
class KnownPart {
 public:
  KnownPart(const std::vector<std::size_t>& start, const std::vector<std::size_t>& row, const std::vector<double>& value,
            const std::vector<double>& diagonal)
      : start_(start), row_(row), value_(value), diagonal_(diagonal), place_(diagonal.size(), none) {}

  void multiply(std::size_t column, const double* l, std::vector<double>& y) {
    const std::size_t first = start_[column], count = start_[column + 1] - first;
    y.assign(count, 0.0);
    for (std::size_t k = 0; k < count; ++k) place_[row_[first + k]] = k;
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t of = row_[first + k];
      y[k] += diagonal_[of] * l[k];
      for (std::size_t e = start_[of]; e < start_[of + 1]; ++e) {
        const std::size_t at_row = place_[row_[e]];
        if (at_row == none) continue;
        y[at_row] += value_[e] * l[k];
        y[k] += value_[e] * l[at_row];
      }
    }
    for (std::size_t k = 0; k < count; ++k) place_[row_[first + k]] = none;
  }

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  const std::vector<std::size_t>&start_, &row_;
  const std::vector<double>&value_, &diagonal_;
  std::vector<std::size_t> place_;
};

}  // namespace

SparseCovariance::SparseCovariance(const StackedTriangles& stacked) {
  const SparseSymmetric normal = normal_matrix(stacked);
  const NormalMatrix matrix = Eigen::Map<const NormalMatrix>(at(normal.size()), at(normal.size()), at(normal.value.size()),
                                                             normal.start.data(), normal.row.data(), normal.value.data());
  const Factor factor(matrix);
  if (factor.info() != Eigen::Success || !(factor.vectorD().array() > 0.0).all()) return;
  const std::size_t n = normal.size();
  const NormalMatrix& l = factor.matrixL().nestedExpression();
  start_.push_back(0);
  for (Eigen::Index k = 0; k < at(n); ++k) {
    for (NormalMatrix::InnerIterator entry(l, k); entry; ++entry) {
      if (entry.row() > k) {
        row_.push_back(static_cast<std::size_t>(entry.row()));
        value_.push_back(entry.value());
      }
    }
    start_.push_back(row_.size());
  }
  for (std::size_t j = 0; j < n; ++j) place_.push_back(static_cast<std::size_t>(factor.permutationP().indices()[at(j)]));
  diagonal_.assign(n, 0.0);
  KnownPart known(start_, row_, value_, diagonal_);
  std::vector<double> y;
  for (std::size_t k = n; k-- > 0;) {
    double* column = value_.data() + start_[k];
    known.multiply(k, column, y);
    double sum = 0.0;
    for (std::size_t e = 0; e < y.size(); ++e) {
      sum += column[e] * y[e];
      column[e] = -y[e];
    }
    diagonal_[k] = 1.0 / factor.vectorD()[at(k)] + sum;
  }
}

std::vector<double> SparseCovariance::variances() const {
  std::vector<double> out;
  for (const std::size_t place : place_) out.push_back(diagonal_[place]);
  return out;
}

double SparseCovariance::operator()(std::size_t i, std::size_t j) const {
  const std::size_t row = std::max(place_[i], place_[j]), column = std::min(place_[i], place_[j]);
  if (row == column) return diagonal_[row];
  const auto first = row_.begin() + static_cast<std::ptrdiff_t>(start_[column]),
             last = row_.begin() + static_cast<std::ptrdiff_t>(start_[column + 1]);
  const auto found = std::lower_bound(first, last, row);
  if (found == last || *found != row) return std::numeric_limits<double>::quiet_NaN();
  return value_[static_cast<std::size_t>(found - row_.begin())];
}

}  // namespace jointid::minimise
