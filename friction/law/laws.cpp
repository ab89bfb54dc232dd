#include "friction/law/laws.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <mutex>
#include <string>

#include "base/error.hpp"
#include "base/text.hpp"
#include "friction/law/arrangement.hpp"
#include "friction/law/bar_laws.hpp"
#include "friction/law/bilinear.hpp"
#include "friction/law/burdekin.hpp"
#include "friction/law/iwan.hpp"
#include "friction/law/ren.hpp"
#include "friction/law/shoukry.hpp"
#include "friction/law/slip_laws.hpp"
#include "friction/law/spring.hpp"

namespace jointid::friction {
namespace {

template <class... E>
struct List {};

/// The one place that names them all.
using Elements = List<Ren, Shoukry, Burdekin, Bilinear, Iwan, Spring>;
using NamedElements = List<Power, Square, ExponentialOffset, MenqByDimensions, MenqShape, RootByDimensions, RootShape>;

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

const Law* find_law(std::string_view name) {
  for (const std::span<const Law> list : {laws(), named_laws()}) {
    const auto found = std::ranges::find(list, name, &Law::name);
    if (found != list.end()) return &*found;
  }
  return nullptr;
}

const Law& single_law(std::string_view name) {
  if (const Law* found = find_law(name)) return *found;
  refuse("no friction law '" + std::string(name) + "'; valid: " + comma_list(laws(), &Law::name) + ", " +
         comma_list(named_laws(), &Law::name));
}

/// Kept for good, as laws are: there are as many as names were asked for.
const Law& arrangement_law(std::string_view name) {
  static std::mutex guard;
  static std::map<std::string, ArrangementLaw, std::less<>> known;
  const std::lock_guard lock(guard);
  const auto found = known.find(name);
  if (found != known.end()) return found->second.law();
  const ArrangementName arrangement = parse_arrangement(name);
  std::vector<const Law*> parts;
  for (const std::string& part : arrangement.parts) parts.push_back(&single_law(part));
  return known.try_emplace(std::string(name), std::string(name), arrangement, parts).first->second.law();
}

std::unique_ptr<Element> arrangement_of(std::string_view name, std::span<const double> values) {
  const ArrangementName arrangement = parse_arrangement(name);
  Parts parts;
  for (const std::string& part : arrangement.parts) {
    const std::size_t size = single_law(part).parameters.size();
    parts.push_back(make_element(part, values.first(size)));
    values = values.subspan(size);
  }
  return arranged(arrangement.series, std::move(parts));
}

}  // namespace

std::span<const Law> laws() { return laws_of(Elements()); }

std::span<const Law> named_laws() { return laws_of(NamedElements()); }

const Law& law(std::string_view name) { return is_arrangement(name) ? arrangement_law(name) : single_law(name); }

const Law& law_to_fit(std::string_view name) {
  if (is_arrangement(name)) {
    for (const std::string& part : parse_arrangement(name).parts) (void)law_to_fit(part);
    return law(name);
  }
  const Law& found = single_law(name);
  if (found.start.values != nullptr) return found;
  const Law* shape = find_law(std::string(name) + "-shape");
  refuse("a measurement does not determine all parameters of law " + std::string(name) + "; fit " +
         std::string(shape != nullptr ? shape->name : "ren"));
}

std::unique_ptr<Element> make_element(std::string_view name, std::span<const double> values) {
  if (is_arrangement(name)) {
    check_values(law(name), values);
    return arrangement_of(name, values);
  }
  const std::string_view known = single_law(name).name;
  auto made = make(Elements(), known, values);
  return made ? std::move(made) : make(NamedElements(), known, values);
}

}  // namespace jointid::friction
