#include "python/predict.hpp"

#include <memory>
#include <optional>
#include <utility>

#include "frf/set/frf_source.hpp"
#include "ident/plan/data_source.hpp"
#include "ident/scene/couple_scene.hpp"
#include "ident/scene/equivalent_scene.hpp"
#include "ident/scene/scene_sections.hpp"
#include "laws/scene/read_law_scene.hpp"
#include "laws/task/direct_identification.hpp"
#include "python/outputs.hpp"
#include "report/couple/couple_page.hpp"
#include "report/couple/couple_text.hpp"
#include "report/equivalent/equivalent_page.hpp"
#include "report/equivalent/equivalent_text.hpp"
#include "report/laws/direct_page.hpp"
#include "report/laws/direct_text.hpp"
#include "report/oscillate/oscillate_page.hpp"
#include "report/oscillate/oscillate_report.hpp"
#include "report/page/limits.hpp"
#include "report/response/response_page.hpp"
#include "report/response/response_text.hpp"
#include "report/response/ways_text.hpp"
#include "scene/kind.hpp"
#include "scene/reader.hpp"
#include "tasks/couple.hpp"
#include "tasks/couple/couple_frfs.hpp"
#include "tasks/equivalent.hpp"
#include "tasks/oscillate/run_oscillate.hpp"
#include "tasks/response/read_response_scene.hpp"
#include "tasks/response/response_ways.hpp"
#include "tasks/response/run_response.hpp"

