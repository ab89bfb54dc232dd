#include <cstdlib>
#include <iostream>

#include "frf/dof.hpp"

int main() {
  const auto dof = jointid::frf::Dof::parse("4:-RZ");
  std::cout << dof.name() << '\n';
  return dof.is_rotation() && dof.sign < 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
