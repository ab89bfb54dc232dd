#pragma once

#include <functional>
#include <string>
#include <vector>

#include "report/page/contents.hpp"
#include "report/text/table.hpp"
#include "frf/set/dof.hpp"

namespace jointid::report {

/// rms errors of FRFs as a map. `rms_db` [responses × references], NaN where there is nothing to compare; totals are the rms over
/// those that are there.
HeatMap error_map(const std::string& title, const std::vector<frf::Dof>& responses, const std::vector<frf::Dof>& references,
                  const std::vector<double>& rms_db);

/// All FRFs of a map with their errors, worst first.
Table worst_frfs(const HeatMap& map);

}  // namespace jointid::report
