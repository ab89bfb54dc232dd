#pragma once

#include <string>
#include <vector>

#include "frf/set/frf_set.hpp"

namespace jointid::correlation {

/// Places of the same thing in two sets.
struct Match {
  std::size_t one = 0, other = 0;
  double sign = 1.0;  ///< that turns the other's DOF into that of the first
};

/// Coordinates that both lists have, in the order of the first.
std::vector<Match> common_dofs(const std::vector<frf::Dof>& one, const std::vector<frf::Dof>& other);

/// Lines that agree to a millionth of their frequency.
std::vector<Match> common_lines(const std::vector<double>& one_hz, const std::vector<double>& other_hz);

/// What responses, references and lines two sets have in common.
struct Common {
  std::vector<Match> responses, references, lines;
};

/// Throws InputError (data) where they have none of one kind in common.
Common common_of(const frf::FrfHeader& one, const frf::FrfHeader& other);

/// The InputError of two files that have no `what` in common; `one` and `other`: what they have.
[[noreturn]] void fail_nothing_common(const std::string& one_file, const std::string& other_file, const std::string& what,
                                      const std::string& one, const std::string& other);

/// "1:+X, 2:+X, … 40 in all"
std::string some_names(const std::vector<frf::Dof>& dofs);

}  // namespace jointid::correlation
