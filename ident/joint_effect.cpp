#include "ident/joint_effect.hpp"

#include <numbers>

#include "dense/lu.hpp"
#include "ident/row_expander.hpp"

namespace jointid::ident {

using Eigen::Index;
using Eigen::MatrixXcd;

const Matrices* matrices_at(const std::vector<BandMatrices>& bands, double frequency_hz) {
  for (const BandMatrices& band : bands) {
    if (!band.band_hz || (frequency_hz >= (*band.band_hz)[0] && frequency_hz < (*band.band_hz)[1])) {
      return &band.matrices;
    }
  }
  return nullptr;
}

MatrixXcd joint_impedance(const Matrices& matrices, std::size_t n, double frequency_hz) {
  const double omega = 2.0 * std::numbers::pi * frequency_hz;
  MatrixXcd z = MatrixXcd::Zero(static_cast<Index>(n), static_cast<Index>(n));
  for (const auto& [kind, matrix] : matrices) {
    const Complex factor = impedance_factor(kind, omega);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) z(static_cast<Index>(i), static_cast<Index>(j)) += factor * matrix[i][j];
    }
  }
  return z;
}

Dofs with_joint(const Dofs& dofs, const Dofs& joint) {
  return frf::find_coordinate(dofs, joint.front()) == frf::npos ? joined(dofs, joint) : dofs;
}

Dofs joint_last(Dofs dofs, const Dofs& joint) {
  std::erase_if(dofs, [&](const frf::Dof& dof) { return frf::find_coordinate(joint, dof) != frf::npos; });
  return joined(std::move(dofs), joint);
}

Rectangle whole_rectangle(frf::FrfSystem& system, const Dofs& rows, const Dofs& columns) {
  return {system, {{rows, columns}}, columns};
}

Complex JointEffect::assembly(Complex h, std::size_t row, std::size_t column) const {
  for (std::size_t j = 0; j < right.rows; ++j) h -= left(static_cast<Index>(row), static_cast<Index>(j)) * right(j, column);
  return h;
}

JointEffect joint_effect(const View& h, std::size_t rows, std::size_t columns, const MatrixXcd& impedance) {
  const auto n = static_cast<std::size_t>(impedance.rows());
  const View h_to = h.block(0, h.columns - n, rows, n);
  const View h_bb = h.block(h.rows - n, h.columns - n, n, n);
  const MatrixXcd p = MatrixXcd::Identity(impedance.rows(), impedance.cols()) + impedance * map(h_bb);
  return {map(h_to) * dense::solve(p, impedance), h.block(h.rows - n, 0, n, columns)};
}

}  // namespace jointid::ident
