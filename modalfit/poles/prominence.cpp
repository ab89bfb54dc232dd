#include "modalfit/poles/prominence.hpp"

#include <algorithm>
#include <cmath>

#include "modalfit/band/basis.hpp"
#include "modalfit/poles/residues.hpp"

namespace jointid::modalfit {
namespace {

constexpr double known_residue = 4.0;
constexpr std::size_t flank_lines = 6;

std::size_t nearest_line(const std::vector<double>& axis, double f) {
  const auto above = std::ranges::lower_bound(axis, f);
  if (above == axis.begin()) return 0;
  if (above == axis.end()) return axis.size() - 1;
  const auto at = static_cast<std::size_t>(above - axis.begin());
  return f - axis[at - 1] < axis[at] - f ? at - 1 : at;
}

/// Modulus of the sum of the two columns (real and imaginary part) of a term.
double modulus(const Basis& basis, const double* coefficients, std::size_t first, std::size_t count, std::size_t line) {
  std::complex<double> sum = 0.0;
  for (std::size_t j = first; j < first + count; ++j) sum += coefficients[j] * basis.column(j)[line];
  return std::abs(sum);
}

/// Of all terms but mode r, L and U counted apart.
double other_moduli(const Basis& basis, const double* c, std::size_t r, std::size_t line) {
  const std::size_t own = basis.per_mode, first_residual = basis.modes * own;
  double sum = modulus(basis, c, first_residual, 2, line) + modulus(basis, c, first_residual + 2, 2, line);
  for (std::size_t s = 0; s < basis.modes; ++s) {
    if (s != r) sum += modulus(basis, c, s * own, own, line);
  }
  return sum;
}

bool is_known(const double* coefficients, const double* variance, std::size_t first, std::size_t count) {
  double square = 0.0, noise = 0.0;
  for (std::size_t j = first; j < first + count; ++j) {
    square += coefficients[j] * coefficients[j];
    noise += variance[j];
  }
  return square > known_residue * known_residue * noise;
}

double flank_squares(const Band& band, std::size_t entry, const Basis& basis, const double* c, std::size_t r, std::size_t line) {
  double sum = 0.0;
  for (std::size_t i = line - std::min(line, flank_lines); i < std::min(band.lines(), line + flank_lines + 1); ++i) {
    if (i == line) continue;
    const double* weight = band.weights(entry) + 2 * i;
    const double term = modulus(basis, c, r * basis.per_mode, basis.per_mode, i);
    sum += term * term * weight[0] * weight[1];
  }
  return sum;
}

}  // namespace

std::vector<Prominence> prominences(const Band& band, const std::vector<std::size_t>& entries, const ModelKind& kind,
                                    const std::vector<Pole>& poles) {
  const Basis basis = make_basis(kind, poles, band.frequency_hz, band.scale_hz(), false);
  const Residues residues = fit_residues(band, entries, kind, poles);
  const std::size_t own = basis.per_mode;
  std::vector<Prominence> out(poles.size());
  for (std::size_t r = 0; r < poles.size(); ++r) {
    const std::size_t line = nearest_line(band.frequency_hz, poles[r].frequency_hz);
    for (std::size_t k = 0; k < entries.size(); ++k) {
      const double* c = residues.coefficients.data() + k * residues.columns;
      out[r].flanks += flank_squares(band, entries[k], basis, c, r, line);
      if (!is_known(c, residues.variance.data() + k * residues.columns, r * own, own)) continue;
      out[r].share = std::max(out[r].share, modulus(basis, c, r * own, own, line) / other_moduli(basis, c, r, line));
    }
  }
  return out;
}

}  // namespace jointid::modalfit
