#include "gui/look/whole_share.hpp"

#include <algorithm>

namespace jointid::gui {

void WholeShare::begin(const JobStep& step) {
  step_ = step;
  has_steps_ = true;
  pass_ = 0;
  last_ = 0.0;
  stage_.clear();
  whole_ = std::max(whole_, step.begin);
}

JobShare WholeShare::note(const QString& stage, double share) {
  if (!has_steps_) return {stage, share};
  if (pass_ == 0 || stage != stage_ || share < last_) ++pass_;
  stage_ = stage;
  last_ = share;
  const auto done = static_cast<double>(pass_ - 1) + std::clamp(share, 0.0, 1.0);
  const double inner = done / static_cast<double>(std::max(pass_, step_.passes));
  whole_ = std::max(whole_, step_.begin + (step_.end - step_.begin) * inner);
  const bool counts_passes = step_.of == 1 && step_.passes > 1;
  return {stage, whole_, counts_passes ? pass_ : step_.number, counts_passes ? std::max(pass_, step_.passes) : step_.of, true};
}

}  // namespace jointid::gui
