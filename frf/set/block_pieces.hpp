#pragma once

#include <vector>

#include "frf/set/frf_set.hpp"

namespace jointid::frf {

/// What one file contributes to a rectangle of FRFs: those from its (responses × references) to (row, column).
struct BlockPiece {
  std::size_t source = 0;
  std::vector<std::size_t> responses, references;  ///< of the file
  std::vector<std::size_t> rows, columns;          ///< of the rectangle; swapped roles when transposed
  std::vector<double> response_sign, reference_sign;
  bool transposed = false;  ///< reciprocity: fills what is still missing

  std::size_t size() const { return responses.size() * references.size(); }
  /// Place in the rectangle (row-major, `width` columns) of the file's r-th response and c-th reference.
  std::size_t place(std::size_t r, std::size_t c, std::size_t width) const {
    return transposed ? columns[c] * width + rows[r] : rows[r] * width + columns[c];
  }
};

/// The piece of one file, without FRFs when it has none of the rectangle.
BlockPiece find_piece(const FrfHeader& header, std::size_t source, const std::vector<Dof>& rows,
                      const std::vector<Dof>& columns, bool transposed);

}  // namespace jointid::frf
