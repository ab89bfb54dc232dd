#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace jointid::ident {

/// −½ of the gradient of χ² at the estimate plus an offset.
using GradientAt = std::function<Eigen::VectorXd(const Eigen::VectorXd& offset)>;

/// The same for several offsets, which may share work.
using GradientsAt = std::function<std::vector<Eigen::VectorXd>(const std::vector<Eigen::VectorXd>& offsets)>;

GradientsAt one_by_one(GradientAt gradient);

/// G = J I⁻¹ J, whose inverse is the covariance of the estimates where noise is large beside the FRFs (Godambe 1960). J is the
/// curvature of ½χ² at the estimate, by central differences of its gradient: what the data say of the unknowns. The information I
/// counts the noise in the fitted FRFs as signal: as such it promises too much, but it is the variance of the gradient, which has
/// that noise. G is the information itself where three directions show no difference above 2 % between J and I, which costs six
/// gradients instead of two per unknown, and where the differences tell no curvature (eigenvalues of J beyond a tenth and three
/// times those of I). `quick`, where it is given, is a gradient that is right to first order in what J and I differ by: where one-sided
/// differences of it show none above 0.5 % the others are not asked for, and the three directions are judged by it.
Eigen::MatrixXd godambe_information(const GradientsAt& gradients, const Eigen::MatrixXd& information, const GradientAt& quick = {});

/// The offsets of the first gradients that are asked for without `quick`; none: the information is taken as it is.
std::vector<Eigen::VectorXd> first_offsets(const Eigen::MatrixXd& information);

}  // namespace jointid::ident
