#pragma once

#include <vector>

#include "base/random.hpp"
#include "frf/set/frf_set.hpp"

namespace jointid::frf {

/// Mistakes in where the DOFs of a set are and which way they point, drawn once per DOF, set and trial; a DOF errs alike as
/// response and as reference.
class DofErrors {
 public:
  /// `sign`: probability of a wrong direction. `position`: standard deviation in m of the place; the FRF there is interpolated
  /// linearly towards the nearest node that has the same direction in the set (a DOF without such a node stays in place).
  DofErrors(const FrfHeader& header, double sign, double position);

  void apply(FrfSet& set, const RandomStream& stream);

 private:
  struct Neighbour {
    std::size_t index = npos;
    double distance = 0.0;  ///< m
  };
  /// New row (or column) i = own·row i + other·row neighbour.
  struct Mix {
    std::size_t neighbour = npos;
    double own = 1.0, other = 0.0;
  };

  static std::vector<Neighbour> neighbours(const FrfHeader& header, const std::vector<Dof>& dofs);
  std::vector<Mix> draw(const std::vector<Dof>& dofs, const std::vector<Neighbour>& near, const RandomStream& stream) const;

  double sign_, position_;
  std::vector<Neighbour> of_responses_, of_references_;
  std::vector<Complex> line_;
};

}  // namespace jointid::frf
