#include "restrictions/impedance_factor.hpp"

namespace jointid::restrictions {

Complex impedance_factor(Kind kind, double omega) {
  switch (kind) {
    case Kind::mass:
      return -omega * omega;
    case Kind::viscous_damping:
      return {0.0, omega};
    case Kind::hysteretic_damping:
      return {0.0, 1.0};
    case Kind::stiffness:
      break;
  }
  return 1.0;
}

double unscale(Kind kind, double omega0) {
  switch (kind) {
    case Kind::mass:
      return 1.0 / (omega0 * omega0);
    case Kind::viscous_damping:
      return 1.0 / omega0;
    case Kind::stiffness:
    case Kind::hysteretic_damping:
      break;
  }
  return 1.0;
}

void add_impedance(Kind kind, const Eigen::Ref<const Eigen::MatrixXd>& matrix, double omega, Eigen::MatrixXcd& z) {
  z += impedance_factor(kind, omega) * matrix.cast<Complex>();
}

}  // namespace jointid::restrictions
