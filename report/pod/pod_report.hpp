#pragma once

#include <string>
#include <vector>

#include "report/pod/pod_record.hpp"
#include "report/text/table.hpp"
#include "series/pod/mode_comparison.hpp"

namespace jointid::report {

/// All that `pod` found.
struct PodReport {
  std::vector<std::string> names, units;
  std::size_t cut = 0;
  series::Pod pod;
  bool weighted = false, mean_kept = false;
  std::string compared;                ///< "the modes of --compare", "the normal modes of --stiffness and --mass"; or empty
  Eigen::MatrixXd cosines, assurance;  ///< [modes, those that they are compared with]; empty without them
  std::vector<double> frequencies_hz;  ///< of the normal modes, where they were computed
};

/// The record as it was read, with what the task asks for. Throws InputError.
PodReport make_pod_report(const PodTask& task, PodRecord record);

/// "1000 samples of 8 channels; 3 modes hold 99 %, 5 hold 99.99 % of Σσ²."
std::string pod_summary(const PodReport& report);

/// What one should know before one uses it: missing samples, cut channels, units that differ, too few samples.
std::vector<std::string> pod_remarks(const PodReport& report);

/// Tables on the terminal and in the page.
Table pod_values_table(const series::Pod& pod);
Table pod_shapes_table(const PodReport& report);
Table pod_comparison_table(const PodReport& report);

/// For people.
std::string pod_text(const PodReport& report);
/// The keys stay. Numbers that are not there are null.
std::string pod_json(const PodReport& report);
/// "channel,unit,mean,mode 1,mode 2 …", all modes.
std::string pod_csv(const PodReport& report);

}  // namespace jointid::report
