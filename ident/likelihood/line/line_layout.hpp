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
///   X = H_sub(j,n), Y = H_sub(j,j): the nuisance unknowns of a line;
///   A = H_asm(j,n), B = H_asm(j,j), D = H_sub(n,n) − H_asm(n,n): what X, Y and the joint predict.
struct LineLayout {
  Dofs coordinates;  ///< n non-joint ones, then the N joint ones
  std::size_t others = 0, joint = 0;
  std::vector<Element> x;            ///< (p, k) not zero by construction, column by column
  std::vector<std::size_t> x_first;  ///< [n+1] where column k of `x` begins
  std::vector<Element> y;            ///< (p, q), p ≤ q, not zero by construction
  std::vector<Element> a;            ///< (p, k) measured on some line
  std::vector<Element> b;            ///< (p, q), p ≤ q, measured on some line
  std::vector<Element> d;            ///< (r, k), r ≤ k, measured on both systems on some line

  std::size_t variables() const { return x.size() + y.size(); }  ///< complex

  /// Whether the assembly is measured at joint coordinates.
  bool reaches_joint() const { return !a.empty() || !b.empty(); }

  /// So many that a line costs more than what it takes to save some of its factorisations.
  bool is_large() const { return variables() >= 64; }
};

/// What an element is an FRF of.
enum class ElementOf { substructures, assembly, difference };

/// Calls use(system, at) for every element in the order of the line's data, x, y, a, b, d: of which system it is, and its place there.
/// One of `d` is the difference of both systems there.
template <class Use>
void for_each_element(const LineLayout& layout, const Use& use) {
  const std::size_t n = layout.others;
  for (const Element& e : layout.x) use(ElementOf::substructures, Element{n + e.row, e.column});
  for (const Element& e : layout.y) use(ElementOf::substructures, Element{n + e.row, n + e.column});
  for (const Element& e : layout.a) use(ElementOf::assembly, Element{n + e.row, e.column});
  for (const Element& e : layout.b) use(ElementOf::assembly, Element{n + e.row, n + e.column});
  for (const Element& e : layout.d) use(ElementOf::difference, e);
}

}  // namespace jointid::ident
