#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "base/eigen.hpp"
#include "coupling/condition.hpp"

namespace jointid::coupling {

/// Multi-step two-coordinate coupling (docs/formulas.md §8, thesis §5.6.4): one condition at a time, H ← H − d dᵀ/(h_ii + h_jj −
/// 2h_ij) with d = h_i − h_j, for a matrix that need not be symmetric H ← H − (H b)(bᵀH)/(bᵀH b). Once coupled, the second
/// coordinate is deleted, so that m steps of n coordinates cost Σ(n − k)(n − k + 1) multiplications (5.45). The steps are kept as
/// H − U Vᵀ, one column of U and V for each, and worked out where the next steps and the result need them: one product of
/// matrices at the end in place of one pass through H per step. `Scalar` is a type of numbers so that operations can be counted.
template <class Scalar>
class MtcSteps {
 public:
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

  /// At most `most` conditions will be coupled; `h` has to stay.
  MtcSteps(const Eigen::Ref<const Matrix>& h, Index most) : h_(h), left_(h.rows(), most), right_(h.cols(), most) {
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
    // The row before the deletion, as the pivot needs it; the column after.
    Vector row = h_(i.coordinate, column_of_).transpose(), at_row = left_.row(row_at_[index(i.coordinate)]).head(steps_);
    if (!ground) {
      subtract(row, h_(gone, column_of_).transpose(), sign);
      subtract(at_row, left_.row(row_at_[index(gone)]).head(steps_).transpose(), sign);
    }
    take(row, right_, at_row);
    Scalar pivot = row[column_at_[index(i.coordinate)]];
    Vector at_column = right_.row(column_at_[index(i.coordinate)]).head(steps_);
    if (!ground) {
      pivot -= signed_value(row[column_at_[index(gone)]], sign);
      subtract(at_column, right_.row(column_at_[index(gone)]).head(steps_).transpose(), sign);
    }
    remove(gone, row);
    Vector column = h_(row_of_, i.coordinate);
    if (!ground) subtract(column, h_(row_of_, gone), sign);
    take(column, left_, at_column);
    left_.col(steps_).head(column.size()) = column;
    right_.col(steps_).head(row.size()) = row * (Scalar(1.0) / pivot);
    ++steps_;
    same_[index(gone)] = ground ? Same{-1, 0.0} : Same{i.coordinate, sign};
  }

  /// An FRF of the assembly as coupled so far, by row and column of H.
  Scalar operator()(Index row, Index column) const {
    const Same r = find(row), c = find(column);
    if (r.coordinate < 0 || c.coordinate < 0) return Scalar(0.0);
    return signed_value(at(r, c), r.sign * c.sign);
  }

  /// All of them at the wanted rows and columns.
  Matrix frf(const Wanted& wanted) const {
    std::vector<Index> rows, columns;
    const Matrix left = gathered(wanted.rows, left_, row_at_, rows), right = gathered(wanted.columns, right_, column_at_, columns);
    Matrix out = h_(rows, columns);
    out.noalias() -= left * right.transpose();
    for (Index r = 0; r < out.rows(); ++r) {
      for (Index c = 0; c < out.cols(); ++c) {
        const double sign = find(wanted.rows[index(r)]).sign * find(wanted.columns[index(c)]).sign;
        if (sign != 1.0) out(r, c) = sign == 0.0 ? Scalar(0.0) : -out(r, c);
      }
    }
    return out;
  }

 private:
  /// What a coordinate has become: sign times another; 0 times −1 for ground.
  struct Same {
    Index coordinate;
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

  bool is_coordinate(Index i) const { return i < jointid::at(same_.size()); }

  Scalar at(const Same& i, const Same& j) const {
    Scalar value = h_(i.coordinate, j.coordinate);
    const Index r = row_at_[index(i.coordinate)], c = column_at_[index(j.coordinate)];
    for (Index k = 0; k < steps_; ++k) value -= left_(r, k) * right_(c, k);
    return value;
  }

  /// What the steps so far take from a column or row of H.
  void take(Vector& from, const Matrix& factors, const Vector& by) const {
    for (Index k = 0; k < steps_; ++k) from -= factors.col(k).head(from.size()) * by[k];
  }

  /// Rows of a factor for wanted coordinates, and the coordinates that stand for them (any for ground).
  Matrix gathered(const std::vector<Index>& wanted, const Matrix& factor, const std::vector<Index>& place,
                  std::vector<Index>& stands) const {
    Matrix out(jointid::at(wanted.size()), steps_);
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      stands.push_back(std::max(Index{0}, find(wanted[i]).coordinate));
      out.row(jointid::at(i)) = factor.row(place[index(stands.back())]).head(steps_);
    }
    return out;
  }

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

  /// Forgets a coordinate: in `row` and in the factors the last takes its place.
  void remove(Index coordinate, Vector& row) {
    const Index r = row_at_[index(coordinate)], c = column_at_[index(coordinate)];
    const Index last_row = jointid::at(row_of_.size()) - 1, last_column = jointid::at(column_of_.size()) - 1;
    row[c] = row[last_column];
    row.conservativeResize(last_column);
    left_.row(r).head(steps_).swap(left_.row(last_row).head(steps_));
    right_.row(c).head(steps_).swap(right_.row(last_column).head(steps_));
    exchange(row_at_, row_of_, r, last_row);
    exchange(column_at_, column_of_, c, last_column);
    row_of_.pop_back();
    column_of_.pop_back();
  }

  static void exchange(std::vector<Index>& at, std::vector<Index>& of, Index one, Index two) {
    std::swap(of[index(one)], of[index(two)]);
    at[index(of[index(one)])] = one;
    at[index(of[index(two)])] = two;
  }

  Eigen::Ref<const Matrix> h_;
  Matrix left_, right_;  ///< U and V; row k belongs to the coordinates row_of_[k] and column_of_[k]
  Index steps_ = 0;
  std::vector<Index> row_at_, column_at_;  ///< place in U and V by row and column of H
  std::vector<Index> row_of_, column_of_;  ///< and back; those that are not deleted
  std::vector<Same> same_;
};

}  // namespace jointid::coupling
