#include "ident/plan/joint_effect.hpp"

#include "base/complex.hpp"
#include "base/eigen.hpp"
#include "coupling/joint_loop.hpp"
#include "restrictions/impedance_factor.hpp"

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
  const double omega = angular(frequency_hz);
  MatrixXcd z = MatrixXcd::Zero(at(n), at(n));
  for (const auto& [kind, matrix] : matrices) {
    Eigen::MatrixXd values(at(n), at(n));
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) values(at(i), at(j)) = matrix[i][j];
    }
    restrictions::add_impedance(kind, values, omega, z);
  }
  return z;
}

Dofs with_joint(const Dofs& dofs, const Dofs& joint) {
  return frf::has(dofs, joint.front()) ? dofs : joined(dofs, joint);
}

Dofs joint_last(Dofs dofs, const Dofs& joint) {
  std::erase_if(dofs, [&](const frf::Dof& dof) { return frf::has(joint, dof); });
  return joined(std::move(dofs), joint);
}

Rectangle whole_rectangle(frf::FrfSystem& system, const Dofs& rows, const Dofs& columns) {
  return {system, {{rows, columns}}, columns};
}

Complex JointEffect::assembly(Complex h, std::size_t row, std::size_t column) const {
  for (std::size_t j = 0; j < right.rows; ++j) h -= left(at(row), at(j)) * right(j, column);
  return h;
}

JointEffect joint_effect(const minimise::View& h, std::size_t rows, std::size_t columns, const MatrixXcd& impedance) {
  const auto n = static_cast<std::size_t>(impedance.rows());
  const minimise::View h_to = h.block(0, h.columns - n, rows, n);
  const minimise::View h_bb = h.block(h.rows - n, h.columns - n, n, n);
  return {map(h_to) * coupling::force_with_joint(impedance, map(h_bb), impedance), h.block(h.rows - n, 0, n, columns)};
}

}  // namespace jointid::ident
