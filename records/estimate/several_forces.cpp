#include "records/estimate/several_forces.hpp"

#include <cmath>

#include "base/eigen.hpp"
#include "dense/minimum_norm.hpp"
#include "frf/set/frf_set.hpp"

namespace jointid::records {
namespace {

constexpr double dependent = 1e-10;

/// Line `line` of spectra [n, rows, F] as [rows, n].
Eigen::MatrixXcd line_of(const std::vector<Complex>& spectra, std::size_t rows, std::size_t count, std::size_t lines,
                         std::size_t line) {
  Eigen::MatrixXcd out(at(rows), at(count));
  for (std::size_t h = 0; h < count; ++h) {
    for (std::size_t r = 0; r < rows; ++r) out(at(r), at(h)) = spectra[(h * rows + r) * lines + line];
  }
  return out;
}

void append_unknown(std::size_t responses, std::vector<Estimate>& out) {
  for (Estimate& of : out) {
    of.frf.insert(of.frf.end(), responses, unknown);
    of.coherence.insert(of.coherence.end(), responses, nan);
    of.variance.insert(of.variance.end(), responses, unknown);
    of.covariance.insert(of.covariance.end(), frf::pair_count(responses), unknown);
  }
}

/// Variances and covariances of E Eᴴ times a factor.
void append_noise(const Eigen::MatrixXcd& residual, double factor, Estimate& out) {
  for (Eigen::Index r = 0; r < residual.rows(); ++r) {
    for (Eigen::Index s = 0; s <= r; ++s) out.covariance.push_back(factor * residual(r, s));
    out.covariance.back() = factor * residual(r, r).real();
    out.variance.push_back(0.5 * factor * residual(r, r).real() * Complex{1.0, 1.0});
  }
}

}  // namespace

std::vector<Estimate> estimate(const SeveralForces& spectra, double effective) {
  std::vector<Estimate> out(spectra.forces);
  const double freedom = effective - static_cast<double>(spectra.forces);
  for (std::size_t line = 0; line < spectra.lines; ++line) {
    const Eigen::MatrixXcd x = line_of(spectra.motion, spectra.responses, spectra.count, spectra.lines, line);
    Eigen::MatrixXcd f = line_of(spectra.force, spectra.forces, spectra.count, spectra.lines, line);
    const Eigen::VectorXd size = f.rowwise().norm();
    if (!(size.minCoeff() > 0.0)) {
      append_unknown(spectra.responses, out);
      continue;
    }
    f = size.cwiseInverse().asDiagonal() * f;
    const dense::ComplexMinimumNorm auto_spectra(f * f.adjoint(), dependent);
    if (auto_spectra.rank() < f.rows()) {
      append_unknown(spectra.responses, out);
      continue;
    }
    const Eigen::MatrixXcd inverse = auto_spectra.pseudo_inverse();
    const Eigen::MatrixXcd h = x * f.adjoint() * inverse, e = x - h * f, residual = e * e.adjoint();
    for (std::size_t c = 0; c < spectra.forces; ++c) {
      const double scale = 1.0 / size(at(c));
      for (std::size_t r = 0; r < spectra.responses; ++r) {
        const double left = residual(at(r), at(r)).real() / x.row(at(r)).squaredNorm();
        out[c].frf.push_back(scale * h(at(r), at(c)));
        out[c].coherence.push_back(freedom > 0.0 ? 1.0 - left : nan);
      }
      append_noise(residual, freedom > 0.0 ? scale * scale * inverse(at(c), at(c)).real() / freedom : nan, out[c]);
    }
  }
  return out;
}

}  // namespace jointid::records
