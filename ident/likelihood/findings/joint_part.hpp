#pragma once

#include "ident/likelihood/fit/estimator.hpp"

namespace jointid::ident {

/// What a fit says of the first `joint` unknowns: its information is that which is left once the others, systematic errors, are
/// eliminated. The fit itself where there are no others.
LikelihoodFit joint_part(LikelihoodFit fit, std::size_t joint);

/// The information that is left for the first `joint` unknowns.
Eigen::MatrixXd joint_information(const Eigen::MatrixXd& information, std::size_t joint);

}  // namespace jointid::ident
