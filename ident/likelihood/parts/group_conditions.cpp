#include "ident/likelihood/parts/group_conditions.hpp"

#include "base/eigen.hpp"

namespace jointid::ident {

using Eigen::Index;
using Eigen::MatrixXcd;

GroupConditions::GroupConditions(const PartGroup& group, std::size_t references, const GroupLine& line, const GroupImpedance& impedance)
    : group_(group), line_(line), z_(impedance), force_places_(group.motions.size()) {
  const Index q = at(group.motions.size());
  by_motion_ = MatrixXcd::Zero(at(group.rows), q);
  for (std::size_t s = 0; s < group.members.size(); ++s) {
    const GroupMember& member = group.members[s];
    const Index joints = at(member.forces.size());
    MatrixXcd z(joints, q);
    for (Index a = 0; a < joints; ++a) z.row(a) = z_.z.row(at(member.forces[std::size_t(a)]));
    auto own = by_motion_.middleRows(at(member.first_row), at(member.rows.size()));
    own = line.current.parts[s].leftCols(joints) * z;
    for (std::size_t m = 0; m < member.rows.size(); ++m) own(at(m), at(member.motions[m])) += 1.0;
    MatrixXcd force = MatrixXcd::Zero(at(member.columns.size()), at(references));
    force.topRows(joints) = z * line.current.motion;
    for (const auto& [l, column] : member.references) force(at(column), at(l)) -= 1.0;
    by_frf_.push_back(std::move(force));
    for (std::size_t a = 0; a < member.forces.size(); ++a) force_places_[member.forces[a]] = {s, at(a)};
  }
}

MatrixXcd GroupConditions::by_unknown(std::size_t reference) const {
  MatrixXcd a = MatrixXcd::Zero(at(group_.rows), at(group_.unknowns.size()));
  for (const GroupImpedance::Term& term : z_.terms) {
    const auto& [s, force] = force_places_[term.row];
    const GroupMember& member = group_.members[s];
    a.block(at(member.first_row), at(term.unknown), at(member.rows.size()), 1) +=
        term.factor * line_.current.motion(at(term.column), at(reference)) * line_.current.parts[s].col(force);
  }
  return a;
}

MatrixXcd GroupConditions::misfit() const {
  MatrixXcd w(at(group_.rows), line_.measured.motion.cols());
  for (std::size_t s = 0; s < group_.members.size(); ++s) {
    const GroupMember& member = group_.members[s];
    auto own = w.middleRows(at(member.first_row), at(member.rows.size()));
    own = line_.measured.parts[s] * by_frf_[s];  // c + (measured − current) of H
    for (std::size_t m = 0; m < member.rows.size(); ++m) own.row(at(m)) += line_.current.motion.row(at(member.motions[m]));
  }
  w += by_motion_ * (line_.measured.motion - line_.current.motion);
  return w;
}

}  // namespace jointid::ident
