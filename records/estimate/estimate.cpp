#include "records/estimate/estimate.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "base/eigen.hpp"
#include "base/error.hpp"
#include "frf/set/frf_set.hpp"
#include "records/estimate/residual_factor.hpp"

namespace jointid::records {
namespace {

std::string lower(std::string_view text) {
  std::string out(text);
  std::ranges::transform(out, out.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return out;
}

/// One line of all blows.
class Line {
 public:
  Line(const Spectra& spectra, std::size_t line) : spectra_(spectra), line_(line) {
    for (std::size_t h = 0; h < spectra.count; ++h) force_ += std::norm(spectra.force_at(h, line));
    for (std::size_t r = 0; r < spectra.responses; ++r) {
      Complex cross = 0.0;
      double motion = 0.0;
      for (std::size_t h = 0; h < spectra.count; ++h) {
        cross += spectra.motion_at(h, r, line) * std::conj(spectra.force_at(h, line));
        motion += std::norm(spectra.motion_at(h, r, line));
      }
      cross_.push_back(cross);
      motion_.push_back(motion);
    }
  }

  bool excited() const { return force_ > 0.0; }

  Complex frf(Estimator estimator, std::size_t r) const {
    if (!excited()) return unknown;
    const Complex h1 = cross_[r] / force_;
    if (estimator == Estimator::h1) return h1;
    const double size = std::abs(cross_[r]);
    if (!(size > 0.0)) return unknown;
    if (estimator == Estimator::h2) return motion_[r] / std::conj(cross_[r]);
    return std::sqrt(motion_[r] / force_) * (cross_[r] / size);
  }

  double coherence(std::size_t r) const { return std::norm(cross_[r]) / (force_ * motion_[r]); }

  /// √C's columns, one a blow: C_rs = Σ_h a_rh a_sh*.
  std::vector<Complex> residuals(Estimator estimator, double effective, std::size_t r) const {
    const Complex h1 = frf(Estimator::h1, r);
    const Complex scale = (estimator == Estimator::h1 ? 1.0 : frf(estimator, r) / h1) / std::sqrt(force_ * (effective - 1.0));
    std::vector<Complex> out;
    for (std::size_t h = 0; h < spectra_.count; ++h) {
      out.push_back(scale * (spectra_.motion_at(h, r, line_) - h1 * spectra_.force_at(h, line_)));
    }
    return out;
  }

  std::vector<Complex> scatter(Estimator estimator, double effective, std::size_t r) const {
    const Complex h1 = frf(Estimator::h1, r), h2 = frf(Estimator::h2, r), own = frf(estimator, r);
    const double scale = std::sqrt((static_cast<double>(spectra_.count) - 1.0) / (effective - 1.0));
    std::vector<Complex> out;
    for (std::size_t h = 0; h < spectra_.count; ++h) {
      const Complex f = spectra_.force_at(h, line_), x = spectra_.motion_at(h, r, line_);
      const Complex u1 = std::conj(f) * (x - h1 * f) / force_ / std::sqrt(1.0 - std::norm(f) / force_);
      if (estimator == Estimator::h1) {
        out.push_back(scale * u1);
        continue;
      }
      const Complex u2 = std::conj(x) * (x - h2 * f) / std::conj(cross_[r]) / std::sqrt(1.0 - std::norm(x) / motion_[r]);
      out.push_back(scale * (estimator == Estimator::h2 ? u2 : 0.5 * own * (u1 / h1 + u2 / h2)));
    }
    return out;
  }

  /// Directions d with Σ_h a_rh d_h* = 0 for all r, [n − factor_rank(), n].
  Eigen::MatrixXcd directions(Estimator estimator, NoiseFrom noise) const {
    const std::size_t count = spectra_.count;
    Eigen::MatrixXcd out(at(count - factor_rank(count, estimator, noise)), at(count));
    for (std::size_t h = 0; h < count && out.rows() > 0; ++h) {
      const Complex f = spectra_.force_at(h, line_);
      out(0, at(h)) = noise == NoiseFrom::residuals ? f : std::sqrt(1.0 - std::norm(f) / force_);
    }
    return out;
  }

 private:
  const Spectra& spectra_;
  std::size_t line_;
  double force_ = 0.0;
  std::vector<Complex> cross_;
  std::vector<double> motion_;
};

/// Variances of real and imaginary part.
Complex variance_of(const std::vector<Complex>& errors, NoiseFrom noise) {
  double re = 0.0, im = 0.0;
  for (const Complex& e : errors) {
    re += e.real() * e.real();
    im += e.imag() * e.imag();
  }
  return noise == NoiseFrom::scatter ? Complex{re, im} : Complex{0.5 * (re + im), 0.5 * (re + im)};
}

/// What the blows add to the error of each response.
using Errors = std::vector<std::vector<Complex>>;

void add_pairs(const Errors& errors, Estimate& out) {
  for (std::size_t r = 0; r < errors.size(); ++r) {
    for (std::size_t s = 0; s <= r; ++s) {
      Complex sum = 0.0;
      for (std::size_t h = 0; h < errors[r].size(); ++h) sum += errors[r][h] * std::conj(errors[s][h]);
      out.covariance.push_back(r == s ? Complex{sum.real(), 0.0} : sum);
    }
  }
}

void add_factor(const Errors& errors, const Eigen::MatrixXcd& directions, Estimate& out) {
  Eigen::MatrixXcd rows(at(errors.size()), directions.cols());
  for (std::size_t r = 0; r < errors.size(); ++r) {
    for (std::size_t h = 0; h < errors[r].size(); ++h) rows(at(r), at(h)) = errors[r][h];
  }
  const Eigen::MatrixXcd factor = residual_factor(std::move(rows), directions).transpose();  // rows one after the other
  out.factor.insert(out.factor.end(), factor.data(), factor.data() + factor.size());
}

}  // namespace

Estimator parse_estimator(std::string_view text) {
  return static_cast<Estimator>(find_word(lower(text), {"h1", "h2", "hv"}, "estimator"));
}

std::string name(Estimator estimator) { return estimator == Estimator::h1 ? "H1" : estimator == Estimator::h2 ? "H2" : "Hv"; }

NoiseFrom parse_noise_from(std::string_view text) {
  return static_cast<NoiseFrom>(find_word(lower(text), {"residuals", "scatter"}, "source of variances"));
}

std::size_t factor_rank(std::size_t count, Estimator estimator, NoiseFrom noise) {
  const bool one_less = noise == NoiseFrom::residuals || estimator == Estimator::h1;
  return count - (one_less && count > 0 ? 1 : 0);
}

Estimate estimate(const Spectra& spectra, Estimator estimator, NoiseFrom noise, double effective, CovarianceForm form) {
  Estimate out;
  const auto add_noise = [&](const Line& line) {
    Errors errors;
    for (std::size_t r = 0; r < spectra.responses; ++r) {
      errors.push_back(noise == NoiseFrom::scatter ? line.scatter(estimator, effective, r) : line.residuals(estimator, effective, r));
      out.variance.push_back(variance_of(errors[r], noise));
    }
    form == CovarianceForm::pairs ? add_pairs(errors, out) : add_factor(errors, line.directions(estimator, noise), out);
  };
  const std::size_t rank = factor_rank(spectra.count, estimator, noise);
  const std::size_t pairs = frf::pair_count(spectra.responses);
  for (std::size_t i = 0; i < spectra.lines; ++i) {
    const Line line(spectra, i);
    for (std::size_t r = 0; r < spectra.responses; ++r) {
      out.frf.push_back(line.frf(estimator, r));
      out.coherence.push_back(spectra.count > 1 ? line.coherence(r) : nan);
    }
    if (spectra.count > 1 && effective > 1.0 && line.excited()) {
      add_noise(line);
    } else {
      out.variance.resize(out.variance.size() + spectra.responses, unknown);
      if (form == CovarianceForm::pairs) out.covariance.resize(out.covariance.size() + pairs, unknown);
      if (form == CovarianceForm::factor) out.factor.resize(out.factor.size() + spectra.responses * rank, unknown);
    }
  }
  return out;
}

}  // namespace jointid::records
