#include "frf/noise/turned_points.hpp"

#include <cmath>

namespace jointid::frf {

TurnedPoints::TurnedPoints(const FrfHeader& header) : entries_(header.entries()) {
  for (std::size_t r = 0; r < header.response.size(); ++r) {
    for (std::size_t c = 0; c < header.reference.size(); ++c) {
      const Dof &response = header.response[r], &reference = header.reference[c];
      if (coordinate_key(response) == coordinate_key(reference))
        points_.push_back({r * header.reference.size() + c, response, static_cast<double>(response.sign * reference.sign)});
    }
  }
}

void TurnedPoints::add(std::span<const Complex> values) {
  for (Point& point : points_) {
    for (std::size_t at = point.entry; at < values.size(); at += entries_) {
      const double part = point.sign * values[at].imag();
      if (std::isfinite(part)) (part > 0.0 ? point.above : point.below) += std::abs(part);
    }
  }
}

std::vector<Dof> TurnedPoints::found() const {
  constexpr double far_more = 100.0;
  std::vector<Dof> out;
  for (const Point& point : points_) {
    if (point.above > far_more * point.below) out.push_back(point.dof);
  }
  return out;
}

std::string turned_points_text(const std::vector<Dof>& found) {
  if (found.empty()) return {};
  return "The driving point" + std::string(found.size() > 1 ? "s " : " ") + found.front().name() +
         (found.size() > 1 ? " and " + std::to_string(found.size() - 1) + " more are" : " is") +
         " not passive: the imaginary part of the receptance is above 0. Either the FRFs are conjugates (of exp(-iωt)), or force "
         "and motion are positive in opposite directions. Export FRFs of exp(+iωt), or give one of the two the other sign.";
}

}  // namespace jointid::frf
