#pragma once

#include <vector>

#include "frf/set/frf_set.hpp"
#include "problems/structure/structure.hpp"

namespace jointid::problems {

/// Receptances of a structure at chosen DOFs and lines.
struct ResponseRequest {
  std::vector<frf::Dof> response;  ///< signs flip the FRFs
  std::vector<frf::Dof> reference;
  std::vector<double> frequency_hz;
  /// Decay rate σ ≥ 0 of the exponential window put on the responses of an impact test, 1/s. The FRF is that
  /// of the Laplace variable s = σ + iω: every pole moves by σ to the left, whatever it belongs to (Fladung &
  /// Rost, 1997).
  double window_rate = 0.0;
};

/// H = [K + s²M + sC + iD]⁻¹ with s = σ + iω, by one LU decomposition per line over all DOFs of the
/// structure; no modes are left out. The header gets the nodes of the requested DOFs.
frf::FrfSet frequency_response(const Structure& structure, const ResponseRequest& request);

/// A header for the request, without data.
frf::FrfHeader response_header(const std::vector<frf::Node>& nodes, const ResponseRequest& request);

/// What a roving accelerometer of `mass` kg adds to the structure at each response DOF: from a set with the
/// point FRFs, H'(r,c) = H(r,c)/(1 + s²·mass·H(r,r)). Throws InputError (usage) when a point FRF is not in
/// the set.
frf::FrfSet with_accelerometer(const frf::FrfSet& set, double mass, double window_rate);

}  // namespace jointid::problems
