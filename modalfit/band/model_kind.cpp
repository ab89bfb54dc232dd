#include "modalfit/band/model_kind.hpp"

#include <array>

#include "base/error.hpp"

namespace jointid::modalfit {

std::string name(Damping damping) { return damping == Damping::viscous ? "viscous" : "hysteretic"; }

double damping_per_zeta(const ModelKind& kind) { return kind.damping == Damping::hysteretic ? 2.0 : 1.0; }

Damping parse_damping(std::string_view text) {
  for (const Damping damping : {Damping::viscous, Damping::hysteretic}) {
    if (text == name(damping)) return damping;
  }
  const std::string near = nearest_word(std::string(text), std::array{name(Damping::viscous), name(Damping::hysteretic)});
  throw InputError({.kind = ErrorKind::usage,
                    .file = {},
                    .place = "damping",
                    .problem = "'" + std::string(text) + "' is no damping model",
                    .remedy = near.empty() ? "use viscous or hysteretic" : "did you mean " + near + "?"});
}

}  // namespace jointid::modalfit
