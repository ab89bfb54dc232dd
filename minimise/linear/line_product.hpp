#pragma once

#include <complex>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/complex.hpp"

namespace jointid::minimise {

/// A rectangle inside a row-major matrix that somebody else owns.
struct View {
  const Complex* data = nullptr;
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::size_t stride = 0;  ///< elements from row to row

  const Complex& operator()(std::size_t r, std::size_t c) const { return data[r * stride + c]; }
  View block(std::size_t r, std::size_t c, std::size_t block_rows, std::size_t block_columns) const {
    return {data + r * stride + c, block_rows, block_columns, stride};
  }
};

/// All equations of one line in the common form A Z_j B = C₁ − C₂ (docs/formulas.md §2, 6.24): A [M×N], B [N×L], C [M×L].
/// Rows and columns come in two classes, 0 = non-joint and 1 = joint coordinates; the pair (row class, column class) is the
/// named equation (0,0) nn, (0,1) nj, (1,1) jj, (1,0) jn.
struct LineProduct {
  double frequency_hz = 0.0;
  View a;  ///< empty for Method Two, whose A is the unit matrix
  View b;
  View c1, c2;
  std::vector<std::uint8_t> row_class;     ///< [M]
  std::vector<std::uint8_t> column_class;  ///< [L]
  bool wanted[2][2] = {};                  ///< [row class][column class] named by the scene
  bool a_is_unit = false;

  /// How large the errors of A and of C₁ − C₂ are where every FRF has a relative error of 1, row-major [M×N] and [M×L];
  /// empty where they are those of the elements themselves, |A| and |C₁| + |C₂|. Only for who set wants_error_scale.
  std::span<const double> a_error, c_error;
  bool wants_error_scale = false;
};

}  // namespace jointid::minimise
