#include "friction/law/laws.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "base/error.hpp"
#include "base/text.hpp"
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
  const auto found = std::ranges::find(laws(), name, &Law::name);
  if (found != laws().end()) return *found;
  refuse("no friction law '" + std::string(name) + "'; valid: " + comma_list(laws(), &Law::name));
}

std::unique_ptr<Element> make_element(std::string_view name, std::span<const double> values) {
  return make(Elements(), law(name).name, values);
}

}  // namespace jointid::friction
