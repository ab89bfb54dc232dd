#pragma once

#include <Eigen/Core>
#include <functional>

namespace jointid::ident {

/// −½ of the gradient of χ² at the estimate plus an offset.
using GradientAt = std::function<Eigen::VectorXd(const Eigen::VectorXd& offset)>;

/// The curvature of ½χ² at the estimate by central differences of its gradient: what the data say of the unknowns where noise is
/// large beside the FRFs, and the information, which counts the noise in the fitted FRFs as signal, promises too much (Efron and
/// Hinkley 1978). It is the information itself where three directions show no difference above 2 %, which costs six gradients instead
/// of two per unknown, and where the differences tell no curvature (eigenvalues beyond a tenth and three times the information's).
Eigen::MatrixXd observed_information(const GradientAt& gradient, const Eigen::MatrixXd& information);

}  // namespace jointid::ident
