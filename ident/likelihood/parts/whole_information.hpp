#pragma once

#include <Eigen/Core>

#include "ident/likelihood/parts/group_line.hpp"

namespace jointid::ident {

/// Fisher's information 2 Re AᴴM⁻¹A of all conditions of a group at one line, at the FRFs nearest to the measured ones that meet them
/// there. Each FRF has an error and a true value of its own; those of a reciprocal pair are two. M, of all conditions under all
/// references, is sparse: conditions share motions where parts are joined, and FRFs of substructures where references act. For a group of
/// all substructures, of which GroupLinearisation would form products of all FRFs with each other. [unknowns, unknowns]
Eigen::MatrixXd whole_information(const PartGroup& group, const PartGroups& all, GroupLine line, const GroupImpedance& impedance);

}  // namespace jointid::ident
