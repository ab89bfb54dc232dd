#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "friction/path/element.hpp"
#include "friction/path/loops.hpp"

namespace jointid::friction {

/// What was measured of a joint.
enum class CurveKind {
  loading,     ///< force T over displacement u ≥ 0, loaded once from rest
  loop,        ///< a steady cycle about the origin: rising up to sample `turn`, falling from there, by Masing's rule
  energy,      ///< energy per cycle E over amplitude
  equivalent,  ///< equivalent stiffness k_e and damping d_e over amplitude
};

/// One measured curve. Vectors are equally long; units are those of the element that is
/// fitted.
struct Curve {
  std::string name;
  CurveKind kind = CurveKind::loading;
  std::vector<double> u;        ///< displacement or amplitude
  std::vector<double> value;    ///< T, F, E or k_e
  std::vector<double> damping;  ///< d_e of `equivalent`, else empty
  std::size_t turn = 0;         ///< of `loop`
  std::optional<double> normal_load;
  std::string displacement_unit = "m", force_unit = "N";

  /// Measured numbers that a fit compares: the values, and for `equivalent` the dampings after them.
  std::size_t rows() const { return value.size() + damping.size(); }
  double measured(std::size_t row) const { return row < value.size() ? value[row] : damping[row - value.size()]; }
  /// Largest |u|; of a loop half its stroke.
  double largest_displacement() const;
};

/// Curves of what loops.hpp finds.
Curve loading_curve(std::string name, Record record);
Curve loop_curve(std::string name, const Loop& centred);

/// Throws InputError that says what is wrong: lengths that differ, numbers that are not finite, a negative amplitude,
/// forces that are all zero.
void validate(const Curve& curve);

/// What `element` gives for the rows of the curve. Displacements of a loop beyond its reversals are taken at them.
std::vector<double> predicted(const Element& element, const Curve& curve);

/// ∂predicted/∂p, row-major [rows, parameters]. Loading curves and loops by the element's derivative, series by
/// equivalent_derivative().
std::vector<double> predicted_derivative(const Element& element, const Curve& curve);

}  // namespace jointid::friction
