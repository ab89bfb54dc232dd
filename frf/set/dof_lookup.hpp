#pragma once

#include <string>
#include <vector>

#include "base/error.hpp"
#include "frf/set/frf_set.hpp"

namespace jointid::frf {

/// Index of the DOF's coordinate in `dofs` (the responses or references of `header`); throws InputError (usage) for the key that
/// names it, with the nearest one, when it is not there.
inline std::size_t index_of_dof(const FrfHeader& header, const std::vector<Dof>& dofs, const Dof& dof, const char* key) {
  const std::size_t at = find_coordinate(dofs, dof);
  if (at != npos) return at;
  const std::string near = nearest_word(dof.name(), names(dofs));
  const char* role = &dofs == &header.reference ? "reference" : "response";
  throw InputError({.kind = ErrorKind::usage,
                    .file = header.file,
                    .place = key,
                    .problem = "the file has no " + std::string(role) + " " + dof.name(),
                    .remedy = near.empty() ? "see `jointid info` for the DOFs of a file" : "did you mean " + near + "?"});
}

}  // namespace jointid::frf
