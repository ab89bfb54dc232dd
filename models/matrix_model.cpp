#include "models/matrix_model.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
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
constexpr std::size_t least_lines = 12;     ///< a reduction takes about as long as three to eight factorisations
constexpr std::size_t most_dampers = 64;    ///< coordinates of damping that is no combination of mass and stiffness
constexpr Eigen::Index least_share = 3;     ///< a basis of more than a third of the coordinates is no reduction
constexpr double least_range = 0.125;       ///< of all lines, that is prepared for at once
constexpr Eigen::Index most_compared = 20'000;  ///< coordinates: one factorisation of more takes longer than all else
constexpr double disagreement = 10.0;       ///< over the error that a reduction states, at least that it accepts: it is not used
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
      sparse_(factors == Factors::sparse || (factors == Factors::by_size && chooses_sparse(matrices_))),
      may_reduce_(sparse_) {
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
    if (!(std::abs(h(k, at(j)) * z.coeff(k, k)) < infinite_receptance)) return std::nullopt;
  }
  if (!h.allFinite()) return std::nullopt;
  return h;
}

void MatrixModel::expect(const Request& request) {
  if (!may_reduce_) return;
  lines_asked_ += request.omega.size();
  const auto positive = [](double omega) { return omega > 0.0; };
  if (lines_asked_ < least_lines || std::ranges::none_of(request.omega, positive)) return;
  double low = request.highest, high = request.lowest;
  for (const double omega : request.omega) {
    if (positive(omega)) low = std::min(low, omega);
    high = std::max(high, omega);
  }
  const bool is_new = !std::ranges::includes(reduced_between_, request.coordinates);
  if (reduction_ && !is_new && low >= low_ && high <= high_) return;
  high = std::max(high, std::min(request.highest, low + least_range * (request.highest - request.lowest)));
  if (reduction_) {  // what is read in pieces is prepared for in pieces of twice the size
    const double reach = 2.0 * (std::max(high, high_) - std::min(low, low_));
    if (high > high_) high = std::max(high, std::min(request.highest, low_ + reach));
    if (low < low_) low = std::min(low, std::max(request.lowest, high_ - reach));
    low = std::min(low, low_);
    high = std::max(high, high_);
  }
  if (is_new) {
    std::vector<std::size_t> all;
    std::ranges::set_union(reduced_between_, request.coordinates, std::back_inserter(all));
    reduced_between_ = std::move(all);
    reduction_.reset();
    compared_vectors_ = 0;
  }
  may_reduce_ = reduce(low, high);
  if (may_reduce_) {
    why_not_reduced_.clear();
  } else {
    reduction_.reset();
    compared_vectors_ = 0;  // a basis that is built again is compared again
  }
}

bool MatrixModel::reduce(double low, double high) {
  if (!reduction_) {
    if (!form_) form_ = proportional_form(matrices_, most_dampers);
    if (!form_) return is_not_reduced("its damping is no combination of mass and stiffness, at more than 64 coordinates");
    reduction_ = std::make_unique<Reduction>(matrices_, *form_, reduced_between_);
  }
  if (!reduction_->cover(low, high, matrices_.mass.rows() / least_share)) {
    return is_not_reduced(reduction_->vectors() == 0 ? "its stiffness is not positive"
                                                     : "a basis of a third of its coordinates does not reach the bound");
  }
  low_ = low;
  high_ = high;
  const Eigen::Index vectors = reduction_->vectors();
  if (matrices_.mass.rows() > most_compared || std::exchange(compared_vectors_, vectors) == vectors) return true;
  const std::vector<std::size_t>& all = reduced_between_;
  const auto exact = factorised(reduction_->worst_omega(), all, all), own = reduction_->receptance(reduction_->worst_omega(), all, all);
  const bool agree = exact && own &&
                     (*exact - *own).cwiseAbs().maxCoeff() <=
                         disagreement * std::max(reduction_->error(), Reduction::accepted) * exact->cwiseAbs().maxCoeff();
  return agree || is_not_reduced("the factorisation that is compared differs from the basis");
}

