#include "frf/noise/noise_model.hpp"

#include <array>

#include "base/error.hpp"

namespace jointid::frf {
namespace {

constexpr std::array<const char*, 4> kind_names = {"uniform", "gaussian", "circular", "hammer"};

void require(bool holds, const char* place, double value, const char* remedy) {
  if (holds) return;
  throw InputError({.kind = ErrorKind::usage,
                    .file = {},
                    .place = place,
                    .problem = "it is " + std::to_string(value),
                    .remedy = remedy});
}

}  // namespace

std::string name(NoiseKind kind) { return kind_names[static_cast<std::size_t>(kind)]; }

NoiseKind parse_noise_kind(std::string_view text) {
  for (std::size_t i = 0; i < kind_names.size(); ++i) {
    if (text == kind_names[i]) return static_cast<NoiseKind>(i);
  }
  const std::string near = nearest_word(std::string(text), kind_names);
  throw InputError(
      {.kind = ErrorKind::usage,
       .file = {},
       .place = "noise model",
       .problem = "'" + std::string(text) + "' is not a noise model",
       .remedy = near.empty() ? "use uniform, gaussian, circular or hammer" : "did you mean " + near + "?"});
}

void validate(const NoiseModel& model) {
  require(model.floor >= 0.0, "noise floor", model.floor, "floor >= 0 is needed");
  require(model.gross.share >= 0.0 && model.gross.share <= 1.0, "noise gross share", model.gross.share,
          "0 <= share <= 1 is needed");
  require(model.gross.factor >= 0.0, "noise gross factor", model.gross.factor, "factor >= 0 is needed");
  require(model.sign_errors >= 0.0 && model.sign_errors <= 1.0, "noise sign_errors", model.sign_errors,
          "a probability is needed");
  require(model.position_errors >= 0.0, "noise position_errors", model.position_errors, "a length in m is needed");
  if (model.kind != NoiseKind::hammer) {
    require(model.level >= 0.0 && model.level < 1.0, "noise level", model.level, "0 <= level < 1 is needed");
    return;
  }
  require(model.coherence > 0.0 && model.coherence <= 1.0, "noise coherence", model.coherence,
          "0 < coherence <= 1 is needed");
  require(model.averages >= 2, "noise averages", model.averages,
          "one average gives no noise; use 2 or more");
}

}  // namespace jointid::frf
