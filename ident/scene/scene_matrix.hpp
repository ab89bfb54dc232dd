#pragma once

#include "ident/scene/scene.hpp"
#include "scene/reader.hpp"

namespace jointid::ident {

/// A matrix of a joint, e.g. [joint.stiffness]: one of `pattern`, `matrix` and `springs`. `joint` has the DOFs and
/// positions by now; the matrix is checked against them.
restrictions::MatrixSpec read_matrix_spec(const scene::Item& item, restrictions::Kind kind,
                                          const restrictions::JointSpec& joint);

/// Its key `definite`: whether it is required to be positive semidefinite.
bool read_definite(const scene::Item& item);

}  // namespace jointid::ident
