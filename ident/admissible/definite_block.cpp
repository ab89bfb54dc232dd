#include "ident/admissible/definite_block.hpp"

#include <cmath>

#include "base/eigen.hpp"
#include "dense/pivoted_qr.hpp"

namespace jointid::ident {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr double asymmetry = 1e-12;  ///< of coefficients that rounding makes, in parts of the largest
constexpr double unreached = 1e-10;  ///< a direction that coefficients reach less is none

bool is_symmetric(const MatrixXd& m) { return (m - m.transpose()).cwiseAbs().maxCoeff() <= asymmetry * m.cwiseAbs().maxCoeff(); }

/// Orthonormal basis of what the matrices reach together, each counted by its largest element.
MatrixXd range_of(const std::vector<MatrixXd>& matrices, Index size) {
  MatrixXd side_by_side = MatrixXd::Zero(size, size * at(matrices.size()));
  for (std::size_t i = 0; i < matrices.size(); ++i) {
    const double largest = matrices[i].cwiseAbs().maxCoeff();
    if (largest > 0.0) side_by_side.middleCols(size * at(i), size) = matrices[i] / largest;
  }
  const dense::RealPivotedQr qr(side_by_side, unreached);
  if (qr.rank() == size) return MatrixXd::Identity(size, size);
  return qr.orthonormal_columns(qr.rank());
}

std::vector<BlockEntry> entries_of(const MatrixXd& matrix) {
  std::vector<BlockEntry> entries;
  for (Index column = 0; column < matrix.cols(); ++column) {
    for (Index row = 0; row < matrix.rows(); ++row) {
      if (matrix(row, column) != 0.0) entries.push_back({row, column, matrix(row, column)});
    }
  }
  return entries;
}

}  // namespace

std::optional<SymmetricBlock> definite_block(const std::vector<BlockPart>& parts, std::size_t first, std::size_t count, double unit) {
  const auto size = at(count);
  const auto within = [&](std::size_t i) { return static_cast<Index>(i - first); };
  std::map<std::size_t, MatrixXd> coefficients;  // by column
  MatrixXd known = MatrixXd::Zero(size, size);
  for (const BlockPart& part : parts) {
    for (const restrictions::Term& term : part.matrix.terms) {
      const auto column = part.column_of.find(term.unknown);
      if (column == part.column_of.end()) continue;
      MatrixXd& own = coefficients.try_emplace(column->second, MatrixXd::Zero(size, size)).first->second;
      own(within(term.row), within(term.column)) += term.coefficient * (part.factor * part.unit / unit);
    }
    for (const restrictions::Known& element : part.matrix.known) {
      if (element.row < first || element.row >= first + count) continue;
      known(within(element.row), within(element.column)) += element.value * part.factor / unit;
    }
  }
  std::vector<MatrixXd> all = {known};
  for (const auto& [column, own] : coefficients) all.push_back(own);
  for (const MatrixXd& each : all) {
    if (!is_symmetric(each)) return std::nullopt;
  }
  const MatrixXd basis = range_of(all, size);
  const bool whole = basis.cols() == size;
  const auto reduced = [&](const MatrixXd& full) -> MatrixXd {
    if (whole) return full;
    const MatrixXd inner = basis.transpose() * full * basis;
    return 0.5 * (inner + inner.transpose());
  };
  SymmetricBlock block{.constant = reduced(known), .unknowns = {}, .coefficients = {}};
  for (const auto& [column, own] : coefficients) {
    block.unknowns.push_back(at(column));
    block.coefficients.push_back(entries_of(reduced(own)));
  }
  return block;
}

std::optional<SymmetricBlock> definite_block(const restrictions::MatrixTerms& matrix, std::size_t first, std::size_t count,
                                             const std::map<std::size_t, std::size_t>& column_of, double unit) {
  return definite_block(std::vector<BlockPart>{{matrix, column_of, unit, 1.0}}, first, count, unit);
}

}  // namespace jointid::ident
