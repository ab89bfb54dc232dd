#include "frf/noise/variance_law.hpp"

#include "frf/set/h1.hpp"

namespace jointid::frf {

VarianceLaw variance_law(const NoiseModel& model, double mean_square) {
  VarianceLaw law{.proportional = 0.5 * model.level * model.level,
                  .constant = model.floor > 0.0 ? 0.5 * model.floor * model.floor * mean_square : 0.0,
                  .by_part = false};
  if (model.kind == NoiseKind::hammer) law.proportional = 0.5 * h1_variance(1.0, model.coherence, model.averages);
  if (model.kind == NoiseKind::uniform || model.kind == NoiseKind::gaussian) {
    law.proportional = model.level * model.level / 3.0;
    law.by_part = true;
  }
  return law;
}

double squared_factor(Quantity quantity, double frequency_hz) { return std::norm(to_receptance(quantity, frequency_hz)); }

}  // namespace jointid::frf
