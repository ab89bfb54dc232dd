#include "records/estimate/several_forces.hpp"

#include <algorithm>
#include <cmath>

#include "base/eigen.hpp"
#include "dense/minimum_norm.hpp"
#include "frf/set/frf_set.hpp"
#include "records/estimate/residual_factor.hpp"

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

/// With `pairs` or the rows of a factor of a rank.
void append_unknown(std::size_t responses, std::size_t pairs, std::size_t rank, SeveralEstimates& out) {
  for (Estimate& of : out.of_force) {
    of.frf.insert(of.frf.end(), responses, unknown);
    of.coherence.insert(of.coherence.end(), responses, nan);
    of.variance.insert(of.variance.end(), responses, unknown);
    of.covariance.insert(of.covariance.end(), pairs, unknown);
    of.factor.insert(of.factor.end(), responses * rank, unknown);
  }
  const std::size_t forces = out.of_force.size();
  out.reference_correlation.insert(out.reference_correlation.end(), forces * forces, unknown);
}

void append_correlation(const Eigen::MatrixXcd& inverse, std::vector<Complex>& out) {
  for (Eigen::Index c = 0; c < inverse.rows(); ++c) {
    for (Eigen::Index d = 0; d < inverse.cols(); ++d) {
      out.push_back(c == d ? 1.0 : inverse(d, c) / std::sqrt(inverse(c, c).real() * inverse(d, d).real()));
    }
  }
}

/// Variances of E Eᴴ times a factor.
void append_variances(const Eigen::VectorXd& residual, double factor, Estimate& out) {
  for (const double square : residual) out.variance.push_back(0.5 * factor * square * Complex{1.0, 1.0});
}

/// The covariances.
void append_pairs(const Eigen::MatrixXcd& residual, double factor, Estimate& out) {
  for (Eigen::Index r = 0; r < residual.rows(); ++r) {
    for (Eigen::Index s = 0; s <= r; ++s) out.covariance.push_back(factor * residual(r, s));
    out.covariance.back() = factor * residual(r, r).real();
  }
}

}  // namespace

SeveralEstimates estimate(const SeveralForces& spectra, double effective, CovarianceForm form) {
  const bool pairs = form == CovarianceForm::pairs;
  const std::size_t rank = pairs ? 0 : spectra.count - std::min(spectra.count, spectra.forces);
  SeveralEstimates out{std::vector<Estimate>(spectra.forces), {}};
  const double freedom = effective - static_cast<double>(spectra.forces);
  for (std::size_t line = 0; line < spectra.lines; ++line) {
    const Eigen::MatrixXcd x = line_of(spectra.motion, spectra.responses, spectra.count, spectra.lines, line);
    Eigen::MatrixXcd f = line_of(spectra.force, spectra.forces, spectra.count, spectra.lines, line);
    const Eigen::VectorXd size = f.rowwise().norm();
    if (!(size.minCoeff() > 0.0)) {
      append_unknown(spectra.responses, pairs ? frf::pair_count(spectra.responses) : 0, rank, out);
      continue;
    }
    f = size.cwiseInverse().asDiagonal() * f;
    const dense::ComplexMinimumNorm auto_spectra(f * f.adjoint(), dependent);
    if (auto_spectra.rank() < f.rows()) {
      append_unknown(spectra.responses, pairs ? frf::pair_count(spectra.responses) : 0, rank, out);
      continue;
    }
    const Eigen::MatrixXcd inverse = auto_spectra.pseudo_inverse();
    const Eigen::MatrixXcd h = x * f.adjoint() * inverse, e = x - h * f;
    const Eigen::MatrixXcd residual = pairs ? Eigen::MatrixXcd(e * e.adjoint()) : Eigen::MatrixXcd();
    const Eigen::MatrixXcd factor = pairs ? Eigen::MatrixXcd() : Eigen::MatrixXcd(residual_factor(e, f).transpose());
    const Eigen::VectorXd squares = e.rowwise().squaredNorm();
    append_correlation(inverse, out.reference_correlation);
    for (std::size_t c = 0; c < spectra.forces; ++c) {
      Estimate& of = out.of_force[c];
      const double scale = 1.0 / size(at(c));
      for (std::size_t r = 0; r < spectra.responses; ++r) {
        const double left = squares[at(r)] / x.row(at(r)).squaredNorm();
        of.frf.push_back(scale * h(at(r), at(c)));
        of.coherence.push_back(freedom > 0.0 ? 1.0 - left : nan);
      }
      const double size_of_error = freedom > 0.0 ? scale * scale * inverse(at(c), at(c)).real() / freedom : nan;
      append_variances(squares, size_of_error, of);
      if (pairs) append_pairs(residual, size_of_error, of);
      for (const Complex& value : factor.reshaped()) of.factor.push_back(std::sqrt(size_of_error) * value);
    }
  }
  return out;
}

}  // namespace jointid::records
