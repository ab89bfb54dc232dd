#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "frf/set/dof.hpp"

namespace jointid::frf {

/// "2:+Z/1:+Z" of a label with these two DOFs and the name of an FRF around them, "FRF 2:+Z/1:+Z" or "H1(2:+Z,1:+Z)"; empty where there
/// are not two, or it does not say in words or by order which is the response.
std::string dofs_in(std::string_view label);

/// Whether a label has a DOF, "12:+X", or what a slip of the pen makes of one, "12:x".
bool says_direction(std::string_view label);

/// Response and reference, counted from 0, of FRFs whose labels number them: "H21", "H_2_1", "FRF(2,1)" is response 2 over
/// reference 1. Numbers are those of the nodes, or count the DOFs that are given. In the order of the labels; all of them empty
/// where both readings fit and differ, or neither does and the labels are not in the order of the DOFs, response by response.
/// Nothing where a label has no two numbers, or there is one label.
std::vector<std::optional<std::pair<std::size_t, std::size_t>>> places_of_labels(const std::vector<std::string>& labels,
                                                                                 const std::vector<Dof>& response,
                                                                                 const std::vector<Dof>& reference);

}  // namespace jointid::frf
