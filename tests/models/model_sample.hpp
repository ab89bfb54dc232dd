#pragma once

#include <Eigen/SparseCore>
#include <filesystem>
#include <fstream>
#include <string>

#include "base/eigen.hpp"
#include "models/matrix_model.hpp"
#include "problems/case/thesis_beams.hpp"

namespace jointid::models {

inline Eigen::SparseMatrix<double> sparse_matrix(const problems::Structure& structure, problems::Kind kind) {
  const std::size_t n = structure.size();
  Eigen::MatrixXd m(at(n), at(n));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) m(at(i), at(j)) = structure.matrix(kind)[i * n + j];
  }
  return m.sparseView();
}

/// The matrices of a structure, its hysteretic damping as a matrix.
inline StructureMatrices matrices_of(const problems::Structure& structure) {
  return {sparse_matrix(structure, problems::Kind::mass),
          sparse_matrix(structure, problems::Kind::stiffness),
          {},
          sparse_matrix(structure, problems::Kind::hysteretic_damping),
          0.0};
}

/// A beam of the thesis's section, free, of so many elements of 0.02 m.
inline problems::Structure fine_beam(std::size_t elements) {
  problems::BeamLine line;
  for (std::size_t i = 0; i <= elements; ++i) line.x.push_back(0.02 * static_cast<double>(i));
  problems::Structure out = problems::beam(problems::thesis_section(), line);
  out.add_proportional_damping(0.01);
  return out;
}

inline void write_text(const std::filesystem::path& path, const std::string& text) { std::ofstream(path) << text; }

/// Matrix Market, with all digits.
inline void write_market(const std::filesystem::path& path, const Eigen::SparseMatrix<double>& m) {
  std::ofstream out(path);
  out.precision(17);
  out << "%%MatrixMarket matrix coordinate real general\n" << m.rows() << ' ' << m.cols() << ' ' << m.nonZeros() << '\n';
  for (Eigen::Index j = 0; j < m.outerSize(); ++j) {
    for (Eigen::SparseMatrix<double>::InnerIterator e(m, j); e; ++e)
      out << e.row() + 1 << ' ' << j + 1 << ' ' << e.value() << '\n';
  }
}

inline std::string dof_list(const std::vector<frf::Dof>& dofs) {
  std::string text;
  for (const frf::Dof& dof : dofs) text += (text.empty() ? "\"" : ", \"") + dof.name() + "\"";
  return "[" + text + "]";
}

}  // namespace jointid::models
