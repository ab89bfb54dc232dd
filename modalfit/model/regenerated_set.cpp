#include "modalfit/model/regenerated_set.hpp"

#include <fmt/format.h>

#include <cmath>

#include "modalfit/model/symmetric_model.hpp"

namespace jointid::modalfit {
namespace {

constexpr double most_db = 1.0;
constexpr double most_misfit = 2.0;

double mean_square(const Band& band, const frf::FrfSet& regenerated) {
  double sum = 0.0, count = 0.0;
  for (std::size_t e = 0; e < band.entries(); ++e) {
    for (std::size_t i = 0; i < band.lines(); ++i) {
      const double* weight = band.weights(e) + 2 * i;
      if (weight[0] == 0.0) continue;
      const auto rest = band.value(e)[i] - regenerated.values[i * band.entries() + e];
      sum += 0.5 * (std::pow(weight[0] * rest.real(), 2.0) + std::pow(weight[1] * rest.imag(), 2.0));
      count += 1.0;
    }
  }
  return sum / count;
}

std::string harm_of(const RegeneratedSet& set, const ModalFit& fit) {
  if (!is_usable(fit.status)) return fit.message;
  if (set.error.rms_db_away > most_db) {
    return fmt::format("the modal model of {} modes is {:.2g} dB off away from antiresonances", set.modes, set.error.rms_db_away);
  }
  if (set.misfit > most_misfit) {
    return fmt::format("the modal model of {} modes deviates by {:.2g} times the noise of the FRFs", set.modes, std::sqrt(set.misfit));
  }
  return {};
}

}  // namespace

RegeneratedSet regenerate_set(const frf::FrfSet& measured, const FitOptions& options) {
  Band band = make_band(measured, options.range_hz);
  const ModalFit found = fit(band, measured.header, options);
  RegeneratedSet out{.set = measured, .modes = found.modes_inside(), .error = {}, .misfit = 0.0, .harm = {}};
  if (found.status == Status::no_modes) {
    out.harm = found.message;
    return out;
  }
  const std::array range = {band.frequency_hz.front(), band.frequency_hz.back()};
  frf::FrfHeader lines = measured.header;
  lines.frequency_hz = band.frequency_hz;
  const bool symmetric = obstacle(found).empty();
  const SymmetricModel model = symmetric ? make_symmetric(found, band) : SymmetricModel{};
  const auto on = [&](const frf::FrfHeader& header) { return symmetric ? regenerate(model, header) : regenerate(found, header, range); };
  const frf::FrfSet fitted = on(lines);
  out.error = overall(synthesis_errors(found, band, fitted));
  out.misfit = mean_square(band, fitted);
  out.harm = harm_of(out, found);
  out.set = on(measured.header);
  return out;
}

}  // namespace jointid::modalfit
