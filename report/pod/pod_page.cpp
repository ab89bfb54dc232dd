#include "report/pod/pod_page.hpp"

#include <fmt/format.h>

#include "report/page/contents.hpp"
#include "report/page/page.hpp"
#include "report/page/status_banner.hpp"
#include "report/pod/pod_plots.hpp"
#include "report/pod/pod_report.hpp"

namespace jointid::report {

std::string pod_page(const tasks::PodResult& report) {
  const oscillation::Pod& pod = report.pod;
  ReportPage page("Proper orthogonal modes", "jointid pod");
  const std::vector<std::string> remarks = pod_remarks(report);
  page.status(status_banner(remarks.empty() ? "ok" : "doubtful", pod_summary(report), remarks));
  page.section("Values");
  page.add(pod_value_plots(pod));
  page.add(pod_values_table(pod));
  page.add(
      Text{"Values are mean squares of uncorrelated coordinates: an energy only of velocities with the mass matrix in the inner "
           "product.",
           true});
  page.section("Modes");
  page.add(pod_shape_plots(pod));
  page.add(pod_shapes_table(report));
  if (report.cosines.size() > 0) {
    page.section("Beside " + report.compared);
    page.add(pod_comparison_table(report));
    page.add(pod_contributions_table(report), "Contributions to each mode, |v|/Σ|v|");
  }
  return page.html();
}

}  // namespace jointid::report
