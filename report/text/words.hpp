#pragma once

#include <string>
#include <vector>

#include "ident/result/solution.hpp"

namespace jointid::report {

/// A key as one reads it: "viscous_damping" is "viscous damping".
std::string words(std::string key);

/// "nn nj"; "all" for none, which stands for all that the data allow.
std::string equations_text(const std::vector<ident::Equation>& equations);

/// "812.4 / 806 = 1.008": the quotient is near 1 when joint model and variances are right.
std::string chi_square_text(const ident::ChiSquare& chi_square);

/// What there is to say of an unknown beside its numbers: "not determined by the data", an active constraint, or "error as large as the
/// value" where it has no valid digit; else empty.
std::string remark_on(const ident::Estimate& unknown);

/// "9.4, of which the noise leaves 0.9": of the worst unknown, relative to the largest of its unit; "9.4" where no error is estimated.
std::string rounding_digits(const ident::Solution& solution);

/// "125:+Y, 126:+Y".
std::string dofs_text(const ident::Suspect& suspect);

/// "WB" and "0.1", or "–" where the method has none.
std::string weighting_text(ident::Method method, weighting::Weighting weighting);
std::string delta_text(ident::Method method, double delta);

/// "one, equations nn nj, weighting WB, delta 0, solver qr"; without what the method does not have.
std::string method_text(ident::Method method, const std::vector<ident::Equation>& equations, weighting::Weighting weighting,
                        double delta, const std::string& solver);

/// A paragraph with a line for each phrase below its title; nothing of no phrases.
std::string phrases(const char* title, const std::vector<std::string>& list);

}  // namespace jointid::report
