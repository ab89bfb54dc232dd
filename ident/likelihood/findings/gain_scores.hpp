#pragma once

#include "ident/likelihood/errors/tried_errors.hpp"
#include "ident/result/solution.hpp"

namespace jointid::ident {

/// A sensor whose gain the data say is another than was assumed.
struct GainSuspect {
  std::string sensor;   ///< "113:+Y in rig1_assembly.h5"
  frf::Dof dof;         ///< its coordinate
  std::string file;     ///< as it was opened
  double gain = 1.0;    ///< true FRF = gain · FRF of the file
  double error = 0.0;   ///< standard deviation of it
  double score = 0.0;   ///< (gain − 1)/error
  std::string instead;  ///< another file with the same sensor, where the inverse gain would do nearly as well; empty: none
};

/// Score tests (Rao 1948) of the gain of every sensor that no table names: with information I and gradient g of the joint's and
/// the declared unknowns r and of the gain t, all at the estimate, t moves by (g_t − I_tr I_rr⁻¹ g_r)/(I_tt − I_tr I_rr⁻¹ I_rt).
/// The one with the largest score is taken into r, and the others are looked at again; those with a score of 5 or more, at most
/// three. Errors are counted as larger where χ² says so. A response and the reference at the same coordinate are one sensor, since FRFs
/// there and back are averaged. `known`: unknowns of the fit.
std::vector<GainSuspect> suspect_gains(const TriedErrors& tried, std::size_t known);

/// A finding for each.
void tell_gains(const std::vector<GainSuspect>& suspects, Solution& out);

}  // namespace jointid::ident
