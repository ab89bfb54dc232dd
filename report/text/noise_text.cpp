#include "report/text/noise_text.hpp"

#include <fmt/format.h>

namespace jointid::report {

std::string noise_text(const std::optional<ident::NoiseSection>& noise) {
  if (!noise) return "hammer, coherences and averages of the files";
  const frf::NoiseModel& model = noise->frf_model;
  std::string text = noise->model;
  if (noise->model == "hammer") {
    text += fmt::format(", coherence {:g}, {} averages", model.coherence, model.averages);
  } else {
    text += fmt::format(", level {:g}", noise->level);
  }
  if (noise->model == "modal") return text;
  if (model.floor > 0.0) text += fmt::format(", floor {:g}", model.floor);
  if (model.gross.share > 0.0) {
    text += fmt::format(", gross errors {:g} times as large on {:g} %", model.gross.factor, 100.0 * model.gross.share);
  }
  if (model.sign_errors > 0.0) text += fmt::format(", sign errors {:g} %", 100.0 * model.sign_errors);
  if (model.position_errors > 0.0) text += fmt::format(", position errors {:g} m", model.position_errors);
  if (!model.reciprocal) text += ", not reciprocal";
  return text;
}

}  // namespace jointid::report
