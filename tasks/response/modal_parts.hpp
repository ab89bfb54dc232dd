#pragma once

#include <memory>
#include <string>
#include <vector>

#include "frf/set/frf_system.hpp"
#include "ident/result/control.hpp"
#include "tasks/response/response_scene.hpp"

namespace jointid::tasks {

/// The parts of a scene at other lines than those of `parts`: the modal model of each (modalfit), at those of `lines_hz`
/// (ascending) that lie in the range of every file, with the model's variances. `doubts` gets a phrase for each model that is
/// worse than its data. Throws InputError (data) for a part without a usable model, or no line in the range.
std::unique_ptr<frf::FrfSystem> modal_parts(const ResponseScene& scene, const std::vector<std::unique_ptr<frf::FrfSource>>& parts,
                                            std::vector<double> lines_hz, const ident::Control& control,
                                            std::vector<std::string>& doubts);

}  // namespace jointid::tasks
