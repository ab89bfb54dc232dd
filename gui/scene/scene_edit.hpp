#pragma once

#include <string>
#include <vector>

#include "frf/set/dof.hpp"
#include "frf/uff/uff_lines.hpp"
#include "gui/scene/toml_edit.hpp"
#include "ident/scene/scene.hpp"
#include "study/comparison.hpp"
#include "tasks/joint/joint_layout.hpp"

namespace jointid::gui {

/// Values as they are written: [[560, 566], [700.5, 702]] and ["4:+Y", "5:-RZ"].
std::string written(const std::vector<ident::Range>& ranges);
std::string written(const std::vector<frf::Dof>& dofs);
/// [[1, 2], [2, 5]]
std::string written(const std::vector<frf::NodeLine>& lines);

/// The text with [identify], and the FRFs that modes replace, as the way has it; weighting and Δ stay where the method has neither.
std::string with_way(std::string text, const study::Way& way);

/// The text with the DOFs of [joint], and its stiffness and hysteretic damping, as the layout has them; without hysteretic damping where
/// it has none; the virtual points of a plate replace those of the text. All other keys and comments stay.
std::string with_joint(std::string text, const tasks::JointLayout& layout);

/// The ranges with one more: those that overlap or touch are one, ascending.
std::vector<ident::Range> with_range(std::vector<ident::Range> ranges, const ident::Range& more);

}  // namespace jointid::gui
