#pragma once

#include <Eigen/Core>
#include <optional>

#include "ident/plan/plan.hpp"
#include "ident/result/control.hpp"

namespace jointid::ident {

/// The covariance of a linear estimate (scaled unknowns) by its scatter when one of up to twelve groups of lines after the other is left
/// out (delete-a-group jackknife): (G−1)/G Σ_g (y_g − ȳ)(y_g − ȳ)ᵀ. Groups are neighbouring lines, so that errors which neighbours
/// share count as one; every twelfth line where a joint has bands. At most `most_lines` lines spread over all are taken, and the scatter is
/// scaled to all of them. It has no part of the bias, which all groups share. Empty with fewer than four lines, and where a group
/// cannot be left out without the rank becoming less.
std::optional<Eigen::MatrixXd> line_jackknife(Plan& plan, std::size_t most_lines, const Control& control);

}  // namespace jointid::ident
