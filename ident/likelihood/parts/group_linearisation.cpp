#include "ident/likelihood/parts/group_linearisation.hpp"

#include <algorithm>
#include <cmath>

#include "base/eigen.hpp"
#include "dense/blas.hpp"

namespace jointid::ident {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

GroupLinearisation::GroupLinearisation(const PartGroup& group, const PartGroups& all, const GroupLine& line,
                                       const GroupImpedance& impedance)
    : group_(group), line_(line), references_(all.references.size()), conditions_(group, all.references.size(), line, impedance) {
  std::size_t first = 0;
  for (std::size_t s = 0; s < group.members.size(); ++s) {
    const GroupMember& member = group.members[s];
    deviation_.push_back(line.variance.parts[s].cwiseSqrt());
    first_.push_back(first);
    first += member.rows.size() * member.columns.size();
    member_of_row_.resize(member_of_row_.size() + member.rows.size(), s);
  }
  form_blocks();
  eliminate();
}

void GroupLinearisation::form_blocks() {
  const Index n = at(group_.rows), p = at(group_.unknowns.size());
  const MatrixXcd w = conditions_.misfit();
  for (std::size_t l = 0; l < references_; ++l) {
    std::vector<Index> rows;
    for (Index m = 0; m < n; ++m) {
      if (line_.active(m, at(l))) rows.push_back(m);
    }
    Block block{MatrixXcd::Zero(n, n), MatrixXcd::Zero(n, p + 1), MatrixXcd::Zero(n, p + 1)};
    if (!rows.empty()) {
      const MatrixXcd g = conditions_.by_motion()(rows, Eigen::all) * line_.variance.motion.col(at(l)).cwiseSqrt().asDiagonal();
      MatrixXcd d = g * g.adjoint();
      const VectorXd scale = d.diagonal().real().cwiseSqrt().cwiseInverse();
      d = scale.asDiagonal() * d * scale.asDiagonal();
      d.diagonal().array() += 1e-13;  // rounding
      MatrixXcd inverse = MatrixXcd::Identity(d.rows(), d.rows());
      if (dense::cholesky_in_place(d)) {
        dense::solve_lower(d, inverse);
        dense::solve_lower_adjoint(d, inverse);
      }
      block.inverse(rows, rows) = scale.asDiagonal() * inverse * scale.asDiagonal();
      block.plain << conditions_.by_unknown(l), w.col(at(l));
      block.right = block.inverse * block.plain;
    }
    blocks_.push_back(std::move(block));
  }
}

/// With U = ∂c/∂H · deviations and D the blocks, M⁻¹ = D⁻¹ − D⁻¹U P⁻¹UᴴD⁻¹, P = 1 + UᴴD⁻¹U.
void GroupLinearisation::eliminate() {
  const Index n = at(group_.rows), p = at(group_.unknowns.size()), k = at(group_.frfs()), references = at(references_);
  MatrixXcd product = MatrixXcd::Identity(k, k), gram = MatrixXcd::Zero(p + 1, p + 1);
  reduced_ = MatrixXcd::Zero(k, p + 1);
  const auto place = [&](Index m) {
    const std::size_t s = member_of_row_[std::size_t(m)];
    const GroupMember& member = group_.members[s];
    return std::pair(s, at(first_[s] + (std::size_t(m) - member.first_row) * member.columns.size()));
  };
  const auto deviations = [&](Index m) {
    const std::size_t s = member_of_row_[std::size_t(m)];
    return VectorXd(deviation_[s].row(m - at(group_.members[s].first_row)).transpose());
  };
  Eigen::RowVectorXcd weights(references);
  for (Index m = 0; m < n; ++m) {
    const auto [s, first] = place(m);
    const VectorXd own = deviations(m);
    MatrixXcd right(references, p + 1);
    for (Index l = 0; l < references; ++l) right.row(l) = blocks_[std::size_t(l)].right.row(m);
    reduced_.middleRows(first, own.size()) = own.asDiagonal() * (conditions_.by_frf()[s].conjugate() * right);
    for (Index other = 0; other <= m; ++other) {
      const auto [t, begin] = place(other);
      for (Index l = 0; l < references; ++l) weights[l] = blocks_[std::size_t(l)].inverse(m, other);
      const VectorXd its = deviations(other);
      product.block(first, begin, own.size(), its.size()) +=
          own.asDiagonal() *
          (conditions_.by_frf()[s].conjugate() * (conditions_.by_frf()[t] * weights.asDiagonal()).transpose()) * its.asDiagonal();
    }
  }
  for (const Block& block : blocks_) gram.noalias() += block.plain.adjoint() * block.right;
  lower_ = std::move(product);
  dense::cholesky_in_place(lower_);
  MatrixXcd half = reduced_;
  dense::solve_lower(lower_, half);
  gram -= half.adjoint() * half;
  solved_ = std::move(half);
  dense::solve_lower_adjoint(lower_, solved_);
  information_ = gram.topLeftCorner(p, p).real();
  gradient_ = gram.topRightCorner(p, 1).real();
  cost_ = std::max(0.0, gram(p, p).real());
}

/// U of one reference times numbers for each FRF of the substructures.
MatrixXcd GroupLinearisation::applied(std::size_t reference, const MatrixXcd& factors) const {
  MatrixXcd out(at(group_.rows), factors.cols());
  for (std::size_t s = 0; s < group_.members.size(); ++s) {
    const GroupMember& member = group_.members[s];
    const Index width = at(member.columns.size());
    for (std::size_t m = 0; m < member.rows.size(); ++m) {
      const Eigen::RowVectorXcd weights =
          (conditions_.by_frf()[s].col(at(reference)).array() * deviation_[s].row(at(m)).transpose().array()).matrix().transpose();
      out.row(at(member.first_row + m)) = weights * factors.middleRows(at(first_[s]) + at(m) * width, width);
    }
  }
  return out;
}

GroupFrfs<Complex> GroupLinearisation::corrected(const VectorXd& step) const {
  Eigen::VectorXcd factors(step.size() + 1);
  factors << step.cast<Complex>(), 1.0;
  const MatrixXcd h = solved_ * factors;
  GroupFrfs<Complex> out = line_.measured;
  for (std::size_t l = 0; l < references_; ++l) {
    const MatrixXcd pull = blocks_[l].right * factors - blocks_[l].inverse * applied(l, h);
    out.motion.col(at(l)) -= line_.variance.motion.col(at(l)).asDiagonal() * (conditions_.by_motion().adjoint() * pull);
  }
  for (std::size_t s = 0; s < group_.members.size(); ++s) {
    const Index rows = at(group_.members[s].rows.size()), columns = at(group_.members[s].columns.size());
    for (Index m = 0; m < rows; ++m) {
      for (Index c = 0; c < columns; ++c) out.parts[s](m, c) -= deviation_[s](m, c) * h(at(first_[s]) + m * columns + c, 0);
    }
  }
  return out;
}

MatrixXcd GroupLinearisation::answer(std::size_t reference) const {
  const Index p = at(group_.unknowns.size());
  const MatrixXcd solved = blocks_[reference].right.leftCols(p) - blocks_[reference].inverse * applied(reference, solved_.leftCols(p));
  return conditions_.by_motion().adjoint() * solved;
}

}  // namespace jointid::ident
