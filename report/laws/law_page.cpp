#include "report/laws/law_page.hpp"

#include <fmt/format.h>

#include "base/text.hpp"
#include "report/laws/law_plots.hpp"
#include "report/laws/law_text.hpp"
#include "report/page/page.hpp"
#include "report/page/status_banner.hpp"

namespace jointid::report {
namespace {

void add_summary(const laws::LawScene& scene, const laws::LawIdentification& found, ReportPage& page) {
  page.section("Summary");
  page.add(Facts{{{"laws", laws::laws_text(found.laws())},
                  {"not separated from", found.not_told_apart.empty() ? "–" : comma_list(found.not_told_apart)},
                  {"force levels", fmt::format("{}", scene.levels.size())},
                  {"measured states", fmt::format("{}", found.data.states.size())},
                  {"χ² of degrees of freedom", fmt::format("{:.5g} of {}", found.fit().chi_square, found.fit().freedom)}}});
  for (const std::string& note : found.notes) page.add(Text{note, true});
}

}  // namespace

std::string law_page(const laws::LawScene& scene, const laws::LawIdentification& found) {
  ReportPage page(scene.title.empty() ? "Friction laws from vibration" : scene.title, "jointid solve");
  page.status(status_banner(name(found.status), found.message));
  add_summary(scene, found, page);
  page.section("Joints");
  for (std::size_t j = 0; j < found.fit().joints.size(); ++j)
    page.add(joint_table(found.fit().joints[j]), scene.joints[j].beside.name + ": " + found.laws()[j]);
  page.section("Laws compared");
  page.add(law_table(found));
  page.section("Over the motion of the joint");
  page.add(law_plots(scene, found));
  page.add(Text{
      "Points are F₁/Q₁ of every state, found from the data and the FRFs of the parts without any law; the line is the law's.",
      true});
  page.section("Residuals by level");
  page.add(level_table(scene, found));
  return page.html();
}

}  // namespace jointid::report
