#include "ident/likelihood/line/complex_rows.hpp"

#include "base/eigen.hpp"
#include "dense/blas.hpp"

namespace jointid::ident {

using Eigen::MatrixXcd;

void ComplexRows::reset(std::size_t columns, std::size_t tail) {
  normal_.setZero(at(columns), at(columns));
  tail_ = tail;
  rows_.clear();
  heads_.clear();
  tails_.clear();
}

void ComplexRows::add(const Complex* row, Run first, Run second) {
  const std::size_t head = first.count + second.count;
  rows_.push_back({first, second, heads_.size()});
  for (std::size_t i = 0; i < head; ++i) heads_.push_back(std::conj(row[i]));
  for (std::size_t i = 0; i < columns() - tail_; ++i) tails_.push_back(std::conj(row[head + i]));
}

void ComplexRows::finish() {
  if (rows_.empty()) return;
  const Eigen::Index width = at(columns() - tail_), tail = at(tail_);
  const Eigen::Map<const MatrixXcd> tails(tails_.data(), width, at(rows_.size()));
  dense::add_square(tails, normal_.bottomRightCorner(width, width));
  struct Part {
    std::size_t row, at;  // of a row that touches the run, and of its coefficients in heads_
  };
  std::map<std::size_t, std::vector<Part>> parts;  // by the first column of a run
  std::map<std::size_t, Eigen::Index> counts;
  const auto head = [this](std::size_t from, Eigen::Index count) {
    return Eigen::Map<const Eigen::VectorXcd>(heads_.data() + from, count);
  };
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    const auto& [first, second, place] = rows_[r];
    if (first.count > 0) parts[first.first].push_back({r, place});
    if (second.count > 0) parts[second.first].push_back({r, place + first.count});
    if (first.count > 0) counts[first.first] = at(first.count);
    if (second.count == 0) continue;
    counts[second.first] = at(second.count);
    const auto one = head(place, at(first.count)), two = head(place + first.count, at(second.count));
    normal_.block(at(second.first), at(first.first), two.size(), one.size()).noalias() += two * one.adjoint();
  }
  MatrixXcd run, common;
  for (const auto& [column, touching] : parts) {
    const Eigen::Index count = counts[column];
    run.resize(count, at(touching.size()));
    common.resize(width, at(touching.size()));
    for (std::size_t i = 0; i < touching.size(); ++i) {
      run.col(at(i)) = head(touching[i].at, count);
      common.col(at(i)) = tails.col(at(touching[i].row));
    }
    dense::add_square(run, normal_.block(at(column), at(column), count, count));
    dense::add_product(common, run, normal_.block(tail, at(column), width, count));
  }
}

}  // namespace jointid::ident
