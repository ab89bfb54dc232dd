#pragma once

#include <memory>
#include <span>
#include <vector>

#include "frf/set/frf_system.hpp"
#include "ident/plan/coordinates.hpp"
#include "ident/plan/rectangle.hpp"
#include "minimise/linear/line_product.hpp"

namespace jointid::ident {

/// Brings the FRFs of a line into the common form A Z_j B = C₁ − C₂. One implementation per method; each reads just the
/// blocks that its equations name.
class EquationBuilder {
 public:
  virtual ~EquationBuilder() = default;

  /// Reads lines by their indices in the two systems.
  virtual void read(std::span<const std::size_t> substructure_lines, std::span<const std::size_t> assembly_lines);

  /// The equations of the i-th line read; the views stay valid until the next call of line() or read(). False when the line
  /// cannot be used (a matrix to invert is singular or not fully measured).
  virtual bool line(std::size_t i, minimise::LineProduct& out) = 0;

  /// Products that make up a line: one, or one for each substructure.
  virtual std::size_t products() const { return 1; }

  /// The k-th product of the i-th line, as line().
  virtual bool product(std::size_t i, std::size_t, minimise::LineProduct& out) { return line(i, out); }

  /// The coordinate behind each column of B.
  virtual Dofs columns() const = 0;

  /// FRFs read per line.
  virtual std::size_t entries_per_line() const;

 protected:
  /// Made by the method: what it reads of each system.
  std::unique_ptr<Rectangle> substructures_, assembly_;
};

/// Method One (docs/formulas.md §2): H_nj Z_j H_ba = H_aa − H_nn and so on.
std::unique_ptr<EquationBuilder> make_method_one(const Coordinates& coordinates, const EquationSet& equations,
                                                 frf::FrfSystem& substructures, frf::FrfSystem& assembly);

/// Method Two (docs/formulas.md §3): Z_j H_jn = −Z_ba H_nn − Z_bb H_jn (`jn`), Z_j H_jj = I − Z_ba H_nj − Z_bb H_jj (`jj`), with
/// Z = H_sub⁻¹ over all coordinates. It inverts measured data and is the noisier of the two.
std::unique_ptr<EquationBuilder> make_method_two(const Coordinates& coordinates, const EquationSet& equations,
                                                 frf::FrfSystem& substructures, frf::FrfSystem& assembly);

/// Direct solution without joint coordinates of the assembly (docs/formulas.md §7; 6.77, 6.78): equation `nn` with
/// H_nj = H_ab − (H_aa − H_nn) H_ba⁺ H_bb. Exact without noise, useless with it.
std::unique_ptr<EquationBuilder> make_direct(const Coordinates& coordinates, frf::FrfSystem& substructures,
                                             frf::FrfSystem& assembly);

}  // namespace jointid::ident
