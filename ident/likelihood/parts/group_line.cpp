#include "ident/likelihood/parts/group_line.hpp"

#include <algorithm>
#include <cmath>

#include "base/eigen.hpp"
#include "dense/blas.hpp"
#include "restrictions/impedance_factor.hpp"

namespace jointid::ident {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

GroupImpedance group_impedance(const PartGroup& group, const std::vector<double>& theta, double omega, double omega0) {
  GroupImpedance out;
  const Index q = at(group.motions.size());
  out.z = MatrixXcd::Zero(q, q);
  for (const restrictions::MatrixTerms& matrix : group.matrices) {
    const Complex factor = restrictions::impedance_factor(matrix.kind, omega);
    const Complex scaled = factor * restrictions::unscale(matrix.kind, omega0);
    for (const restrictions::Term& term : matrix.terms) {
      out.terms.push_back({term.row, term.column, term.unknown, scaled * term.coefficient});
      out.z(at(term.row), at(term.column)) += out.terms.back().factor * theta[term.unknown];
    }
    for (const restrictions::Known& known : matrix.known) out.z(at(known.row), at(known.column)) += factor * known.value;
  }
  return out;
}

GroupLinearisation::GroupLinearisation(const PartGroup& group, const PartGroups& all, const GroupLine& line,
                                       const GroupImpedance& impedance)
    : group_(group), line_(line), z_(impedance), references_(all.references.size()) {
  form_forces();
  form_blocks();
  eliminate();
}

void GroupLinearisation::form_forces() {
  const Index q = at(group_.motions.size());
  motion_of_row_ = MatrixXcd::Zero(at(group_.rows), q);
  force_places_.resize(group_.motions.size());
  std::size_t first = 0;
  for (std::size_t s = 0; s < group_.members.size(); ++s) {
    const GroupMember& member = group_.members[s];
    const MatrixXcd& h = line_.current.parts[s];
    const Index joints = at(member.forces.size());
    MatrixXcd z(joints, q);
    for (Index a = 0; a < joints; ++a) z.row(a) = z_.z.row(at(member.forces[std::size_t(a)]));
    auto own = motion_of_row_.middleRows(at(member.first_row), at(member.rows.size()));
    own = h.leftCols(joints) * z;
    for (std::size_t m = 0; m < member.rows.size(); ++m) own(at(m), at(member.motions[m])) += 1.0;
    MatrixXcd force = MatrixXcd::Zero(at(member.columns.size()), at(references_));
    force.topRows(joints) = z * line_.current.motion;
    for (const auto& [l, column] : member.references) force(at(column), at(l)) -= 1.0;
    force_.push_back(std::move(force));
    deviation_.push_back(line_.variance.parts[s].cwiseSqrt());
    first_.push_back(first);
    first += member.rows.size() * member.columns.size();
    member_of_row_.resize(member_of_row_.size() + member.rows.size(), s);
    for (std::size_t a = 0; a < member.forces.size(); ++a) force_places_[member.forces[a]] = {s, at(a)};
  }
}

MatrixXcd GroupLinearisation::derivative(std::size_t reference) const {
  MatrixXcd a = MatrixXcd::Zero(at(group_.rows), at(group_.unknowns.size()));
  for (const GroupImpedance::Term& term : z_.terms) {
    const auto& [s, force] = force_places_[term.row];
    const GroupMember& member = group_.members[s];
    a.block(at(member.first_row), at(term.unknown), at(member.rows.size()), 1) +=
        term.factor * line_.current.motion(at(term.column), at(reference)) * line_.current.parts[s].col(force);
  }
  return a;
}

void GroupLinearisation::form_blocks() {
  const Index n = at(group_.rows), p = at(group_.unknowns.size());
  MatrixXcd w(n, at(references_));
  for (std::size_t s = 0; s < group_.members.size(); ++s) {
    const GroupMember& member = group_.members[s];
    auto own = w.middleRows(at(member.first_row), at(member.rows.size()));
    own = line_.measured.parts[s] * force_[s];  // c + (measured − current) of H
    for (std::size_t m = 0; m < member.rows.size(); ++m) own.row(at(m)) += line_.current.motion.row(at(member.motions[m]));
  }
  w += motion_of_row_ * (line_.measured.motion - line_.current.motion);
  for (std::size_t l = 0; l < references_; ++l) {
    std::vector<Index> rows;
    for (Index m = 0; m < n; ++m) {
      if (line_.active(m, at(l))) rows.push_back(m);
    }
    Block block{MatrixXcd::Zero(n, n), MatrixXcd::Zero(n, p + 1), MatrixXcd::Zero(n, p + 1)};
    if (!rows.empty()) {
      const MatrixXcd g = motion_of_row_(rows, Eigen::all) * line_.variance.motion.col(at(l)).cwiseSqrt().asDiagonal();
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
      block.plain << derivative(l), w.col(at(l));
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
    reduced_.middleRows(first, own.size()) = own.asDiagonal() * (force_[s].conjugate() * right);
    for (Index other = 0; other <= m; ++other) {
      const auto [t, begin] = place(other);
      for (Index l = 0; l < references; ++l) weights[l] = blocks_[std::size_t(l)].inverse(m, other);
      const VectorXd its = deviations(other);
      product.block(first, begin, own.size(), its.size()) +=
          own.asDiagonal() * (force_[s].conjugate() * (force_[t] * weights.asDiagonal()).transpose()) * its.asDiagonal();
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
          (force_[s].col(at(reference)).array() * deviation_[s].row(at(m)).transpose().array()).matrix().transpose();
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
    out.motion.col(at(l)) -= line_.variance.motion.col(at(l)).asDiagonal() * (motion_of_row_.adjoint() * pull);
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
  return motion_of_row_.adjoint() * solved;
}

}  // namespace jointid::ident
