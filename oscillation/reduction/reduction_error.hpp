#pragma once

#include <functional>
#include <vector>

#include "oscillation/integrate/stick_slip.hpp"
#include "oscillation/reduction/bases.hpp"

namespace jointid::oscillation {

/// A structure with its contact, as reduced models are made of it.
struct Model {
  Mechanics mechanics;
  Drive drive;
  Friction friction;
};
ContactSystem contact_system(const Model& model);
/// On a basis.
Model reduced(const Model& full, const ReductionBasis& basis);

/// The motion that full and reduced models are compared over.
struct ComparedMotion {
  Eigen::VectorXd q, v;       ///< start of the full model, [n]
  double transient = 0.0;     ///< s before the window, ≥ 0
  double length = 0.0;        ///< s of the window, > 0
  std::size_t samples = 600;  ///< in the window, at equal steps from its beginning on; ≥ 1
  Eigen::MatrixXd observed;   ///< linear forms of q, e.g. a strain, [forms, n]; empty: none
  std::function<bool()> interrupted = {};
};

/// Displacements and velocities at the samples of the window.
struct Trajectory {
  MotionEnd status = MotionEnd::ok;
  Eigen::MatrixXd q, v;  ///< [n, samples]
  double seconds = 0.0;  ///< of run time
};
Trajectory trajectory(const Model& model, const ComparedMotion& motion);
/// The same of the model on a basis, in the coordinates of the full one.
Trajectory trajectory(const Model& full, const ReductionBasis& basis, const ComparedMotion& motion);

/// How far a model is from the full one (Kappagantu 3.36, 3.37, whose norms are not printed: ours are of sums over the samples).
struct ReductionError {
  MotionEnd status = MotionEnd::ok;
  double motion = 0.0;       ///< ΔX = √(Σ|q − q̂|² + |v − v̂|²)/√(Σ|q|² + |v|²)
  double energy = 0.0;       ///< ΔE = |ΣÊ/ΣE − 1|, E = ½vᵀMv + ½qᵀKq
  Eigen::VectorXd observed;  ///< [forms] largest |difference|
  double seconds = 0.0;      ///< of run time
};
/// Numbers are NaN where one of the two motions did not end well.
ReductionError reduction_error(const Model& full, const Trajectory& truth, const Trajectory& found,
                               const Eigen::MatrixXd& observed);

}  // namespace jointid::oscillation
