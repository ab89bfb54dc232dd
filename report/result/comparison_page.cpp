#include "report/result/comparison_page.hpp"

#include <fmt/format.h>

#include "report/page/contents.hpp"
#include "report/page/page.hpp"
#include "report/result/comparison_plots.hpp"
#include "report/result/comparison_tables.hpp"
#include "report/text/cost_table.hpp"
#include "report/text/noise_text.hpp"
#include "report/text/words.hpp"

namespace jointid::report {
namespace {

void add_summary(const tasks::ComparisonResult& result, const ident::Scene& scene, ReportPage& page) {
  page.section("Summary");
  page.add(Facts{{{"combinations", fmt::format("{}", result.comparison.combinations.size())},
                  {"left out", fmt::format("{}", result.comparison.left_out.size())},
                  {"trials each", fmt::format("{}", result.trials)},
                  {"seed", fmt::format("{}", result.seed)},
                  {"noise", noise_text(scene.noise)}}});
  page.add(Text{"All combinations see the same trials.", true});
}

void add_matrix(const std::vector<study::Combination>& all, std::size_t matrix, ReportPage& page) {
  const ScatterPlot scatter = error_against_time(all, matrix);
  page.section(words(restrictions::key(all.front().matrices[matrix].kind)));
  if (scatter.groups.empty()) {
    page.add(Text{"No combination gave an estimate."});
  } else {
    page.add(PlotGroup{"", {{"", {scatter}}}});
  }
  for (const PairTable& pair : pair_tables(all, matrix)) page.add(pair.table, pair.title);
  page.add(figures_table(all, matrix));
}

void add_left_out(const std::vector<study::LeftOut>& left_out, ReportPage& page) {
  if (left_out.empty()) return;
  page.section("Left out");
  for (const std::string& line : left_out_lines(left_out)) page.add(Text{line});
}

}  // namespace

std::string comparison_page(const tasks::ComparisonResult& result, const ident::Scene& scene) {
  const std::string file = scene.file.filename().string();
  const std::vector<study::Combination>& all = result.comparison.combinations;
  ReportPage page(result.title.empty() ? file : result.title, "jointid compare " + file);
  add_summary(result, scene, page);
  for (std::size_t matrix = 0; matrix < all.front().matrices.size(); ++matrix) add_matrix(all, matrix, page);
  page.add(
      Text{"rms error: relative, of the elements of the matrix. Bias: rms of the mean relative error of the unknowns. "
           "* on the Pareto front: no other combination has both less error in this matrix and less time.",
           true});
  page.section("Cost");
  page.add(cost_table(all));
  page.add(Text{
      "Median time of one solution on one thread, and memory of the reduced system, or of data and states of the likelihood.",
      true});
  add_left_out(result.comparison.left_out, page);
  return page.html();
}

}  // namespace jointid::report
