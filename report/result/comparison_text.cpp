#include "report/result/comparison_text.hpp"

#include <fmt/format.h>

#include "report/result/comparison_tables.hpp"
#include "report/text/cost_table.hpp"
#include "report/text/words.hpp"

namespace jointid::report {
namespace {

std::string pairs_text(const std::vector<study::Combination>& all, std::size_t matrix) {
  std::string text;
  for (const PairTable& pair : pair_tables(all, matrix)) text += pair.title + "\n" + pair.table.text();
  return text;
}

std::string left_out_text(const std::vector<study::LeftOut>& left_out) {
  std::string text = left_out.empty() ? "" : "\nleft out\n";
  for (const std::string& line : left_out_lines(left_out)) text += "  " + line + "\n";
  return text;
}

}  // namespace

std::string comparison_text(const tasks::ComparisonResult& result) {
  const std::vector<study::Combination>& all = result.comparison.combinations;
  std::string text = result.title.empty() ? "" : result.title + "\n";
  text += fmt::format("{} trials of seed {}, the same for every row\n", result.trials, result.seed);
  if (result.comparison.interrupted) text += fmt::format("INTERRUPTED: only the first {} ways\n", all.size());
  for (std::size_t matrix = 0; matrix < all.front().matrices.size(); ++matrix) {
    text += "\n" + words(restrictions::key(all.front().matrices[matrix].kind)) + "\n" + pairs_text(all, matrix) +
            "all combinations\n" + figures_table(all, matrix).text();
  }
  text +=
      "\n  rms error: relative, median over the trials; bias: rms of the mean relative error of the unknowns\n"
      "  * on the Pareto front: no other row has both less error in this matrix and less time\n";
  text +=
      "\ncost: median time of one solution on one thread, memory of the reduced system (likelihood: of its data and states)\n" +
      cost_table(all).text();
  return text + left_out_text(result.comparison.left_out);
}

}  // namespace jointid::report
