#include "ident/likelihood/elimination/eliminated_columns.hpp"

#include "base/eigen.hpp"
#include "dense/blas.hpp"

namespace jointid::ident {

void take_square(const ComplexMatrix& p, const std::vector<WeighedRow>& rows, ComplexMatrix& room, ComplexMatrix& out) {
  room.resize(p.cols(), at(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) room.col(at(i)) = rows[i].weight * p.row(at(rows[i].row)).adjoint();
  out.setZero(p.cols(), p.cols());
  dense::add_square(room, out);
  out.triangularView<Eigen::StrictlyUpper>() = out.adjoint();
}

EliminatedColumns::EliminatedColumns(const LineLayout& layout)
    : layout_(layout), columns_(layout.others), measured_(layout.others) {
  for (std::size_t k = 0; k < layout.others; ++k) {
    columns_[k].first = at(layout.sub_jn_first[k]);
    columns_[k].count = at(layout.sub_jn_first[k + 1] - layout.sub_jn_first[k]);
  }
  for (std::size_t i = 0; i < layout.asm_jn.size(); ++i) measured_[layout.asm_jn[i].column].push_back(i);
}

ComplexMatrix EliminatedColumns::rows_of(std::size_t k, const Eigen::Ref<const ComplexMatrix>& from) const {
  const Column& column = columns_[k];
  ComplexMatrix out(column.count, from.cols());
  for (Eigen::Index i = 0; i < column.count; ++i) {
    out.row(i) = from.row(at(layout_.sub_jn[static_cast<std::size_t>(column.first + i)].row));
  }
  return out;
}

void EliminatedColumns::take(const LineData& data, const ComplexMatrix& p) {
  std::vector<WeighedRow> rows;
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    rows.clear();
    for (const std::size_t i : measured_[k]) {
      if (const double weight = data.asm_jn.weight[i].real(); weight > 0.0) rows.push_back({layout_.asm_jn[i].row, weight});
    }
    take_square(p, rows, room_, columns_[k].square);
    columns_[k].pulled = rows_of(k, columns_[k].square).adjoint();
  }
}

bool EliminatedColumns::factor(const Eigen::VectorXd& weights) {
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    Column& c = columns_[k];
    c.left = c.square;
    c.answer.resize(c.count, c.square.cols());
    if (c.count == 0) continue;
    c.lower = rows_of(k, c.pulled);
    c.lower.diagonal().real() += weights.segment(c.first, c.count);
    if (!dense::cholesky_in_place(c.lower)) return false;
    c.answer = c.pulled.adjoint();
    dense::solve_lower(c.lower, c.answer);
    room_.setZero(c.square.rows(), c.square.cols());
    dense::add_square(c.answer.adjoint().eval(), room_);
    c.left.triangularView<Eigen::Lower>() -= room_;
    c.left.triangularView<Eigen::StrictlyUpper>() = c.left.adjoint();
    dense::solve_lower_adjoint(c.lower, c.answer);
  }
  return true;
}

}  // namespace jointid::ident
