#pragma once

#include <functional>
#include <span>

namespace jointid::friction {

/// ∫ f over [ends.front(), ends.back()], piece by piece; f is smooth inside the pieces and finite, with at most an
/// algebraic singularity of a derivative at their ends. Relative error about 1e-14 by the tanh-sinh rule.
double integrate(const std::function<double(double)>& f, std::span<const double> ends);

/// The same for f that is analytic up to the ends of the pieces: 30 points of Gauss in each.
double integrate_smooth(const std::function<double(double)>& f, std::span<const double> ends);

}  // namespace jointid::friction
