#pragma once

#include <cstddef>
#include <vector>

#include "ident/equations/equation_builder.hpp"

namespace jointid::ident {

/// Place of an FRF in its block.
struct Element {
  std::size_t row = 0, column = 0;
};

/// What the likelihood takes from every line, the same for all lines. With `others` = n non-joint and `joint` = N joint
/// coordinates, by reciprocity one triangle of every square block:
///   sub_jn = H_sub(j,n), sub_jj = H_sub(j,j): the nuisance unknowns of a line, X and Y in formulas;
///   asm_jn = H_asm(j,n), asm_jj = H_asm(j,j), drop_nn = H_sub(n,n) − H_asm(n,n): what these and the joint predict, A, B and D
///   there.
struct LineLayout {
  Dofs coordinates;  ///< n non-joint ones, then the N joint ones
  std::size_t others = 0, joint = 0;
  std::vector<Element> sub_jn;            ///< (p, k) not zero by construction, column by column
  std::vector<std::size_t> sub_jn_first;  ///< [n+1] where column k of `sub_jn` begins
  std::vector<Element> sub_jj;            ///< (p, q), p ≤ q, not zero by construction
  std::vector<Element> asm_jn;            ///< (p, k) measured on some line
  std::vector<Element> asm_jj;            ///< (p, q), p ≤ q, measured on some line
  std::vector<Element> drop_nn;           ///< (r, k), r ≤ k, measured on both systems on some line

  std::size_t variables() const { return sub_jn.size() + sub_jj.size(); }  ///< complex

  /// Whether the assembly is measured at joint coordinates.
  bool reaches_joint() const { return !asm_jn.empty() || !asm_jj.empty(); }

  /// So many that a line costs more than what it takes to save some of its factorisations.
  bool is_large() const { return variables() >= 64; }
};

/// What an element is an FRF of.
enum class ElementOf { substructures, assembly, difference };

/// Calls use(system, at) for every element in the order of the line's data, from sub_jn to drop_nn: of which system it is, and
/// its place there. One of drop_nn is the difference of both systems there.
template <class Use>
void for_each_element(const LineLayout& layout, const Use& use) {
  const std::size_t n = layout.others;
  for (const Element& e : layout.sub_jn) use(ElementOf::substructures, Element{n + e.row, e.column});
  for (const Element& e : layout.sub_jj) use(ElementOf::substructures, Element{n + e.row, n + e.column});
  for (const Element& e : layout.asm_jn) use(ElementOf::assembly, Element{n + e.row, e.column});
  for (const Element& e : layout.asm_jj) use(ElementOf::assembly, Element{n + e.row, n + e.column});
  for (const Element& e : layout.drop_nn) use(ElementOf::difference, e);
}

}  // namespace jointid::ident
