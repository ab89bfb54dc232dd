#include "modalfit/model/modal_fit.hpp"

#include <algorithm>

namespace jointid::modalfit {

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
