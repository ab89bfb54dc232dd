#pragma once

#include <string>
#include <vector>

#include "frf/set/frf_set.hpp"

namespace jointid::tasks {

/// Which files are the parts and which the assembly; a file in place of a group of one, several runs of one measurement together.
struct ProposedRoles {
  using Group = std::vector<std::size_t>;  ///< indices of the files
  std::vector<Group> substructures, assembly;
  std::vector<std::string> reasons;  ///< one sentence each
  std::vector<std::string> doubts;   ///< what the user should look at, one sentence each
};

/// Files with the same DOFs and lines are runs of one measurement. Of the rest the parts are those that share no coordinate with
/// each other, the assembly those that share coordinates with the parts; where several choices are left, the one whose assembly
/// spans most parts, then the one that the names of the files speak for, then the one whose assembly has the most DOFs. Throws
/// InputError (usage) for fewer than two and more than twelve structures, and where no choice leaves both parts and assembly.
ProposedRoles propose_roles(const std::vector<const frf::FrfHeader*>& files);

/// The coordinates that are a response or a reference of a file.
std::vector<frf::Dof> coordinates_of(const frf::FrfHeader& file);

}  // namespace jointid::tasks
