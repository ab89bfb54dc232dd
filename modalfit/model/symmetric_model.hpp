#pragma once

#include <complex>
#include <cstddef>
#include <string>
#include <vector>

#include "frf/set/dof.hpp"
#include "modalfit/band/band.hpp"
#include "modalfit/model/fit.hpp"
#include "modalfit/model/residual_table.hpp"
#include "modalfit/model/shape_covariance.hpp"

namespace jointid::modalfit {

/// A mode of all coordinates at once: residue A_ab = φ_a φ_b of a ModelKind (docs/formulas.md §9). With real modes φ is real and
/// normalised to unit modal mass, 1/√kg; with complex viscous modes φφᵀ is R, modal A being 1.
struct SymmetricMode {
  Pole pole;
  std::vector<std::complex<double>> shape;       ///< [n]
  ShapeCovariance covariance;
  std::array<double, 4> pole_covariance{};       ///< [2,2] of (ln f, damping)
  double misfit = 0.0;  ///< mean square of the residues' deviations from the rank-one matrix over their variances; NaN without redundancy
};

/// One modal model for the whole FRF matrix, measured or not: reciprocal, every residue of rank one.
struct SymmetricModel {
  ModelKind kind;
  std::vector<frf::Dof> dofs;  ///< [n] all coordinates, signs +, ascending (frf::coordinate_key)
  std::vector<SymmetricMode> modes;
  ResidualTable residuals;
  double scale_hz = 1.0;
  std::array<double, 2> range_hz{};      ///< of the lines fitted; outside the model does not hold

  /// Index in `dofs`, whatever the sign, or frf::npos.
  std::size_t find(const frf::Dof& dof) const;
};

/// Why a set of FRFs has no symmetric model, empty when it has: without a coordinate that is response and reference (a driving
/// point) the shapes have no scale.
std::string obstacle(const ModalFit& fit);

/// The symmetric model nearest to a fit: for each mode the shape that minimises Σ|A_ab − φ_aφ_b|²/σ²_ab over the measured FRFs (σ²
/// of the fit; Gauss–Newton from the first singular vectors), then the residual terms anew with those modes held fixed, completed
/// where nothing was measured (ResidualTable). Time and memory are linear in the responses of a few references. Pre-condition:
/// obstacle() is empty. `band`: that of the fit.
SymmetricModel make_symmetric(const ModalFit& fit, const Band& band);

}  // namespace jointid::modalfit
