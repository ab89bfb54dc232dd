#include "friction/law/laws.hpp"

#include <array>
#include <stdexcept>
#include <string>

#include "friction/law/bilinear.hpp"
#include "friction/law/burdekin.hpp"
#include "friction/law/iwan.hpp"
#include "friction/law/ren.hpp"
#include "friction/law/shoukry.hpp"
#include "friction/law/spring.hpp"

namespace jointid::friction {
namespace {

template <class... E>
struct List {};

/// The one place that names them all.
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

}  // namespace jointid::friction
