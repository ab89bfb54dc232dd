#include "response/time/jointed_structure.hpp"

#include <cmath>
#include <string>

#include "base/eigen.hpp"
#include "base/error.hpp"
#include "dense/cholesky.hpp"

namespace jointid::response {
namespace {

[[noreturn]] void refuse(const std::string& place, const std::string& problem, const std::string& remedy) {
  throw InputError({.kind = ErrorKind::data, .file = {}, .place = place, .problem = problem, .remedy = remedy});
}

void check_square(const Eigen::MatrixXd& matrix, const std::string& name, Eigen::Index size) {
  if (matrix.rows() != size || matrix.cols() != size) {
    refuse(name, "is " + std::to_string(matrix.rows()) + " × " + std::to_string(matrix.cols()),
           "give it " + std::to_string(size) + " rows and columns, as the mass matrix has rows");
  }
  if (!matrix.allFinite()) refuse(name, "has a number that is not finite", "give finite numbers");
}

}  // namespace

Eigen::VectorXd JointedStructure::initial_stiffness() const {
  Eigen::VectorXd stiffness(joints());
  for (Eigen::Index j = 0; j < joints(); ++j) stiffness[j] = laws[static_cast<std::size_t>(j)]->response(0.0).tangent;
  return stiffness;
}

void check(const JointedStructure& structure) {
  const Eigen::Index size = structure.coordinates();
  if (size == 0) refuse("mass matrix", "has no rows", "give a structure with at least one coordinate");
  check_square(structure.matrices.mass, "mass matrix", size);
  check_square(structure.matrices.damping, "damping matrix", size);
  check_square(structure.matrices.stiffness, "stiffness matrix", size);
  if (!dense::cholesky(structure.matrices.mass)) {
    refuse("mass matrix", "is not positive definite", "give every coordinate a mass or condense those without");
  }
  if (structure.incidence.rows() != size) {
    refuse("incidence matrix of the joints", "has " + std::to_string(structure.incidence.rows()) + " rows",
           "give one row for each of the " + std::to_string(size) + " coordinates");
  }
  if (!structure.incidence.allFinite())
    refuse("incidence matrix of the joints", "has a number that is not finite", "use +1 and −1");
  if (at(structure.laws.size()) != structure.joints()) {
    refuse("laws of the joints", "are " + std::to_string(structure.laws.size()),
           "give one for each of the " + std::to_string(structure.joints()) + " joints");
  }
}

void check(const JointedStructure& structure, const ForceHistory& force) {
  check(structure);
  if (force.load().rows() != structure.coordinates()) {
    refuse("force", "has " + std::to_string(force.load().rows()) + " rows",
           "give one for each of the " + std::to_string(structure.coordinates()) + " coordinates");
  }
}

void check_step(double delta) {
  if (!(delta > 0.0) || !std::isfinite(delta)) refuse("time step", "is " + std::to_string(delta) + " s", "give one above 0");
}

}  // namespace jointid::response
