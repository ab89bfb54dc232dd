#pragma once

#include <string>
#include <vector>

#include "report/page/contents.hpp"
#include "report/text/table.hpp"
#include "tasks/series/strain.hpp"

namespace jointid::report {

/// Displacements as CSV: "y(0.4) [m],…", and a row a sample of a block.
std::string displacements_title(const tasks::StrainResult& report);
std::string displacements_csv(const Eigen::MatrixXd& block);

/// That nothing shows a wrong gauge, where there are as many shapes as gauges; that the shapes are hard to tell apart.
std::vector<std::string> strain_remarks(const tasks::StrainResult& report);
/// Points, and what errors of the strains do to them.
Table strain_table(const tasks::StrainResult& report);
/// Displacements of the first samples, which it reads. Throws InputError.
PlotGroup strain_plots(const tasks::StrainResult& report);
/// "4 gauges, 4 shapes, condition 12."
std::string strain_summary(const tasks::StrainResult& report);

/// For people.
std::string strain_text(const tasks::StrainResult& report);
/// The keys stay.
std::string strain_json(const tasks::StrainResult& report);
/// The page of `jointid series strain` with its strain_plots().
std::string strain_page(const tasks::StrainResult& report, const PlotGroup& plots);

}  // namespace jointid::report
