#include "response/harmonic/harmonic_line.hpp"

#include "base/error.hpp"

namespace jointid::response {
namespace {

HarmonicLine::One split(const Receptance& structure, const Eigen::MatrixXcd& h, const Eigen::VectorXcd& force) {
  const Eigen::Index j = structure.joints(), r = structure.responses(), p = structure.forces();
  return {h.topLeftCorner(j, j), h.topRightCorner(j, p) * force, h.bottomLeftCorner(r, j), h.bottomRightCorner(r, p) * force};
}

}  // namespace

HarmonicLine harmonic_line(const Receptance& structure, const Harmonics& harmonics, const Excitation& force, double omega,
                           bool with_slopes) {
  HarmonicLine line;
  line.omega = omega;
  for (const int n : harmonics.numbers()) {
    const Eigen::VectorXcd p = force.of(n);
    line.harmonics.push_back(split(structure, structure.at(n * omega), p));
    if (!with_slopes) continue;
    const auto slope = structure.derivative(n * omega);
    if (!slope) {
      throw InputError(
          {.kind = ErrorKind::usage,
           .file = "",
           .place = "[frequency]",
           .problem = "the structure is known at single frequency lines, a curve along frequency needs it between them",
           .remedy = "ask for a sweep over the lines, or give mass, damping and stiffness"});
    }
    line.slopes.push_back(split(structure, static_cast<double>(n) * *slope, p));
  }
  return line;
}

}  // namespace jointid::response
