#pragma once

#include <complex>
#include <cstddef>
#include <vector>

#include "modalfit/band/model_kind.hpp"
#include "modalfit/band/pole.hpp"

namespace jointid::modalfit {

/// The functions of frequency that a model is linear in, each with a real coefficient per FRF, over lines x = f/scale:
/// per mode one (real modes) or two columns (real and imaginary part of the residue), then Re L, Im L, Re U, Im U.
/// `derivatives` holds ∂column/∂(ln f_r) and ∂column/∂damping of the mode's own columns.
/// In SI units a residue of the second-order form, and L, is the coefficient times (2π·scale)², R times 2π·scale, U times 1.
struct Basis {
  std::size_t lines = 0, modes = 0, per_mode = 1;
  std::vector<std::complex<double>> columns;      ///< [column, line]
  std::vector<std::complex<double>> derivatives;  ///< [mode, parameter (2), own column (per_mode), line]; empty when not asked for

  std::size_t size() const { return modes * per_mode + 4; }
  const std::complex<double>* column(std::size_t j) const { return columns.data() + j * lines; }
  const std::complex<double>* derivative(std::size_t mode, std::size_t parameter, std::size_t own) const {
    return derivatives.data() + ((mode * 2 + parameter) * per_mode + own) * lines;
  }
};

Basis make_basis(const ModelKind& kind, const std::vector<Pole>& poles, const std::vector<double>& frequency_hz, double scale_hz,
                 bool with_derivatives);

/// Factor from a basis coefficient to SI of a mode's residue (see Basis).
double residue_scale(const ModelKind& kind, double scale_hz);

}  // namespace jointid::modalfit
