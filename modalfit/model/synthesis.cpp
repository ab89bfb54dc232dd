#include "modalfit/model/synthesis.hpp"

#include <tbb/parallel_for.h>

#include <cmath>

#include "base/complex.hpp"
#include "base/statistics.hpp"
#include "modalfit/band/basis.hpp"

namespace jointid::modalfit {
namespace {

constexpr double cancelled = 0.1;
constexpr double most_noise = 0.1;  ///< of the model: beyond it the difference is noise, 0.6 dB rms and more
/// With fewer lines what is taken for their noise may be what the model misses.
constexpr std::size_t lines_for_noise = 400;

/// Lines of the header inside a range.
struct Lines {
  std::vector<std::size_t> index;
  std::vector<double> frequency_hz;

  Lines(const frf::FrfHeader& header, const std::array<double, 2>& range) {
    for (std::size_t i = 0; i < header.lines(); ++i) {
      const double f = header.frequency_hz[i];
      if (f < range[0] || f > range[1] || f == 0.0) continue;
      index.push_back(i);
      frequency_hz.push_back(f);
    }
  }
};

frf::FrfSet empty_set(frf::FrfHeader header) {
  header.noise = frf::NoiseRecord::variance;
  header.averages = 0.0;
  header.repeats = 0;
  const std::size_t size = header.lines() * header.entries();
  return {std::move(header), std::vector<Complex>(size, {nan, nan}), std::vector<Complex>(size, {nan, nan}), {}};
}

Complex squares(Complex value, double variance) {
  return {value.real() * value.real() * variance, value.imag() * value.imag() * variance};
}

/// What all FRFs of a symmetric model share.
struct ModelValues {
  const SymmetricModel& model;
  Basis basis;
  std::vector<std::vector<double>> variance;  ///< [mode][n] of the shape

  ModelValues(const SymmetricModel& of, Basis at_lines) : model(of), basis(std::move(at_lines)) {
    for (const SymmetricMode& mode : model.modes) {
      variance.emplace_back();
      for (std::size_t i = 0; i < model.dofs.size(); ++i) variance.back().push_back(mode.covariance.variance(i));
    }
  }
};

/// One FRF of a symmetric model.
class EntryModel {
 public:
  EntryModel(const ModelValues& values, std::size_t a, std::size_t b)
      : basis_(values.basis), terms_(values.model.residuals.between(a, b)) {
    const double scale = residue_scale(values.model.kind, values.model.scale_hz);
    for (std::size_t r = 0; r < values.model.modes.size(); ++r) {
      const SymmetricMode& mode = values.model.modes[r];
      const Complex pa = mode.shape[a], pb = mode.shape[b];
      const double variance = std::norm(pb) * values.variance[r][a] + std::norm(pa) * values.variance[r][b] +
                              2.0 * (pb * std::conj(pa) * mode.covariance.between(a, b)).real();
      residues_.push_back(pa * pb / scale);
      variances_.push_back(variance / (scale * scale * static_cast<double>(basis_.per_mode)));
      poles_.push_back(mode.pole_covariance);
    }
  }

  void evaluate(std::size_t line, double frequency_hz, double sign, Complex& value, Complex& variance) const {
    const double omega = angular(frequency_hz);
    value = terms_.upper - terms_.lower / (omega * omega);
    variance = residual_variance(omega);
    for (std::size_t r = 0; r < residues_.size(); ++r) {
      Complex by_pole[2] = {};
      for (std::size_t own = 0; own < basis_.per_mode; ++own) {
        const Complex column = basis_.column(r * basis_.per_mode + own)[line];
        const double coefficient = own == 0 ? residues_[r].real() : residues_[r].imag();
        value += coefficient * column;
        variance += squares(column, variances_[r]);
        for (std::size_t k = 0; k < 2; ++k) by_pole[k] += coefficient * basis_.derivative(r, k, own)[line];
      }
      const auto& c = poles_[r];
      const auto form = [&](double x, double y) { return x * x * c[0] + 2.0 * x * y * c[1] + y * y * c[3]; };
      variance += Complex(form(by_pole[0].real(), by_pole[1].real()), form(by_pole[0].imag(), by_pole[1].imag()));
    }
    value *= sign;
  }

 private:
  Complex residual_variance(double omega) const {
    const double g = -1.0 / (omega * omega);
    const auto& c = terms_.covariance;  // Re L, Im L, Re U, Im U
    const auto part = [&](std::size_t l, std::size_t u) { return g * g * c[l * 4 + l] + 2.0 * g * c[l * 4 + u] + c[u * 4 + u]; };
    return {part(0, 2), part(1, 3)};
  }

