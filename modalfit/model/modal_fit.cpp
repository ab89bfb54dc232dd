#include "modalfit/model/modal_fit.hpp"

#include <algorithm>

namespace jointid::modalfit {

std::string name(FitStatus status) {
  switch (status) {
    case FitStatus::no_modes: return "no_modes";
    case FitStatus::not_converged: return "not_converged";
    case FitStatus::doubtful: return "doubtful";
    case FitStatus::poor_fit: return "poor_fit";
    default: return "ok";
  }
}

bool is_usable(FitStatus status) { return status == FitStatus::ok || status == FitStatus::doubtful; }

std::vector<Pole> ModalFit::poles() const {
  std::vector<Pole> poles;
  for (const Mode& mode : modes) poles.push_back(mode.pole);
  return poles;
}

std::size_t ModalFit::modes_inside() const {
  return static_cast<std::size_t>(std::ranges::count(modes, true, &Mode::inside));
}

bool is_inside(const Pole& pole, const Band& band) {
  return pole.frequency_hz >= band.frequency_hz.front() && pole.frequency_hz <= band.frequency_hz.back();
}

}  // namespace jointid::modalfit
