#pragma once

#include <memory>

#include "study/measurements.hpp"

namespace jointid::study {

/// Opens the scene's files, loads what the plan needs once, and takes the noise of [noise] (without that section: of a hammer
/// test when all files carry coherences). Throws InputError as make_plan() does, and for a noise that the data do not allow.
std::shared_ptr<const TrialData> load_trial_data(const ident::Scene& scene);

/// The same from sets in memory, as the scene's [data] lists them; its files are not opened.
std::shared_ptr<const TrialData> make_trial_data(const ident::Scene& scene, const Measurements& base);

/// The same from sets in memory, with errors of any kind.
std::shared_ptr<const TrialData> make_trial_data(const ident::Scene& scene, const Measurements& base, Pollution pollution);

/// The same from sets in memory with a noise model.
std::shared_ptr<const TrialData> make_trial_data(const ident::Scene& scene, const Measurements& base, const frf::NoiseModel& noise);

}  // namespace jointid::study
