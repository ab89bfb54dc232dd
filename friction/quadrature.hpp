#pragma once

#include <functional>
#include <span>

namespace jointid::friction {

/// ∫ f over [ends.front(), ends.back()], piece by piece; f is smooth inside the pieces, with at most an algebraic singularity
/// at their ends, where it is not evaluated. Relative error about 1e-14 by the tanh-sinh rule.
double integrate(const std::function<double(double)>& f, std::span<const double> ends);

}  // namespace jointid::friction
