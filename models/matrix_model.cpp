#include "models/matrix_model.hpp"

#include <utility>

#include "base/eigen.hpp"
#include "base/error.hpp"
#include "dense/lu.hpp"

namespace jointid::models {
namespace {

using Sparse = Eigen::SparseMatrix<double>;
using ComplexSparse = Eigen::SparseMatrix<Complex>;

constexpr Eigen::Index most_full = 60;   ///< rows of matrices that are always factorised as full ones
constexpr double fullest_sparse = 0.25;  ///< share of elements
constexpr double infinite = 1e13;
constexpr Complex i{0.0, 1.0};

bool fits(const Sparse& matrix, Eigen::Index n) { return matrix.rows() == 0 || (matrix.rows() == n && matrix.cols() == n); }

ComplexSparse static_stiffness(const StructureMatrices& of) {
  ComplexSparse k = of.stiffness.cast<Complex>() * Complex(1.0, of.loss_factor);
  if (of.hysteretic_damping.rows() > 0) k += i * of.hysteretic_damping.cast<Complex>();
  return k;
}

/// Z(ω)
ComplexSparse dynamic_stiffness(const StructureMatrices& of, const ComplexSparse& stiffness, double omega) {
  ComplexSparse z = stiffness;
  z += Complex(-omega * omega) * of.mass.cast<Complex>();
  if (of.viscous_damping.rows() > 0) z += i * omega * of.viscous_damping.cast<Complex>();
  z.makeCompressed();
  return z;
}

bool chooses_sparse(const StructureMatrices& of) {
  const auto n = static_cast<double>(of.mass.rows());
  const auto elements = static_cast<double>(std::max(of.mass.nonZeros(), of.stiffness.nonZeros()));
  return of.mass.rows() > most_full && elements < fullest_sparse * n * n;
}

}  // namespace

MatrixModel::MatrixModel(StructureMatrices matrices, Factors factors)
    : matrices_(std::move(matrices)),
      sparse_(factors == Factors::sparse || (factors == Factors::by_size && chooses_sparse(matrices_))) {
  const Eigen::Index n = matrices_.stiffness.rows();
  if (n == 0 || matrices_.mass.rows() == 0 || !fits(matrices_.mass, n) || !fits(matrices_.stiffness, n) ||
      !fits(matrices_.viscous_damping, n) || !fits(matrices_.hysteretic_damping, n)) {
    refuse("matrices of one structure have as many rows each");
  }
  stiffness_ = static_stiffness(matrices_);
}

std::optional<Eigen::MatrixXcd> MatrixModel::solve(double omega, std::span<const std::size_t> forces) {
  const ComplexSparse z = dynamic_stiffness(matrices_, stiffness_, omega);
  Eigen::MatrixXcd loads = Eigen::MatrixXcd::Zero(z.rows(), at(forces.size()));
  for (std::size_t j = 0; j < forces.size(); ++j) loads(at(forces[j]), at(j)) = 1.0;
  ++count_.factorizations;
  count_.columns += forces.size();
  if (sparse_ && !factors_.factorize(z)) return std::nullopt;
  Eigen::MatrixXcd h = sparse_ ? factors_.solve(loads) : dense::solve(Eigen::MatrixXcd(z), loads);
  for (std::size_t j = 0; j < forces.size(); ++j) {
    const Eigen::Index k = at(forces[j]);
    if (!(std::abs(h(k, at(j)) * z.coeff(k, k)) < infinite)) return std::nullopt;
  }
  if (!h.allFinite()) return std::nullopt;
  return h;
}

std::optional<Eigen::MatrixXcd> MatrixModel::receptance(double omega, std::span<const std::size_t> rows,
                                                        std::span<const std::size_t> columns) {
  const bool by_row = rows.size() < columns.size();
  const auto found = solve(omega, by_row ? rows : columns);
  if (!found) return std::nullopt;
  Eigen::MatrixXcd h(at(rows.size()), at(columns.size()));
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (std::size_t c = 0; c < columns.size(); ++c) {
      h(at(r), at(c)) = by_row ? (*found)(at(columns[c]), at(r)) : (*found)(at(rows[r]), at(c));
    }
  }
  return h;
}

}  // namespace jointid::models
