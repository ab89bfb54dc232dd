#pragma once

#include "ident/equations/line_assembler.hpp"

namespace jointid::ident {

/// Supports of the equations: one over all unknowns, or, where the substructures are uncoupled and it is cheaper by counted
/// flops, one per substructure. A column of B whose coordinate is on one substructure has zeros at the joint DOFs of all
/// others (docs/formulas.md §1), so it touches only the unknowns that have a term in the columns of Z_j on that substructure.
/// `column_source` tells the substructure of each column of B, or is empty where B has no such zeros (Method Two).
void choose_supports(const restrictions::Restriction& restriction, const std::vector<std::size_t>& joint_source,
                     const std::vector<std::size_t>& column_source, std::size_t columns, AssemblySpec& spec);

/// Real rows per line and flops of reducing them, for given supports.
std::size_t compressed_rows(const AssemblySpec& spec, std::size_t a_rows);
double reduction_flops(const AssemblySpec& spec, std::size_t a_rows);

}  // namespace jointid::ident
