#include "friction/law.hpp"

#include <array>
#include <cmath>
#include <stdexcept>

#include "friction/bilinear.hpp"
#include "friction/burdekin.hpp"
#include "friction/iwan.hpp"
#include "friction/ren.hpp"
#include "friction/shoukry.hpp"
#include "friction/spring.hpp"

namespace jointid::friction {
namespace {

template <class... E>
struct List {};
using Elements = List<Ren, Shoukry, Burdekin, Bilinear, Iwan, Spring>;

template <class... E>
std::span<const Law> laws_of(List<E...>) {
  static const std::array list = {E::law...};
  return list;
}

template <class... E>
std::unique_ptr<Element> make(List<E...>, std::string_view name, std::span<const double> values) {
  std::unique_ptr<Element> made;
  ((E::law.name == name && (made = std::make_unique<E>(values))) || ...);
  return made;
}

bool inside(const LawParameter& parameter, double value) {
  const bool above = parameter.lower_included ? value >= parameter.lower : value > parameter.lower;
  return std::isfinite(value) && above && value < parameter.upper;
}

std::string bounds(const LawParameter& parameter) {
  std::string text;
  if (std::isfinite(parameter.lower)) text = (parameter.lower_included ? ">= " : "> ") + std::to_string(parameter.lower);
  if (std::isfinite(parameter.upper)) text += (text.empty() ? "< " : " and < ") + std::to_string(parameter.upper);
  return text;
}

}  // namespace

std::span<const Law> laws() { return laws_of(Elements()); }

const Law& law(std::string_view name) {
  std::string valid;
  for (const Law& each : laws()) {
    if (each.name == name) return each;
    valid += (valid.empty() ? "" : ", ") + std::string(each.name);
  }
  throw std::invalid_argument("no friction law '" + std::string(name) + "'; valid: " + valid);
}

std::unique_ptr<Element> make_element(std::string_view name, std::span<const double> values) {
  return make(Elements(), law(name).name, values);
}

void check_values(const Law& law, std::span<const double> values) {
  const std::string name(law.name);
  if (values.size() != law.parameters.size()) {
    throw std::invalid_argument(name + ": " + std::to_string(values.size()) + " values for " +
                                std::to_string(law.parameters.size()) + " parameters");
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    const LawParameter& parameter = law.parameters[i];
    if (inside(parameter, values[i])) continue;
    throw std::invalid_argument(name + ": " + std::string(parameter.name) + " = " + std::to_string(values[i]) + " " +
                                std::string(parameter.unit) + " must be finite and " + bounds(parameter));
  }
}

std::vector<Parameter> with_values(const Law& law, std::span<const double> values) {
  std::vector<Parameter> result;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const LawParameter& p = law.parameters[i];
    result.push_back({std::string(p.name), std::string(p.unit), values[i], p.lower, p.upper, p.lower_included});
  }
  return result;
}

}  // namespace jointid::friction
