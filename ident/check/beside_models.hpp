#pragma once

#include "ident/result/control.hpp"
#include "ident/result/suspect.hpp"
#include "ident/scene/scene.hpp"

namespace jointid::ident {

/// Files of the scene for which a model of the same structure is given (DataFile::model), held against it channel by channel
/// (correlation::beside_model()): signs, labels, directions, gains and units that the model contradicts, whatever its resonances are off
/// by. How well each file agrees is a note. Throws InputError as frf::open() and models::open_model().
void check_beside_models(const Scene& scene, const Control& control, CheckResult& result);

}  // namespace jointid::ident
