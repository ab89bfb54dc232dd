#pragma once

#include "coupling/condition.hpp"

namespace jointid::coupling {

// A joint of dynamic stiffness Z (N/m) between coordinates of a structure whose FRFs there are H (m/N), both [n,n]: the structure with
// the joint moves by (I + H Z)⁻¹ of what it moves without, and the joint answers with (I + Z H)⁻¹ of the force Z x that it would
// without the structure giving way. Where the matrix is singular results are not finite.

/// I + H Z.
ComplexMatrix joint_loop(const MatrixRef& h, const MatrixRef& z);

/// (I + H Z)⁻¹.
ComplexMatrix closed_loop(const MatrixRef& h, const MatrixRef& z);

/// (I + H Z)⁻¹ X, X [n,any].
ComplexMatrix motion_with_joint(const MatrixRef& h, const MatrixRef& z, const MatrixRef& x);

/// (I + Z H)⁻¹ F, F [n,any].
ComplexMatrix force_with_joint(const MatrixRef& z, const MatrixRef& h, const MatrixRef& f);

/// X (I + Z H)⁻¹, X [any,n]: FRFs to responses from the joint's coordinates.
ComplexMatrix motion_from_joint(const MatrixRef& x, const MatrixRef& z, const MatrixRef& h);

}  // namespace jointid::coupling
