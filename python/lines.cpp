#include "python/lines.hpp"

#include <memory>
#include <string>

#include "frf/file/write.hpp"
#include "ident/scene/scene_files.hpp"
#include "impedance/decouple/decouple.hpp"
#include "impedance/identify_lines.hpp"
#include "impedance/line_plan.hpp"
#include "impedance/scene/read_line_scene.hpp"
#include "python/outputs.hpp"
#include "report/impedance/decouple_report.hpp"
#include "report/impedance/line_plan_text.hpp"
#include "report/impedance/line_report.hpp"

namespace jointid::python {
namespace {

/// The FRFs of B by the first way.
frf::FrfSet of_b(const impedance::Decoupled& found) {
  frf::FrfSet set = impedance::frfs_of(found, found.ways.front());
  set.header.file = "B";
  return set;
}

}  // namespace

Outcome solve_lines(const SceneText& text, const ident::Control& control) {
  const auto scene = std::make_shared<const impedance::LineScene>(impedance::parse_line_scene(text.text, text.file));
  const auto found = std::make_shared<const impedance::IdentifiedLines>(impedance::identify_lines(*scene, control));
  return {.status = name(found->status),
          .message = found->message,
          .usable = is_usable(found->status),
          .json = [=] { return report::line_json(*scene, *found); },
          .text = [=] { return report::line_text(*scene, *found); },
          .csv = [=] { return report::line_csv(*found); },
          .page = [=](const ident::Control&) { return report::line_page(*scene, *found); }};
}

Outcome plan_lines(const SceneText& text, bool with_bound, const ident::Control& control) {
  const auto scene = std::make_shared<const impedance::LineScene>(impedance::parse_line_scene(text.text, text.file));
  const auto plan = std::make_shared<const impedance::LinePlan>(impedance::plan_lines(*scene, with_bound, control));
  return {.status = {},
          .message = {},
          .json = [=] { return report::line_plan_json(*scene, *plan); },
          .text = [=] { return report::line_plan_text(*scene, *plan); }};
}

Outcome decouple(const SceneText& text, const std::filesystem::path& out, const ident::Control& control) {
  const auto scene = std::make_shared<const impedance::DecoupleScene>(impedance::parse_decouple_scene(text.text, text.file));
  refuse_inputs(out, ident::files_of(scene->lines.scene));
  const auto found = std::make_shared<const impedance::Decoupled>(impedance::decouple(*scene, control));
  if (!out.empty()) frf::write(of_b(*found), out);
  const std::string file = out.empty() ? "in memory" : out.string();
  return {.status = name(found->status),
          .message = found->message,
          .usable = is_usable(found->status),
          .json = [=] { return report::decouple_json(*scene, *found, file); },
          .text = [=] { return report::decouple_text(*scene, *found, file); },
          .csv = [=] { return report::decouple_csv(*found); },
          .frfs = [=](const ident::Control&) { return of_b(*found); }};
}

}  // namespace jointid::python
