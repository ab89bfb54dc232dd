#pragma once

#include "friction/joint/fe_joint.hpp"
#include "friction/law/menq_bar.hpp"

/// The numerical case studies of thesis §2.16.2 (docs/formulas.md §10e).
namespace jointid::friction {

/// Case One: a uniform bar on a bilinear interface, for which Menq's formula is the exact answer. The text of the thesis gives no
/// numbers; these are a steel bar of 10 mm × 10 mm (2.06e11 N/m²), 1 m long, with k = 2e12 N/m/m² and slip at 5e-8·(e³−1)/3 m,
/// the values of case Three.
MenqBar::Values case_one();

/// The finite-element model of such a bar.
JointMesh menq_mesh(const MenqBar::Values& bar, std::size_t members);

/// Case Two: the bar of table 2.8, 20 members and 21 Ren elements.
JointMesh case_two();

/// Case Three: the bar of case One with this length (1 m: A, 0.1 m: B) on one of three laws with the same limit.
enum class CaseThreeLaw {
  ren,             ///< a = 5e-8 m, b = 3, k = 2e12 N/m/m²
  same_stiffness,  ///< bilinear with the stiffness of ren
  same_macroslip   ///< bilinear that slips where ren does, at ae^b
};
JointMesh case_three(CaseThreeLaw law, double length, std::size_t members);

}  // namespace jointid::friction
