#include "ident/judgement/line_joint.hpp"

#include "base/eigen.hpp"
#include "ident/plan/scaling.hpp"

namespace jointid::ident {

Eigen::MatrixXcd LineJoint::at(const std::vector<double>& theta) const {
  Eigen::MatrixXcd z = known;
  for (std::size_t u = 0; u < unknowns.size(); ++u) {
    for (const auto& [row, column, factor] : unknowns[u]) z(row, column) += theta[columns[u]] * factor;
  }
  return z;
}

LineJoint joint_at(const Plan& plan, double frequency_hz) {
  const restrictions::Restriction& restriction = plan.restriction;
  const double omega = angular(frequency_hz);
  const auto n = at(restriction.dofs.size());
  LineJoint out{plan.columns->at(frequency_hz), std::vector<std::vector<LineJoint::Place>>(restriction.unknowns.size()),
                Eigen::MatrixXcd::Zero(n, n)};
  for (const restrictions::MatrixTerms& matrix : restriction.matrices) {
    const Complex si = impedance_factor(matrix.kind, omega), scaled = si * unscale(matrix.kind, plan.omega0);
    for (const auto& [row, column, unknown, coefficient] : matrix.terms) {
      out.unknowns[unknown].push_back({at(row), at(column), scaled * coefficient});
    }
    for (const auto& [row, column, value] : matrix.known) out.known(at(row), at(column)) += si * value;
  }
  return out;
}

}  // namespace jointid::ident