bool MatrixModel::is_not_reduced(std::string why) {
  why_not_reduced_ = std::move(why);
  return false;
}

std::string MatrixModel::why_factorised(std::size_t lines) const {
  if (!why_not_reduced_.empty()) return why_not_reduced_;
  return lines < least_lines ? "fewer than 12 lines" : "";
}

ModelUse MatrixModel::use(std::size_t lines, std::size_t coordinates) const {
  ModelUse out{.way = ModelWay::full, .coordinates = size()};
  out.factorizations = count_.factorizations;
  out.reduced_lines = count_.reduced;
  if (sparse_) {
    out.reason = why_factorised(std::max(lines, lines_asked_));
    out.way = out.reason.empty() ? ModelWay::reduced : ModelWay::factorised;
  }
  if (out.way == ModelWay::reduced) out.bound = Reduction::bound;
  if (reduction_) {
    out.vectors = static_cast<std::size_t>(reduction_->vectors());
    out.shifts = reduction_->shifts();
    out.error = reduction_->error();
    out.worst_hz = hertz(reduction_->worst_omega());
  }
  predict(lines, coordinates, out);
  return out;
}

/// What blocks of bricks took, shells and beams of as many coordinates take less: docs/model-parts.md.
void MatrixModel::predict(std::size_t lines, std::size_t coordinates, ModelUse& out) const {
  constexpr double vectors_each = 8.0, factor_entries = 17.0, lu_entries = 60.0;     // of n^(4/3)
  constexpr double factor_seconds = 8e-10, lu_seconds = 3e-8, full_seconds = 6e-10;  // of n², n², n³
  constexpr double fast = 2.5e10, slow = 4e9, matrix_bytes = 115.0;                  // flop/s; bytes of an element of K and M
  const auto n = static_cast<double>(matrices_.mass.rows()), each = static_cast<double>(lines),
             m = static_cast<double>(coordinates);
  const double elements = static_cast<double>(matrices_.stiffness.nonZeros()), fill = std::pow(n, 4.0 / 3.0);
  const double lu_bytes = lu_entries * fill * sizeof(Complex);
  out.expected_bytes = matrix_bytes * elements;
  if (out.way == ModelWay::full) {
    out.expected_bytes += 3.0 * n * n * sizeof(Complex);
    out.expected_seconds = each * full_seconds * n * n * n;
  } else if (out.way == ModelWay::factorised) {
    out.expected_bytes += lu_bytes;
    out.expected_seconds = each * lu_seconds * n * n;
  } else {
    const double vectors = std::min(vectors_each * m, n / static_cast<double>(least_share));
    const bool compares = matrices_.mass.rows() <= most_compared;
    out.expected_vectors = static_cast<std::size_t>(vectors);
    out.expected_bytes += factor_entries * fill * sizeof(double) + n * vectors * sizeof(double) + (compares ? lu_bytes : 0.0);
    out.expected_seconds = factor_seconds * n * n + 8.0 * vectors * factor_entries * fill / fast +
                           4.0 * n * vectors * vectors / slow + 8.0 * each * vectors * m * m / fast +
                           (compares ? lu_seconds * n * n : 0.0);
  }
}

std::optional<Eigen::MatrixXcd> MatrixModel::receptance(double omega, std::span<const std::size_t> rows,
                                                        std::span<const std::size_t> columns) {
  if (!reduction_ || !reduction_->covers(omega) || !reduction_->has(rows) || !reduction_->has(columns)) {
    return factorised(omega, rows, columns);
  }
  ++count_.reduced;
  return reduction_->receptance(omega, rows, columns);
}

std::optional<Eigen::MatrixXcd> MatrixModel::factorised(double omega, std::span<const std::size_t> rows,
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
