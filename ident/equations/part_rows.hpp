#pragma once

#include <memory>
#include <vector>

#include "ident/equations/equation_builder.hpp"
#include "ident/equations/line_assembler.hpp"
#include "restrictions/restriction.hpp"

namespace jointid::ident {

/// The balance of one substructure s alone, for its coordinates m and the assembly's references l:
///   H_sub(m,l) − H_asm(m,l) = H_sub(m,J_s) Z_j(J_s,:) H_asm(:,l),   H_sub(m,l) = 0 for l on another substructure,
/// J_s the joint coordinates on s. Z_j(J_s,:) has elements at the coordinates of the joints on s alone, so a row touches their unknowns and
/// no others, and of the assembly it takes motion at the joints, not forces there. By reciprocity it is Method One's row for (l,m).
struct PartOfRows {
  std::size_t source = 0;      ///< of the substructures
  Dofs n_rows, j_rows;         ///< m: not at joints and at joints
  Support support;             ///< a_dofs = J_s, b_dofs the coordinates of the joints on s
};

/// The substructures that have joints, and what they touch.
std::vector<PartOfRows> parts_of_rows(const Coordinates& coordinates, const EquationSet& equations,
                                      const restrictions::Restriction& restriction, const frf::FrfSystem& substructures);

/// Their equations: a product for each part, whose A and B have the columns and rows of its support alone.
std::unique_ptr<EquationBuilder> make_part_rows(std::vector<PartOfRows> parts, const Coordinates& coordinates, const EquationSet& equations,
                                                frf::FrfSystem& substructures, frf::FrfSystem& assembly);

/// How the lines of the parts become rows, one for each.
std::vector<AssemblySpec> part_specs(const std::vector<PartOfRows>& parts, const AssemblySpec& whole, std::size_t columns);

/// The references of the assembly that rows by parts take: those that are no joint coordinates, then those that are.
Dofs part_columns(const Coordinates& coordinates, const EquationSet& equations, const frf::FrfSystem& assembly);

}  // namespace jointid::ident
