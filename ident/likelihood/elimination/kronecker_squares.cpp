#include "ident/likelihood/elimination/kronecker_squares.hpp"

#include <algorithm>

#include "base/eigen.hpp"
#include "base/kernel.hpp"
#include "dense/blas.hpp"

namespace jointid::ident {
namespace {

/// Pairs of columns of one product: its result stays in the cache.
constexpr std::size_t most_pairs = 64;

struct ColumnPair {
  std::size_t first, second;  // columns of Y
};

}  // namespace

KroneckerSquares::KroneckerSquares(const LineLayout& layout) : joint_(layout.joint), place_(layout.joint * layout.joint, -1) {
  std::vector<std::vector<std::size_t>> rows(joint_);
  for (std::size_t i = 0; i < layout.sub_jj.size(); ++i) {
    const auto [row, column] = layout.sub_jj[i];
    place_[row + column * joint_] = place_[column + row * joint_] = at(i);
    rows[column].push_back(row);
    if (row != column) rows[row].push_back(column);
  }
  for (std::size_t column = 0; column < joint_; ++column) {
    std::ranges::sort(rows[column]);
    if (rows[column].empty()) continue;
    if (const auto group = std::ranges::find(groups_, rows[column], &Group::rows); group != groups_.end()) {
      group->columns.push_back(column);
    } else {
      groups_.push_back(Group{{column}, rows[column]});
    }
  }
}

void KroneckerSquares::reset(std::size_t most) {
  squares_.resize(at(joint_ * joint_), at(most));
  vectors_.resize(at(joint_), at(most));
  used_ = 0;
}

void KroneckerSquares::put(const Eigen::Ref<const ComplexMatrix>& t, const Eigen::Ref<const Eigen::VectorXcd>& g) {
  Eigen::Map<ComplexMatrix>(squares_.col(used_).data(), t.rows(), t.cols()) = t;
  vectors_.col(used_++) = g;
}

void KroneckerSquares::add_to(ComplexMatrix& normal) {
  for (std::size_t a = 0; a < groups_.size(); ++a) {
    for (std::size_t b = a; b < groups_.size(); ++b) add_pairs(groups_[a], groups_[b], normal);
  }
}

void KroneckerSquares::add_pairs(const Group& one, const Group& other, ComplexMatrix& normal) {
  const std::size_t m = one.rows.size(), n = other.rows.size();
  blocks_.resize(at(m * n), used_);
  for (Eigen::Index k = 0; k < used_; ++k) {
    Complex* out = blocks_.col(k).data();
    for (const std::size_t column : other.rows) {
      const Complex* const from = squares_.col(k).data() + column * joint_;
      for (const std::size_t row : one.rows) *out++ = from[row];
    }
  }
  std::vector<ColumnPair> pairs;
  for (std::size_t j = 0; j < other.columns.size(); ++j) {
    const std::size_t last = &one == &other ? j + 1 : one.columns.size();
    for (std::size_t i = 0; i < last; ++i) pairs.push_back({one.columns[i], other.columns[j]});
  }
  for (std::size_t first = 0; first < pairs.size(); first += most_pairs) {
    const std::size_t count = std::min(most_pairs, pairs.size() - first);
    factors_.resize(at(count), used_);
    for (Eigen::Index k = 0; k < used_; ++k) {
      for (std::size_t p = 0; p < count; ++p) {
        const auto [i, j] = pairs[first + p];
        factors_(at(p), k) = product(vectors_(at(i), k), std::conj(vectors_(at(j), k)));
      }
    }
    products_.setZero(at(m * n), at(count));
    dense::add_product(blocks_, factors_, products_);
    for (std::size_t p = 0; p < count; ++p) {
      const auto [i, j] = pairs[first + p];
      const Complex* from = products_.col(at(p)).data();
      for (const std::size_t second_row : other.rows) {
        const Eigen::Index second = place_[second_row + j * joint_];
        for (const std::size_t first_row : one.rows) {
          const Eigen::Index place = place_[first_row + i * joint_];
          const Complex value = *from++;
          if (place >= second) normal(place, second) += value;
          if (i != j && second >= place) normal(second, place) += std::conj(value);
        }
      }
    }
  }
}

}  // namespace jointid::ident
