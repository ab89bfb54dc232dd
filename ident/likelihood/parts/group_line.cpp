#include "ident/likelihood/parts/group_line.hpp"

#include "base/eigen.hpp"
#include "restrictions/impedance_factor.hpp"

namespace jointid::ident {

using Eigen::Index;
using Eigen::MatrixXcd;

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

}  // namespace jointid::ident
