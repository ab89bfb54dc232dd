#pragma once

#include "friction/law/law.hpp"
#include "friction/path/element.hpp"

namespace jointid::friction {

/// What the laws of laws.hpp share: E has `static const Law law` and is made of as many values as that has parameters.
template <class E>
class ListedLaw : public Element {
 public:
  bool admits(std::span<const double> values) const final { return friction::admits(E::law, values); }
  std::unique_ptr<Element> with(std::span<const double> values) const final { return std::make_unique<E>(values); }

 protected:
  /// Throws InputError for values that the law does not admit.
  explicit ListedLaw(std::span<const double> values) { check_values(E::law, values); }
};

}  // namespace jointid::friction
