#include "friction/path/path_energy.hpp"

#include <cmath>

namespace jointid::friction {

void PathEnergy::add(const Branch& branch, double u, double sign) {
  const Element& element = path_.element();
  if (branch.initial) {
    work_ += sign * element.energy(std::abs(u));
    loss_ += sign * 0.25 * element.cycle_energy(std::abs(u));
    return;
  }
  const double way = u - branch.corner.displacement, half = 0.5 * std::abs(way);
  work_ += sign * (branch.corner.force * way + 4.0 * element.energy(half));
  loss_ += sign * 0.5 * element.cycle_energy(half);
}

Response PathEnergy::advance(double u) {
  while (u != path_.displacement()) {
    const int direction = u > path_.displacement() ? 1 : -1;
    const Branch branch = path_.branch(direction);
    const double stop = direction * (u - branch.closure) > 0.0 ? branch.closure : u;
    add(branch, path_.displacement(), -1.0);
    add(branch, stop, 1.0);
    path_.advance(stop);
  }
  return path_.response(u);
}

}  // namespace jointid::friction
