#pragma once

#include <string>

#include "report/text/display.hpp"
#include "tasks/couple/couple_frfs.hpp"

namespace jointid::report {

/// The page of a coupling: the conditions and which were left out and why, S and the threshold over the lines, the predicted FRFs
/// with their uncertainty and bounds. `predicted`: those that it draws, tasks::read_predicted(); none where no line was coupled.
std::string couple_page(const ident::CoupleScene& scene, const tasks::CoupleResult& result,
                        const std::vector<tasks::PredictedFrf>& predicted, const Display& display = {});

}  // namespace jointid::report
