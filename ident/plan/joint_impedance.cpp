#include "ident/plan/joint_impedance.hpp"


#include "base/complex.hpp"
#include "base/eigen.hpp"
#include "ident/plan/scaling.hpp"

namespace jointid::ident {
namespace {

/// Without the look at whether an infinite factor made the product no number.
Complex times(const Complex& a, const Complex& b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

}  // namespace

JointImpedance::JointImpedance(const restrictions::Restriction& restriction, const UnknownColumns& columns, double omega0,
                               double omega)
    : columns_(columns.at(hertz(omega))) {
  const auto n = jointid::at(restriction.dofs.size());
  known_ = ComplexMatrix::Zero(n, n);
  for (const restrictions::MatrixTerms& matrix : restriction.matrices) {
    for (const restrictions::Known& known : matrix.known) {
      known_(jointid::at(known.row), jointid::at(known.column)) +=
          impedance_factor(matrix.kind, omega) * known.value;
    }
  }
  for (const std::size_t column : columns_) {
    const std::size_t unknown = columns.unknown_of(column);
    const restrictions::Kind kind = restriction.unknowns[unknown].kind;
    Part part{impedance_factor(kind, omega) * unscale(kind, omega0), terms_.size(), 0};
    for (const restrictions::MatrixTerms& matrix : restriction.matrices) {
      if (matrix.kind != kind) continue;
      for (const restrictions::Term& term : matrix.terms) {
        if (term.unknown == unknown) terms_.push_back({term.row, term.column, term.coefficient});
      }
    }
    part.last_term = terms_.size();
    parts_.push_back(part);
  }
}

ComplexMatrix JointImpedance::at(std::span<const double> theta) const {
  ComplexMatrix z = known_;
  for (std::size_t t = 0; t < parts_.size(); ++t) {
    const Complex factor = parts_[t].factor * theta[columns_[t]];
    for (std::size_t i = parts_[t].first_term; i < parts_[t].last_term; ++i) {
      z(jointid::at(terms_[i].row), jointid::at(terms_[i].column)) +=
          factor * terms_[i].coefficient;
    }
  }
  return z;
}

void JointImpedance::sensitivity(const Complex* left, const Complex* right, Complex* out) const {
  for (std::size_t t = 0; t < parts_.size(); ++t) {
    Complex sum = 0.0;
    for (std::size_t i = parts_[t].first_term; i < parts_[t].last_term; ++i) {
      sum += times(terms_[i].coefficient * left[terms_[i].row], right[terms_[i].column]);
    }
    out[t] = times(parts_[t].factor, sum);
  }
}

Eigen::VectorXd JointImpedance::along(const ComplexMatrix& q) const {
  Eigen::VectorXd out(jointid::at(parts_.size()));
  for (std::size_t t = 0; t < parts_.size(); ++t) {
    Complex sum = 0.0;
    for (std::size_t i = parts_[t].first_term; i < parts_[t].last_term; ++i) {
      sum += terms_[i].coefficient * q(jointid::at(terms_[i].row), jointid::at(terms_[i].column));
    }
    out[jointid::at(t)] = (std::conj(parts_[t].factor) * sum).real();
  }
  return out;
}

}  // namespace jointid::ident
