#include "modalfit/model/modal_fit.hpp"

namespace jointid::modalfit {

bool is_inside(const Pole& pole, const Band& band) {
  return pole.frequency_hz >= band.frequency_hz.front() && pole.frequency_hz <= band.frequency_hz.back();
}

double damping_per_zeta(const ModelKind& kind) { return kind.damping == Damping::hysteretic ? 2.0 : 1.0; }

}  // namespace jointid::modalfit
