#pragma once

#include <vector>

#include "problems/case/case.hpp"

namespace jointid::problems {

// The identification cases by thesis section; docs/problems.md tells what each shows and what was chosen
// where the print leaves a gap or cannot be right.
std::vector<Case> cases_of_basic_study();        ///< §6.6: A1–A11
std::vector<Case> cases_of_refined_weighting();  ///< §6.7: B
std::vector<Case> cases_of_accuracy();           ///< §6.8: C1–F3
std::vector<Case> cases_of_hard_joints();        ///< §6.9: G1–G5
std::vector<Case> cases_of_other_data();         ///< §6.10 and §6.12: H1–H4
std::vector<Case> cases_of_rig_one();            ///< §7.2: rig1 and rig1-accelerometer
std::vector<Case> cases_of_bolts();               ///< not of the thesis: bolts, bolts-5

/// All of them in the order of the thesis.
std::vector<Case> all_cases();

}  // namespace jointid::problems
