#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "frf/set/frf_source.hpp"
#include "frf/uff/uff_scan.hpp"

namespace jointid::frf::uff {

/// The DOF that a name of a point says: "Pt1Z-" is 1:-Z, "Pt56Z" and "beam 56:+Z" are 56:+Z; empty where it says none.
std::optional<Dof> dof_of_name(std::string_view name);

/// Gives the records whose DOFs the file does not have (direction 0: scalar) those of the options: `options.response` in the
/// order in which the names (entity, node) of such responses first appear among `records`, `options.reference` likewise, by
/// default the same. Where all have one name, the k-th record gets the k-th DOF, if there is one response or one reference.
/// Coherences follow the names of the FRFs. Throws InputError (usage) where DOFs are given and the file has its own, which are
/// others, or their number is another one.
void give_dofs(std::vector<Dataset>& datasets, const std::vector<std::size_t>& records, const OpenOptions& options,
               bool has_references, const std::string& file);

/// Throws InputError at record 6 of a record without DOF, with the options that would give it one.
void require_dofs(const Dataset& dataset, bool has_references);

}  // namespace jointid::frf::uff
