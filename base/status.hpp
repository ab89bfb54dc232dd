#pragma once

#include <string>

namespace jointid {

/// What the numbers of a result are worth, whatever task found them. Files of studies hold the enumerator's number: new ones go to the
/// end, with their row in status.cpp.
enum class Status {
  ok,
  rank_deficient,  ///< the data do not fix every unknown; the rest of the numbers hold
  no_equations,    ///< nothing was left to solve
  not_converged,   ///< the iteration ended without a minimum
  imprecise,       ///< rounding alone can move an unknown by as much as its size
  doubtful,        ///< usable, but the data say something against it
  poor_fit,        ///< the data contradict it: far more misfit than their noise explains, or a joint that is not passive
  no_modes,        ///< modal fit: nothing in the range stands out of the noise; the residual terms alone were fitted
  no_response,     ///< friction laws: harmonic balance has no solution for any law to start with
  too_few_data,    ///< friction laws: fewer numbers measured than unknown
  too_few_points   ///< loading curves: fewer samples than unknowns
};

/// Its word in JSON, tables and files: "not_converged".
std::string name(Status status);

/// Whether the numbers may be used: the command's exit code is 0 then, else 4 (cli/text/tell_status.hpp).
bool is_usable(Status status);

}  // namespace jointid
