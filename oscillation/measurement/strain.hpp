#pragma once

#include <vector>

#include "base/eigen.hpp"
#include "oscillation/measurement/beam_shapes.hpp"

namespace jointid::oscillation {

/// Strain gauges on the surface of a clamped-free beam.
struct GaugedBeam {
  double length = 0.0;         ///< L, m
  double thickness = 0.0;      ///< h, m; the surface is h/2 away from the neutral line ("half the width" in (4.5) means this)
  std::vector<double> gauges;  ///< 0 ≤ x ≤ L, m
};

/// y = ΦΨ⁺ε/(h/2) (4.5): displacement at points from strain +(h/2)y'' at gauges, for motion within the span of the shapes.
struct StrainMap {
  Eigen::MatrixXd matrix;  ///< [points, gauges], m per unit strain
  double condition = 0.0;  ///< σ₁/σ_n of Ψ
  Eigen::VectorXd noise;   ///< [points] m rms per unit rms of independent strain errors: the norms of the rows
};

/// At least as many gauges as shapes; least squares where there are more. Throws InputError for fewer, for places off the beam
/// and for gauges that cannot tell the shapes apart (condition above 1e12).
StrainMap strain_map(const GaugedBeam& beam, const std::vector<Shape>& basis, const std::vector<double>& points);

}  // namespace jointid::oscillation
