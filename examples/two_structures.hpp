// The test that the examples simulate: two structures of two masses on springs each (masses 1 and 2, 4 and 3), and the assembly
// with a joint between masses 2 and 3. A measurement would fill the same sets.
#pragma once

#include <array>

#include "frf/set/frf_set.hpp"

namespace examples {

using jointid::Complex;

using Receptances = std::array<std::array<Complex, 4>, 4>;  // m/N, of masses 1 to 4

inline const Complex joint(3.0e5, 3.0e3);  // K + iD, N/m

/// Of ground – spring – mass – spring – mass: 2 × 2 from its dynamic stiffness.
inline std::array<std::array<Complex, 2>, 2> structure(double hz, double mass) {
  const Complex spring(5.0e5, 2.0e3);
  const double inertia = mass * jointid::angular(hz) * jointid::angular(hz);
  const Complex a = 2.0 * spring - inertia, b = -spring, c = spring - inertia, determinant = a * c - b * b;
  return {{{c / determinant, -b / determinant}, {-b / determinant, a / determinant}}};
}

inline Receptances apart(double hz) {
  const auto one = structure(hz, 2.0), two = structure(hz, 3.0);
  return {{{one[0][0], one[0][1], 0.0, 0.0},
           {one[1][0], one[1][1], 0.0, 0.0},
           {0.0, 0.0, two[1][1], two[1][0]},
           {0.0, 0.0, two[0][1], two[0][0]}}};
}

/// With a joint of dynamic stiffness z: H − (H b)(bᵀH)/(1/z + bᵀH b), b = e₂ − e₃; 1/z = 0 for a rigid one.
inline Receptances assembled(double hz, Complex compliance = 1.0 / joint) {
  Receptances h = apart(hz);
  std::array<Complex, 4> hb;
  for (std::size_t r = 0; r < 4; ++r) hb[r] = h[r][1] - h[r][2];
  const Complex below = compliance + hb[1] - hb[2];
  for (std::size_t r = 0; r < 4; ++r) {
    for (std::size_t c = 0; c < 4; ++c) h[r][c] -= hb[r] * hb[c] / below;
  }
  return h;
}

/// FRFs between masses first … last, 20 to 120 Hz.
template <class Of>
jointid::frf::FrfSet measured(const char* name, std::size_t first, std::size_t last, const Of& receptances) {
  jointid::frf::FrfSet set;
  set.header.file = name;
  for (std::size_t mass = first; mass <= last; ++mass)
    set.header.response.push_back({static_cast<std::int64_t>(mass), jointid::frf::Direction::z});
  set.header.reference = set.header.response;
  for (double hz = 20.0; hz <= 120.0; hz += 1.0) {
    set.header.frequency_hz.push_back(hz);
    const Receptances h = receptances(hz);
    for (std::size_t r = first - 1; r < last; ++r) {
      for (std::size_t c = first - 1; c < last; ++c) set.values.push_back(h[r][c]);
    }
  }
  return set;
}

inline jointid::frf::FrfSet structure_1() { return measured("structure 1", 1, 2, apart); }
inline jointid::frf::FrfSet structure_2() { return measured("structure 2", 3, 4, apart); }
inline jointid::frf::FrfSet assembly() {
  return measured("assembly", 1, 4, [](double hz) { return assembled(hz); });
}

inline constexpr const char* scene = R"(
  [data]
  substructures = ["structure 1", "structure 2"]
  assembly = ["assembly"]
  [joint]
  dofs = ["2:+Z", "3:+Z"]
  stiffness.springs = [["2:+Z", "3:+Z"]]
  hysteretic_damping.springs = [["2:+Z", "3:+Z"]]
)";

}  // namespace examples
