#pragma once

#include <memory>
#include <vector>

#include "frf/set/frf_source.hpp"
#include "frf/set/sensor_mass.hpp"

namespace jointid::frf {

/// What the file calls `from` is `to`; where their signs differ, the transducer pointed the other way.
struct DofRename {
  Dof from, to;
};

/// How the FRFs of a file are put right whose channels, units or clock were wrong. The steps come in the order of the members; a
/// DOF after the first two is named as it is called then. DOFs match coordinates, whatever the signs. Keys of responses are of
/// the sensor, keys of references of the hammer or shaker: a driving point has both.
struct Corrections {
  double frequency_scale = 1.0;  ///< true frequency = this · frequency of the file
  std::vector<DofRename> rename{}, rename_reference{};  ///< all at once: two labels can be swapped
  bool conjugate = false;  ///< the file has the complex conjugates (of e^{−iωt}) of its quantity
  double delay = 0.0;      ///< s by which the responses lag: H · e^{iωτ}
  double gain = 1.0;       ///< of all FRFs: true = gain · measured
  std::vector<DofNumber> response_gain{}, reference_gain{};
  std::vector<Dof> flip{}, flip_reference{};  ///< the sign was wrong
  std::vector<DofNumber> sensor_mass{};       ///< kg (kg·m² at a rotation) that the structure carried in the test
  SensorsOn sensors = SensorsOn::roving;

  bool any() const;
};

/// A source of the FRFs as `corrections` make them, of what is asked for only; the source itself where they ask for nothing.
/// header().changes says what is done. Variances follow to first order with real and imaginary parts independent of each other and
/// of other FRFs; coherences stay, but for sensor masses, where they tell the relative variance that is left.
///
/// A mass m at p adds −ω²m to the dynamic stiffness, so that H = H_m − ω²m H_m(:,p) H_m(p,:)/(1 + ω²m H_m(p,p)) is free of it
/// (Sherman and Morrison 1950), one mass after the other. That takes the FRFs to and from p: each p must be a response and a
/// reference of the file. Where one of them was not measured the result is NaN.
///
/// Throws InputError (usage) for a DOF that the file does not have, with the nearest one, and for names that coincide.
std::unique_ptr<FrfSource> corrected(std::unique_ptr<FrfSource> source, const Corrections& corrections);

/// A source whose FRFs, so far taken for header().quantity, are those of another quantity: what the file says is wrong.
std::unique_ptr<FrfSource> reinterpreted(std::unique_ptr<FrfSource> source, Quantity quantity);

}  // namespace jointid::frf
