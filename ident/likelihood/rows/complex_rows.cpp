#include "ident/likelihood/rows/complex_rows.hpp"

#include <algorithm>
#include <map>

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
  const auto append = [](std::vector<Complex>& to, const Complex* from, std::size_t count) {
    to.resize(to.size() + count);
    std::transform(from, from + count, to.end() - static_cast<std::ptrdiff_t>(count), [](const Complex& z) { return std::conj(z); });
  };
  append(heads_, row, head);
  append(tails_, row + head, columns() - tail_);
}

void ComplexRows::finish() {
  if (rows_.empty()) return;
  const Eigen::Index width = at(columns() - tail_), tail = at(tail_);
  const Eigen::Map<const MatrixXcd> tails(tails_.data(), width, at(rows_.size()));
  dense::add_square(tails, normal_.bottomRightCorner(width, width));
  struct Part {
    std::size_t row, at;  // of a row that touches the run, and of its coefficients in heads_
  };
  struct Touching {
    Eigen::Index count = 0;  // of the run's columns
    std::vector<Part> parts;
  };
  std::map<std::size_t, Touching> runs;  // by their first column
  const auto touch = [&runs](Run run, const Part& part) {
    if (run.count == 0) return;
    Touching& of = runs[run.first];
    of.count = at(run.count);
    of.parts.push_back(part);
  };
  const auto head = [this](std::size_t from, Eigen::Index count) {
    return Eigen::Map<const Eigen::VectorXcd>(heads_.data() + from, count);
  };
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    const auto& [first, second, place] = rows_[r];
    touch(first, {r, place});
    touch(second, {r, place + first.count});
    if (second.count == 0) continue;
    const auto one = head(place, at(first.count)), two = head(place + first.count, at(second.count));
    normal_.block(at(second.first), at(first.first), two.size(), one.size()).noalias() += two * one.adjoint();
  }
  MatrixXcd run, common;
  for (const auto& [column, touching] : runs) {
    const auto& [count, parts] = touching;
    run.resize(count, at(parts.size()));
    common.resize(width, at(parts.size()));
    for (std::size_t i = 0; i < parts.size(); ++i) {
      run.col(at(i)) = head(parts[i].at, count);
      common.col(at(i)) = tails.col(at(parts[i].row));
    }
    dense::add_square(run, normal_.block(at(column), at(column), count, count));
    dense::add_product(common, run, normal_.block(tail, at(column), width, count));
  }
}

}  // namespace jointid::ident
