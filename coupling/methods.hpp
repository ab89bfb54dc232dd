#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "coupling/condition.hpp"

namespace jointid::coupling {

/// Methods of coupling (docs/formulas.md §8, thesis chapter 5). Without rounding they give the same FRFs, also for noisy H.
enum class Method {
  gic,  ///< general impedance coupling: invert H, add, invert back (§5.4)
  rc,   ///< receptance coupling: two structures at a time (§5.5)
  grc,  ///< generalised receptance coupling, LM-FBS: pairs in one step, lists of more in several (§5.6.1)
  pcc,  ///< pseudo coordinate coupling: everything in one step (§5.6.3)
  mtc   ///< multi-step two-coordinate coupling (§5.6.4)
};

std::string name(Method method);

/// Parses "gic", "rc", "grc", "pcc" or "mtc"; throws InputError (usage) with the nearest valid word.
Method parse_method(std::string_view text);

// Each returns H_asm at the wanted rows and columns of H. Coupled coordinates have equal rows, grounded ones zeros. If a matrix
// to invert is singular, the result is not finite.

/// (Tᵀ H⁻¹ T)⁻¹, x = T x_asm (5.9, 5.10). H must be square, fully measured and not singular, with the same coordinates among rows
/// and columns.
ComplexMatrix gic(const MatrixRef& h, const Conditions& conditions, const Wanted& wanted);

/// Two structures at a time (5.20): the first `body` with the next that a condition connects to it, and so on. row_body and
/// column_body name the structure of each row and column. It uses no FRF across structures. rc_lacks() must be empty.
ComplexMatrix rc(const MatrixRef& h, const Conditions& conditions, const Wanted& wanted, const std::vector<std::size_t>& row_body,
                 const std::vector<std::size_t>& column_body);

/// Index of the first condition outside receptance coupling: ground, or two coordinates of one structure.
std::optional<std::size_t> rc_lacks(const Conditions& conditions, const std::vector<std::size_t>& body);

/// H − X S⁻¹ Y (5.36a), X = H Bᵀ, Y = B H, S = B H Bᵀ. Coordinates with several conditions are coupled in several steps.
ComplexMatrix grc(const MatrixRef& h, const Conditions& conditions, const Wanted& wanted);

/// The same in one step, with a row and column of S for every compatibility condition.
ComplexMatrix pcc(const MatrixRef& h, const Conditions& conditions, const Wanted& wanted);

/// Steps of the multi-step two-coordinate coupling.
struct MtcResult {
  ComplexMatrix frf;
  std::vector<double> alpha;  ///< of each condition before it is coupled, see alpha()
  std::vector<bool> coupled;  ///< false: left out, as its alpha is not above the threshold (5.72)
};

/// One compatibility condition after the other (5.44), without those of alpha ≤ epsilon.
MtcResult mtc(const MatrixRef& h, const Conditions& conditions, const Wanted& wanted, double epsilon = -1.0);

/// Dependency of two coordinates (5.70): (|h_ii − h_jj| + |h_ii − h_ij| + |h_ij − h_jj|) / (|h_ii| + |h_jj| + |h_ij|). It is 0
/// for two coordinates that move alike, 2 for ground, 0 if all three vanish.
double alpha(Complex ii, Complex jj, Complex ij);

/// H with a joint of known dynamic stiffness Z (N/m) between coordinates: H − H_:j (I + Z H_jj)⁻¹ Z H_j: (6.12).
ComplexMatrix with_joint(const MatrixRef& h, const std::vector<Index>& at, const MatrixRef& z);

}  // namespace jointid::coupling