  const Basis& basis_;
  ResidualTerms terms_;
  std::vector<Complex> residues_;
  std::vector<double> variances_;
  std::vector<std::array<double, 4>> poles_;
};

/// Whether the noise of a line says more of its deviation than the model.
bool is_noise(const Band& band, std::size_t entry, std::size_t line, double model) {
  if (!band.known_noise && band.lines() < lines_for_noise) return false;
  const double* weight = band.weights(entry) + 2 * line;
  return weight[0] > 0.0 && weight[1] > 0.0 && std::hypot(1.0 / weight[0], 1.0 / weight[1]) > most_noise * model;
}

std::vector<Pole> poles_of(const SymmetricModel& model) {
  std::vector<Pole> poles;
  for (const SymmetricMode& mode : model.modes) poles.push_back(mode.pole);
  return poles;
}

std::vector<std::size_t> found(const SymmetricModel& model, const std::vector<frf::Dof>& dofs) {
  std::vector<std::size_t> out;
  for (const frf::Dof& dof : dofs) out.push_back(model.find(dof));
  return out;
}

}  // namespace

frf::FrfSet regenerate(const SymmetricModel& model, frf::FrfHeader header) {
  frf::FrfSet out = empty_set(std::move(header));
  const Lines lines(out.header, model.range_hz);
  const ModelValues values(model, make_basis(model.kind, poles_of(model), lines.frequency_hz, model.scale_hz, true));
  const std::vector<std::size_t> rows = found(model, out.header.response), columns = found(model, out.header.reference);
  tbb::parallel_for(std::size_t{0}, out.header.entries(), [&](std::size_t e) {
    const std::size_t r = e / columns.size(), c = e % columns.size();
    if (rows[r] == frf::npos || columns[c] == frf::npos) return;
    const EntryModel entry(values, rows[r], columns[c]);
    const double sign = out.header.response[r].sign * out.header.reference[c].sign;
    for (std::size_t i = 0; i < lines.index.size(); ++i) {
      const std::size_t at = lines.index[i] * out.header.entries() + e;
      entry.evaluate(i, lines.frequency_hz[i], sign, out.values[at], out.variance[at]);
    }
  });
  return out;
}

frf::FrfSet regenerate(const ModalFit& fit, frf::FrfHeader header, const std::array<double, 2>& range_hz) {
  frf::FrfSet out = empty_set(std::move(header));
  const Lines lines(out.header, range_hz);
  const Basis basis = make_basis(fit.kind, fit.poles(), lines.frequency_hz, fit.scale_hz, false);
  const double unit = fit.residues.unit;
  tbb::parallel_for(std::size_t{0}, out.header.entries(), [&](std::size_t e) {
    if (fit.residues.freedom[e] <= 0.0) return;
    for (std::size_t i = 0; i < lines.index.size(); ++i) {
      Complex value = 0.0, variance = 0.0;
      for (std::size_t j = 0; j < basis.size(); ++j) {
        value += fit.residues.coefficients[e * basis.size() + j] * basis.column(j)[i];
        variance += squares(basis.column(j)[i], fit.residues.variance[e * basis.size() + j]);
      }
      out.values[lines.index[i] * out.header.entries() + e] = value * unit;
      out.variance[lines.index[i] * out.header.entries() + e] = variance * unit * unit;
    }
  });
  return out;
}

std::vector<SynthesisError> synthesis_errors(const ModalFit& fit, const Band& band, const frf::FrfSet& regenerated) {
  const Basis basis = make_basis(fit.kind, fit.poles(), band.frequency_hz, fit.scale_hz, false);
  std::vector<SynthesisError> out(band.entries());
  tbb::parallel_for(std::size_t{0}, band.entries(), [&](std::size_t e) {
    SynthesisError& error = out[e];
    double all = 0.0, away = 0.0;
    for (std::size_t i = 0; i < band.lines(); ++i) {
      const Complex measured = band.value(e)[i], model = regenerated.values[i * band.entries() + e];
      if (measured == 0.0 || std::isnan(model.real())) continue;
      double moduli = 0.0;
      for (std::size_t j = 0; j < basis.size(); ++j)
        moduli += std::abs(fit.residues.coefficients[e * basis.size() + j] * basis.column(j)[i]);
      const double db = 20.0 * std::log10(std::abs(model) / std::abs(measured));
      all += db * db;
      ++error.lines;
      if (std::abs(model) < cancelled * moduli * fit.residues.unit || is_noise(band, e, i, std::abs(model))) continue;
      away += db * db;
      ++error.lines_away;
    }
    error.rms_db = std::sqrt(all / static_cast<double>(error.lines));
    error.rms_db_away = std::sqrt(away / static_cast<double>(error.lines_away));
  });
  return out;
}

SynthesisError overall(const std::vector<SynthesisError>& errors) {
  SynthesisError out;
  double all = 0.0, away = 0.0;
  for (const SynthesisError& error : errors) {
    if (error.lines > 0) all += error.rms_db * error.rms_db * static_cast<double>(error.lines);
    if (error.lines_away > 0) away += error.rms_db_away * error.rms_db_away * static_cast<double>(error.lines_away);
    out.lines += error.lines;
    out.lines_away += error.lines_away;
  }
  out.rms_db = std::sqrt(all / static_cast<double>(out.lines));
  out.rms_db_away = std::sqrt(away / static_cast<double>(out.lines_away));
  return out;
}

}  // namespace jointid::modalfit
