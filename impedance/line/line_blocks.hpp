#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "base/eigen.hpp"
#include "ident/likelihood/line/line_data.hpp"
#include "impedance/line/error_columns.hpp"

namespace jointid::impedance {

/// The measured FRFs of a line as matrices over n coordinates away from the joint, then N of the joint, with the errors of what
/// was measured. H(n,n) of both systems is told as their difference alone: `substructures` has H_sub − H_asm there, `assembly`
/// zeros. No formula for Z needs more.
struct LineBlocks {
  std::size_t others = 0, joint = 0;
  double omega = 0.0;
  Eigen::MatrixXcd substructures, assembly;
  Eigen::MatrixXd known_substructures, known_assembly;  ///< 1 where the FRF is measured, or zero by construction

  struct Frf {
    Eigen::Index row, column;
    bool of_assembly;
  };
  std::vector<Frf> frfs;  ///< the E measured ones, once each
  ErrorColumns errors;    ///< of `frfs`

  Eigen::MatrixXcd y_substructures() const { return substructures.bottomRightCorner(at(joint), at(joint)); }
  Eigen::MatrixXcd y_assembly() const { return assembly.bottomRightCorner(at(joint), at(joint)); }

};

LineBlocks blocks_of(const ident::LineLayout& layout, const ident::LineData& data);

/// Whether all of a rectangle of a matrix of LineBlocks is known.
bool is_known(const Eigen::MatrixXd& known, const std::vector<Eigen::Index>& rows, const std::vector<Eigen::Index>& columns);

}  // namespace jointid::impedance
