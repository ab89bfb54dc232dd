#pragma once

#include <memory>
#include <vector>

#include "frf/set/frf_source.hpp"
#include "frf/set/sensor_mass.hpp"

namespace jointid::frf {

/// Renames `from` of the file to `to`. If their signs differ, the sensor pointed the other way.
struct DofRename {
  Dof from, to;
};

/// Corrections of a file's FRFs: wrong channels, units or clock. They are applied in the order of the members; DOFs after the
/// first two have their new names. DOFs match coordinates, whatever the signs. Keys of responses are those of the sensor, keys of
/// references those of the hammer or shaker: a driving point has both.
struct Corrections {
  double frequency_scale = 1.0;  ///< true frequency = this · frequency of the file
  std::vector<DofRename> rename{}, rename_reference{};  ///< all at once: two labels can be swapped
  bool conjugate = false;  ///< the file has the complex conjugates (of e^{−iωt}) of its quantity
  double delay = 0.0;      ///< time delay of the responses, s: H · e^{iωτ}
  double gain = 1.0;       ///< of all FRFs: true = gain · measured
  std::vector<DofNumber> response_gain{}, reference_gain{};
  std::vector<Dof> flip{}, flip_reference{};  ///< the sign was wrong
  std::vector<DofNumber> sensor_mass{};       ///< kg (kg·m² at a rotation), mass loading in the test
  SensorsOn sensors = SensorsOn::roving;

  bool any() const;
};

/// A source with the corrected FRFs, or the source itself if there is nothing to correct. header().changes lists the corrections.
/// Variances follow to first order, with real and imaginary parts independent of each other and of other FRFs. Coherences stay;
/// with sensor masses they give the relative variance that is left.
///
/// A mass m at p adds −ω²m to the dynamic stiffness. So H = H_m − ω²m H_m(:,p) H_m(p,:)/(1 + ω²m H_m(p,p)) is free of it (Sherman
/// and Morrison 1950), one mass after the other. It needs the FRFs to and from p: each p must be a response and a reference of
/// the file. Where one of them was not measured the result is NaN.
///
/// Throws InputError (usage) for a DOF that the file does not have, with the nearest one, and for names that coincide.
std::unique_ptr<FrfSource> corrected(std::unique_ptr<FrfSource> source, const Corrections& corrections);

/// A source whose FRFs, taken as header().quantity before, have another quantity: that of the file is wrong.
std::unique_ptr<FrfSource> reinterpreted(std::unique_ptr<FrfSource> source, Quantity quantity);

}  // namespace jointid::frf
