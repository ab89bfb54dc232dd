#pragma once

#include <optional>
#include <vector>

#include "ident/likelihood/errors/tried_errors.hpp"
#include "ident/result/suspect.hpp"

namespace jointid::ident {

/// What a fit says against its data beside χ²: noise of the force where the bias of H1 that it allows, in its file or in all,
/// moves an unknown by a standard deviation or more; a common gain of a file (`without`: the one that was taken off), or a
/// stretch of frequencies, 4.5 standard deviations off; the gain of a sensor, 5; blocks of lines that disagree. None of them
/// where responses to a hit share errors but that, and a gain of three times as much. `covariance`: of the joint's scaled
/// unknowns; `theta`: unknowns of the fit, those of the joint first.
std::vector<Suspect> fit_suspects(const TriedErrors& tried, const std::optional<FileGain>& without,
                                  const Eigen::MatrixXd& covariance, const std::vector<double>& theta);

}  // namespace jointid::ident
