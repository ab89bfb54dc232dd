#pragma once

#include <rapidcheck.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "friction/law.hpp"

namespace jointid::friction {

/// 0 … count − 1, whatever RapidCheck's size of the moment.
inline std::size_t any_of(std::size_t count) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<std::size_t>(0, count));
}

/// Uniform in [lower, upper].
inline double any_in(double lower, double upper) {
  return lower + (upper - lower) * static_cast<double>(any_of(1'000'001)) / 1e6;
}

inline double any_decade(double lower, double upper) { return std::pow(10.0, any_in(std::log10(lower), std::log10(upper))); }

/// Values with slip displacements between 1e-8 and 1e-6 m and stiffnesses between 1e6 and 1e8 N/m.
inline std::vector<double> any_values(const std::string& law) {
  const double slip = any_decade(1e-8, 1e-6), stiffness = any_decade(1e6, 1e8);
  if (law == "ren") return {slip, any_in(0.01, 6.0), stiffness};
  if (law == "shoukry") return {stiffness * slip, 1.0 / slip};
  if (law == "burdekin") return {stiffness, -0.5 * stiffness / slip};
  if (law == "spring") return {stiffness};
  return {slip, stiffness};
}

inline std::string any_law() {
  const auto all = laws();
  return std::string(all[any_of(all.size())].name);
}

/// A displacement of the order of the slip displacement of `element`, from far below to far above.
inline double any_displacement(const Element& element) {
  const std::vector<double> kinks = element.kinks();
  const double scale = kinks.empty() ? 1e-7 : kinks[any_of(kinks.size())];
  return scale * any_decade(1e-2, 30.0);
}

inline std::unique_ptr<Element> any_element() {
  const std::string law = any_law();
  return make_element(law, any_values(law));
}

}  // namespace jointid::friction
