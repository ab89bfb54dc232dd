#pragma once

#include "problems/thesis/thesis_table.hpp"

/// Tables of chapter 7 on replicas of rig one: their numbers in N/m, as they are printed.
namespace jointid::problems {

/// Joint A, nearly rigid, from three data sets: they agree with each other and are all far from the truth.
ThesisTable table_7_2();
/// Joint B from three data sets.
ThesisTable table_7_3();
/// Joint B, eight unknowns from H_nn alone.
ThesisTable table_7_5();

}  // namespace jointid::problems
