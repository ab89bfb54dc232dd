#pragma once

#include "ident/likelihood/line/line_model.hpp"

namespace jointid::ident {

/// A line of the likelihood: its true FRFs as they are estimated now, how well they fit, and the line linearised about them.
struct FittedLine {
  JointImpedance joint;
  LineState state;
  double redundancy = 0.0;  ///< what is measured more than is unknown; a line that has none says nothing
  double cost = 0.0;        ///< χ²
  double weight = 1.0;      ///< robust weight
  ReducedLine reduced;

  bool far_from_fitting() const { return redundancy > 0.0 && cost > 4.0 * redundancy; }
};

/// Measured values where there are, and for the rest what the joint makes of them.
LineState first_state(const LineLayout& layout, const LineData& data, const ComplexMatrix& z);

/// The line linearised where it stands and reduced to the joint's unknowns. No information, no step, and the χ² that is expected of
/// a line that cannot be linearised there, such as one on an undamped resonance of the predicted assembly.
ReducedLine linearised(const LineData& data, const ComplexMatrix& z, LineModel& model, const FittedLine& line);

/// Levenberg–Marquardt of the line's FRFs for a given joint.
void relax(const LineData& data, const ComplexMatrix& z, LineModel& model, FittedLine& line);

/// The same for a line that is far from fitting, from other starts, and the best of all ends: from the measured values, and from where
/// the implicit iteration gets from them.
void relax_again(const LineData& data, const ComplexMatrix& z, LineModel& model, FittedLine& line);

}  // namespace jointid::ident
