#pragma once

#include "ident/result/control.hpp"
#include "ident/result/suspect.hpp"
#include "impedance/scene/line_scene.hpp"

namespace jointid::impedance {

/// ident::check_scene(). If it finds nothing, Z is fitted at 64 lines at most, evenly spread: what no Z of the scene's structure explains
/// is a suspect, and what nothing can contradict is a note. Throws InputError as ident::check_scene() does.
ident::CheckResult check_lines(const LineScene& scene, const ident::Control& control = {});

}  // namespace jointid::impedance
