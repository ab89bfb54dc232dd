#pragma once

#include <Eigen/Core>

namespace jointid::response {

/// Throws InputError (data): the receptance at ω (rad/s) is infinite, and why that may be.
[[noreturn]] void infinite_receptance(double omega);

/// The same unless all of H is finite.
void require_finite(const Eigen::MatrixXcd& h, double omega);

}  // namespace jointid::response
