#pragma once

#include <string>
#include <vector>

#include "oscillation/pod/mode_comparison.hpp"
#include "report/text/table.hpp"
#include "tasks/pod/run_pod.hpp"

namespace jointid::report {

/// "1000 samples of 8 channels; 3 modes hold 99 %, 5 hold 99.99 % of Σσ²."
std::string pod_summary(const tasks::PodResult& report);

/// What one should know before one uses it: missing samples, cut channels, units that differ, too few samples.
std::vector<std::string> pod_remarks(const tasks::PodResult& report);

/// Tables on the terminal and in the page.
Table pod_values_table(const oscillation::Pod& pod);
Table pod_shapes_table(const tasks::PodResult& report);
Table pod_comparison_table(const tasks::PodResult& report);
/// Rows: modes; columns: the first eight of those that they are compared with.
Table pod_contributions_table(const tasks::PodResult& report);

/// For people.
std::string pod_text(const tasks::PodResult& report);
/// The keys stay. Numbers that are not there are null.
std::string pod_json(const tasks::PodResult& report);
/// "channel,unit,mean,mode 1,mode 2 …", all modes.
std::string pod_csv(const tasks::PodResult& report);

}  // namespace jointid::report
