#include "report/laws/direct_page.hpp"

#include <fmt/format.h>

#include "report/laws/direct_plots.hpp"
#include "report/laws/direct_text.hpp"
#include "report/page/page.hpp"
#include "report/page/status_banner.hpp"

namespace jointid::report {

std::string direct_page(const laws::LawScene& scene, const laws::DirectIdentification& found) {
  ReportPage page(scene.title.empty() ? "Friction joints without a law" : scene.title, "jointid equivalent");
  page.status(status_banner(name(found.status), found.message));
  page.section("Summary");
  Facts facts{
      {{"force levels", fmt::format("{}", scene.levels.size())}, {"measured states", fmt::format("{}", found.steps.size())}}};
  if (found.consistency.freedom > 0)
    facts.rows.emplace_back("χ² without any law",
                            fmt::format("{:.5g} of {}", found.consistency.chi_square, found.consistency.freedom));
  page.add(facts);
  for (const std::string& note : found.notes) page.add(Text{note, true});
  page.section("Over the motion of the joint");
  page.add(equivalent_plots(scene, found));
  page.add(
      Text{"Points are F₁/Q₁ of every state, from the data and the FRFs of the parts, with their propagated deviations.", true});
  for (std::size_t j = 0; j < scene.joints.size(); ++j) page.add(direct_table(found.steps, j), scene.joints[j].beside.name);
  page.section("Measured loops");
  page.add(loop_plots(scene, found));
  page.add(Text{"Of each level the state with the largest motion, of the harmonics that were measured.", true});
  return page.html();
}

}  // namespace jointid::report
