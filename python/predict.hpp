#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "python/outcome.hpp"
#include "python/scene_text.hpp"

namespace jointid::python {

/// `jointid couple`. `out`: where the assembly's FRFs are written, jointid-frf HDF5; empty: they stay in memory. Throws
/// InputError and Interrupted, as all of these do.
Outcome couple(const SceneText& scene, const std::filesystem::path& out, bool bounds, const ident::Control& control);

/// `jointid equivalent`, of scenes of friction laws too.
Outcome equivalent(const SceneText& scene, const ident::Control& control);

/// `jointid response`
Outcome response_of(const SceneText& scene, const ident::Control& control);

/// `jointid response --compare`
Outcome response_ways(const SceneText& scene, const ident::Control& control);

/// `jointid oscillate`
Outcome oscillate(const SceneText& scene, const ident::Control& control, SoFar& so_far);

/// FRFs of files (as one structure) whose sensors and impacts at interfaces are replaced by virtual points: those of the
/// [[virtual_points]] of `text`, a scene without other tables but [nodes].
frf::FrfSet at_virtual_points(const SceneText& text, const std::filesystem::path& file);

}  // namespace jointid::python
