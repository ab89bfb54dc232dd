#pragma once

#include <algorithm>

#include "ident/likelihood/model/line_model.hpp"

namespace jointid::ident {

/// Of the χ² of a line.
constexpr double next_to_nothing = 1e-5;

/// A line of the likelihood: its true FRFs as they are estimated now, how well they fit, and the line linearised about them.
struct FittedLine {
  JointImpedance joint;
  std::vector<std::size_t> columns{};  ///< of the whole problem: the joint's, then those of systematic errors
  LineState state;
  double redundancy = 0.0;  ///< what is measured more than is unknown; a line that has none says nothing
  double cost = 0.0;        ///< χ²
  double weight = 1.0;      ///< robust weight
  ReducedLine reduced;
  bool followed = false;  ///< the last step of the joint as it was predicted: `reduced` is still near

  bool far_from_fitting() const { return redundancy > 0.0 && cost > 4.0 * redundancy; }

  /// Whether χ² is above what was predicted by next to nothing.
  bool is_as_predicted(double reached, double predicted) const {
    return reached <= predicted + next_to_nothing * std::max(redundancy, predicted);
  }
};

/// Measured values where there are, and for the rest what the joint makes of them.
LineState first_state(const LineLayout& layout, const LineData& data, const ComplexMatrix& z);

/// The line linearised where it stands and reduced to the joint's unknowns. No information, no step, and the χ² that is expected of
/// a line that cannot be linearised there, such as one on an undamped resonance of the predicted assembly. Without the joint only χ²
/// is of use.
ReducedLine linearised(const LineData& data, const ComplexMatrix& z, LineModel& model, const FittedLine& line,
                       bool with_joint = true);

enum class Relaxation {
  end,       ///< to the minimum of χ²
  beginning  ///< until another step would change χ² by next to nothing: where a common step with the joint follows
};

/// Of a line on the constraint whose FRFs are about at their minimum: χ² and the gradient where it stands, the FRFs eliminated by
/// U⁻¹W of the place where it was linearised last, whose information stays: right to first order in the way from there. No step of
/// the FRFs. Needs has_plain_errors().
void take_gradient(const LineData& data, const ComplexMatrix& z, const LineLayout& layout, FittedLine& line);

/// Columns of −½ of the derivatives of χ² by the line's unknowns, FRFs optimised, at joints nearby, Z and the line's own offset of
/// each: by gradients and the factors of the line where it is linearised (at Z `here`), and by relax() where these do not lead there.
/// Needs has_plain_errors(). `has_factors`: the model has those of the line already.
struct JointNearby {
  ComplexMatrix z;
  Eigen::VectorXd offset;
};
Eigen::MatrixXd gradients_nearby(const LineData& data, const ComplexMatrix& here, LineModel& model, const FittedLine& line,
                                 const std::vector<JointNearby>& joints, bool has_factors = false);

/// Puts the line on the constraint and linearises it; its FRFs are optimised, in the beginning only where that promises to bring much:
/// whether they were.
bool settle(const LineData& data, const ComplexMatrix& z, LineModel& model, FittedLine& line, Relaxation until);

/// settle() of a line that stands where it was measured, off the constraint, for a joint that is nearly right: linearised there, and
/// its FRFs optimised by the factors of that, whose information stays; where these do not lead there, as settle() does in the beginning.
void settle_measured(const LineData& data, const ComplexMatrix& z, LineModel& model, FittedLine& line);

/// Levenberg–Marquardt of the line's FRFs for a given joint.
void relax(const LineData& data, const ComplexMatrix& z, LineModel& model, FittedLine& line, Relaxation until = Relaxation::end);

/// The same for a line that is far from fitting, from other starts, and the best of all ends: from the measured values, and from where
/// the implicit iteration gets from them.
void relax_again(const LineData& data, const ComplexMatrix& z, LineModel& model, FittedLine& line);

}  // namespace jointid::ident
