#include "gui/modal/picked_poles.hpp"

#include <algorithm>
#include <cmath>

namespace jointid::gui {

void PickedPoles::begin() {
  steps_ = {std::nullopt};
  now_ = 0;
}

void PickedPoles::pick(std::vector<modalfit::Pole> poles) {
  steps_.resize(now_ + 1);
  steps_.emplace_back(std::move(poles));
  ++now_;
}

void PickedPoles::undo() {
  if (can_undo()) --now_;
}

void PickedPoles::redo() {
  if (can_redo()) ++now_;
}

std::vector<modalfit::Pole> with_pole(std::vector<modalfit::Pole> poles, const modalfit::ModelKind& kind,
                                      const modalfit::CandidatePole& pole) {
  poles.push_back({pole.frequency_hz, modalfit::damping_per_zeta(kind) * pole.damping});
  std::ranges::sort(poles, {}, &modalfit::Pole::frequency_hz);
  return poles;
}

std::vector<modalfit::Pole> without_pole(std::vector<modalfit::Pole> poles, double frequency_hz) {
  const auto nearest =
      std::ranges::min_element(poles, {}, [&](const modalfit::Pole& pole) { return std::abs(pole.frequency_hz - frequency_hz); });
  if (nearest != poles.end()) poles.erase(nearest);
  return poles;
}

}  // namespace jointid::gui