namespace jointid::python {
namespace {

std::vector<frf::FrfSet> loaded(const ident::CoupleScene& scene, ident::ModelsInUse& models) {
  std::vector<frf::FrfSet> sets;
  auto systems = ident::open_systems({scene.parts}, scene.frequency, scene.file, &models);
  for (const auto& source : systems.front()) sets.push_back(frf::load_with_covariance(*source));
  return sets;
}

tasks::CoupledSets coupled(const ident::CoupleScene& scene, const std::filesystem::path& out, bool bounds,
                           const ident::Control& control) {
  tasks::CoupledSets sets;
  if (out.empty()) {
    ident::ModelsInUse models;
    sets = tasks::couple(scene, loaded(scene, models), bounds, control);
    for (const ident::ModelInUse& each : models)
      sets.result.models.push_back(ident::used_models({each}, sets.result.lines, each.dofs).front());
    return sets;
  }
  sets.result = tasks::couple(scene, out, bounds, control);
  if (!sets.result.records.empty()) sets.frfs = frf::load_with_covariance(*frf::open(out));
  return sets;
}

Outcome direct_steps(const SceneText& text) {
  const auto scene = std::make_shared<const laws::LawScene>(laws::parse_law_scene(text.text, text.file));
  const auto found = std::make_shared<const laws::DirectIdentification>(laws::identify_directly(*scene));
  return {.status = name(found->status),
          .message = found->message,
          .usable = is_usable(found->status),
          .json = [=] { return report::direct_json(*scene, *found); },
          .text = [=] { return report::direct_text(*scene, *found); },
          .csv = [=] { return report::direct_csv(*scene, *found); },
          .page = [=](const ident::Control&) { return report::direct_page(*scene, *found); }};
}

Outcome outcome_of(tasks::OscillateResult motion) {
  const auto run = std::make_shared<const tasks::OscillateResult>(std::move(motion));
  const std::string failure = tasks::failure_of(*run);
  return {.status = failure.empty() ? "ok" : "unusable",
          .message = failure,
          .usable = failure.empty(),
          .json = [=] { return report::oscillate_json(*run); },
          .text = [=] { return report::oscillate_text(*run); },
          .csv = [=] { return report::motion_csv(*run); },
          .page = [=](const ident::Control&) { return report::oscillate_report(*run); }};
}

}  // namespace

Outcome couple(const SceneText& text, const std::filesystem::path& out, bool bounds, const ident::Control& control) {
  const auto scene = std::make_shared<const ident::CoupleScene>(ident::parse_couple_scene(text.text, text.file));
  refuse_inputs(out, ident::files_of(*scene));
  const auto found = std::make_shared<const tasks::CoupledSets>(coupled(*scene, out, bounds, control));
  const bool ok = found->result.status == ident::Status::ok;
  return {.status = ok ? "ok" : "not_usable",
          .message = found->result.message,
          .usable = ok,
          .json = [=] { return report::couple_json(*scene, found->result); },
          .text = [=] { return report::couple_text(*scene, found->result); },
          .csv = [=] { return report::couple_csv(found->result); },
          .page =
              [=](const ident::Control&) {
                return report::couple_page(*scene, found->result, tasks::predicted_of(*found, report::most_frfs));
              },
          .frfs = [=](const ident::Control&) { return found->frfs; }};
}

Outcome equivalent(const SceneText& text, const ident::Control& control) {
  if (scene::is_law_scene(text.text, text.file)) return direct_steps(text);
  const auto scene = std::make_shared<const ident::EquivalentScene>(ident::parse_equivalent_scene(text.text, text.file));
  const auto levels = std::make_shared<const std::vector<tasks::LevelJoint>>(tasks::find_equivalent(*scene, control));
  return {.status = tasks::equivalent_status(*levels),
          .message = tasks::equivalent_doubt(*levels),
          .usable = tasks::all_settled(*levels),
          .json = [=] { return report::equivalent_json(*scene, *levels); },
          .text = [=] { return report::equivalent_text(*scene, *levels); },
          .csv = [=] { return report::equivalent_csv(*levels); },
          .page = [=](const ident::Control&) { return report::equivalent_page(*scene, *levels); }};
}

Outcome response_of(const SceneText& text, const ident::Control& control) {
  const auto scene = std::make_shared<const tasks::ResponseScene>(tasks::parse_response_scene(text.text, text.file));
  const auto run = std::make_shared<const tasks::ResponseResult>(tasks::run_response(*scene, control));
  const bool converged = tasks::all_converged(*run);
  return {.status = converged ? "ok" : "not_converged",
          .message = converged ? "" : "harmonic balance did not converge everywhere",
          .usable = converged,
          .json = [=] { return report::response_json(*scene, *run); },
          .text = [=] { return report::response_text(*scene, *run); },
          .csv = [=] { return report::response_csv(*run); },
          .page = [=](const ident::Control&) { return report::response_report(*scene, *run); }};
}

Outcome response_ways(const SceneText& text, const ident::Control& control) {
  const auto scene = std::make_shared<const tasks::ResponseScene>(tasks::parse_response_scene(text.text, text.file));
  const auto runs = std::make_shared<const std::vector<tasks::WaysResult>>(tasks::compare_responses(*scene, control));
  const bool known = tasks::all_known(*runs);
  return {.status = {},
          .message = known ? "" : "no exact orbit was found",
          .usable = known,
          .json = [=] { return report::ways_json(*scene, *runs); },
          .text = [=] { return report::ways_text(*scene, *runs); },
          .csv = [=] { return report::ways_csv(*runs); }};
}

Outcome oscillate(const SceneText& text, const ident::Control& control, SoFar& so_far) {
  const auto keep = [&so_far](const tasks::OscillateResult& found) {
    so_far.put([kept = found]() mutable {
      kept.interrupted = true;
      kept.remarks.emplace_back("INTERRUPTED: only what was found so far");
      Outcome out = outcome_of(kept);
      out.message = "Interrupted: what was found so far.";
      out.status = "unusable";
      out.usable = false;
      return out;
    });
  };
  return outcome_of(tasks::run_oscillate(tasks::parse_oscillate_scene(text.text, text.file), control, keep));
}

frf::FrfSet at_virtual_points(const SceneText& text, const std::filesystem::path& path) {
  const scene::Value document = scene::parse_toml(text.text, text.file);
  const std::string name = text.file.string();
  const scene::Table table = scene::Item(document, name, {}, {}).table({"nodes", "virtual_points"});
  ident::DataFile file{.path = path, .options = {}};
  ident::read_virtual_points(table, text.file.parent_path(), {&file});
  return frf::load_with_covariance(*ident::open_all({file}).front());
}

}  // namespace jointid::python
