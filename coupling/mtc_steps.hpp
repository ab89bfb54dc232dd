#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "coupling/condition.hpp"

namespace jointid::coupling {

/// Multi-step two-coordinate coupling (thesis §5.6.4): one condition at a time, H ← H − d dᵀ/(h_ii + h_jj − 2h_ij) with
/// d = h_i − h_j, for a matrix that need not be symmetric H ← H − (H b)(bᵀH)/(bᵀH b). Once coupled, the second coordinate is
/// deleted, so that step k of n rows costs (n − k)(n − k + 1) multiplications (5.45). `Scalar` is a type of numbers so that
/// operations can be counted.
template <class Scalar>
class MtcSteps {
 public:
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

  explicit MtcSteps(Matrix h) : h_(std::move(h)), rows_(h_.rows()), columns_(h_.cols()) {
    for (Index i = 0; i < h_.rows(); ++i) row_at_.push_back(i), row_of_.push_back(i), same_.push_back({i, 1.0});
    for (Index i = 0; i < h_.cols(); ++i) column_at_.push_back(i), column_of_.push_back(i);
  }

  /// Receptances of the two coordinates of a condition as coupled so far: h_ii, h_jj, s·h_ij, s·h_ji; zero for ground.
  struct Receptances {
    Scalar ii{}, jj{}, ij{}, ji{};
  };
  Receptances receptances(const Condition& condition) const {
    const auto [i, j] = resolve(condition);
    Receptances out;
    if (i.coordinate >= 0) out.ii = at(i, i);
    if (j.coordinate >= 0) out.jj = at(j, j);
    if (i.coordinate >= 0 && j.coordinate >= 0) {
      out.ij = signed_value(at(i, j), i.sign * j.sign);
      out.ji = signed_value(at(j, i), i.sign * j.sign);
    }
    return out;
  }

  /// Couples the two coordinates of a condition that the conditions before do not imply.
  void couple(const Condition& condition) {
    auto [i, j] = resolve(condition);
    if (i.coordinate < 0) std::swap(i, j);
    const double sign = i.sign * j.sign;
    const bool ground = j.coordinate < 0;
    const Index gone = ground ? i.coordinate : j.coordinate;
    Vector column = h_.col(column_at_[index(i.coordinate)]).head(rows_);
    Vector row = h_.row(row_at_[index(i.coordinate)]).head(columns_).transpose();
    if (!ground) {
      subtract(column, h_.col(column_at_[index(gone)]).head(rows_), sign);
      subtract(row, h_.row(row_at_[index(gone)]).head(columns_).transpose(), sign);
    }
    Scalar pivot = row[column_at_[index(i.coordinate)]];
    if (!ground) pivot -= signed_value(row[column_at_[index(gone)]], sign);
    remove(gone, column, row);
    const Vector scaled = row.head(columns_) * (Scalar(1.0) / pivot);
    h_.topLeftCorner(rows_, columns_).noalias() -= column.head(rows_) * scaled.transpose();
    same_[index(gone)] = ground ? Same{-1, 0.0} : Same{i.coordinate, sign};
  }

  /// An FRF of the assembly as coupled so far, by row and column of H.
  Scalar operator()(Index row, Index column) const {
    const Same r = find(row), c = find(column);
    if (r.coordinate < 0 || c.coordinate < 0) return Scalar(0.0);
    return signed_value(at(r, c), r.sign * c.sign);
  }

 private:
  struct Same {
    Index coordinate;  ///< −1: ground
    double sign;
  };

  static std::size_t index(Index i) { return static_cast<std::size_t>(i); }
  static Scalar signed_value(Scalar value, double sign) { return sign > 0.0 ? value : -value; }
  template <class Other>
  static void subtract(Vector& from, const Other& other, double sign) {
    if (sign > 0.0) {
      from -= other;
    } else {
      from += other;
    }
  }

  bool is_coordinate(Index i) const { return i < static_cast<Index>(same_.size()); }
  Scalar at(const Same& i, const Same& j) const { return h_(row_at_[index(i.coordinate)], column_at_[index(j.coordinate)]); }

  Same find(Index coordinate) const {
    Same here{coordinate, 1.0};
    while (here.coordinate >= 0 && is_coordinate(here.coordinate) && same_[index(here.coordinate)].coordinate != here.coordinate) {
      const Same next = same_[index(here.coordinate)];
      here = {next.coordinate, here.sign * next.sign};
    }
    return here;
  }

  std::pair<Same, Same> resolve(const Condition& condition) const {
    Same j{-1, 0.0};
    if (condition.second) {
      j = find(*condition.second);
      j.sign *= condition.sign;
    }
    return {find(condition.first), j};
  }

  /// Puts the row and the column of a coordinate last and forgets them.
  void remove(Index coordinate, Vector& column, Vector& row) {
    const Index r = row_at_[index(coordinate)], c = column_at_[index(coordinate)];
    --rows_;
    --columns_;
    h_.row(r).swap(h_.row(rows_));
    h_.col(c).swap(h_.col(columns_));
    std::swap(column[r], column[rows_]);
    std::swap(row[c], row[columns_]);
    exchange(row_at_, row_of_, r, rows_);
    exchange(column_at_, column_of_, c, columns_);
  }

  static void exchange(std::vector<Index>& at, std::vector<Index>& of, Index one, Index two) {
    std::swap(of[index(one)], of[index(two)]);
    at[index(of[index(one)])] = one;
    at[index(of[index(two)])] = two;
  }

  Matrix h_;
  Index rows_, columns_;                                      ///< not deleted yet, first in h_
  std::vector<Index> row_at_, row_of_, column_at_, column_of_;  ///< where row i of H is now, and back
  std::vector<Same> same_;                                    ///< what a deleted coordinate has become
};

}  // namespace jointid::coupling
