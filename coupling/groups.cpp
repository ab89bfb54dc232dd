#include "coupling/groups.hpp"

#include <utility>

#include "base/eigen.hpp"

namespace jointid::coupling {

Groups::Groups(std::size_t count) : ground_(at(count)), parent_(count + 1), sign_(count + 1, 1.0) {
  for (std::size_t i = 0; i <= count; ++i) parent_[i] = at(i);
}

Groups::Outcome Groups::join(const Condition& condition) {
  const Index other = condition.second.value_or(ground_);
  const Index one = root(condition.first), two = root(other);
  const double sign_between = sign(condition.first) * condition.sign * sign(other);
  if (one == two) return one == ground_ || sign_between > 0.0 ? Outcome::implied : Outcome::contradiction;
  // The ground stays a root, so that one look tells who is grounded.
  const auto [from, to] = two == ground_ ? std::pair(one, two) : std::pair(two, one);
  parent_[static_cast<std::size_t>(from)] = to;
  sign_[static_cast<std::size_t>(from)] = sign_between;
  return Outcome::joined;
}

Index Groups::root(Index i) const {
  while (parent_[static_cast<std::size_t>(i)] != i) i = parent_[static_cast<std::size_t>(i)];
  return i;
}

double Groups::sign(Index i) const {
  double product = 1.0;
  while (parent_[static_cast<std::size_t>(i)] != i) {
    product *= sign_[static_cast<std::size_t>(i)];
    i = parent_[static_cast<std::size_t>(i)];
  }
  return product;
}

}  // namespace jointid::coupling
