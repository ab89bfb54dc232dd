#include "cli/compare/comparison_page.hpp"

#include <fmt/format.h>

#include "cli/text/noise_text.hpp"
#include "report/page/contents.hpp"
#include "report/page/page.hpp"
#include "report/result/comparison_plots.hpp"
#include "report/result/comparison_tables.hpp"
#include "report/text/cost_table.hpp"
#include "report/text/words.hpp"

namespace jointid::cli {
namespace {

using report::cost_table;
using report::error_against_time;
using report::figures_table;
using report::left_out_lines;
using report::pair_tables;
using report::PairTable;

void add_summary(const ComparisonReport& report, const ident::Scene& scene, report::ReportPage& page) {
  page.section("Summary");
  page.add(report::Facts{{{"combinations", fmt::format("{}", report.comparison.combinations.size())},
                          {"left out", fmt::format("{}", report.comparison.left_out.size())},
                          {"trials each", fmt::format("{}", report.trials)},
                          {"seed", fmt::format("{}", report.seed)},
                          {"noise", noise_text(scene.noise)}}});
  page.add(report::Text{"All combinations see the same trials.", true});
}

void add_matrix(const std::vector<study::Combination>& all, std::size_t matrix, report::ReportPage& page) {
  const report::ScatterPlot scatter = error_against_time(all, matrix);
  page.section(report::words(restrictions::key(all.front().matrices[matrix].kind)));
  if (scatter.groups.empty()) {
    page.add(report::Text{"No combination gave an estimate."});
  } else {
    page.add(report::PlotGroup{"", {{"", {scatter}}}});
  }
  for (const PairTable& pair : pair_tables(all, matrix)) page.add(pair.table, pair.title);
  page.add(figures_table(all, matrix));
}

void add_left_out(const std::vector<study::LeftOut>& left_out, report::ReportPage& page) {
  if (left_out.empty()) return;
  page.section("Left out");
  for (const std::string& line : left_out_lines(left_out)) page.add(report::Text{line});
}

}  // namespace

std::string comparison_report(const ComparisonReport& report, const ident::Scene& scene) {
  const std::string file = scene.file.filename().string();
  const std::vector<study::Combination>& all = report.comparison.combinations;
  report::ReportPage page(report.title.empty() ? file : report.title, "jointid compare " + file);
  add_summary(report, scene, page);
  for (std::size_t matrix = 0; matrix < all.front().matrices.size(); ++matrix) add_matrix(all, matrix, page);
  page.add(
      report::Text{"rms error: relative, of the elements of the matrix. Bias: rms of the mean relative error of the unknowns. "
                   "* on the Pareto front: no other combination has both less error in this matrix and less time.",
                   true});
  page.section("Cost");
  page.add(report::cost_table(all));
  page.add(report::Text{
      "Median time of one solution on one thread, and memory of the reduced system, or of data and states of the likelihood.",
      true});
  add_left_out(report.comparison.left_out, page);
  return page.html();
}

}  // namespace jointid::cli
