#include "python/identify.hpp"

#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "ident/identify.hpp"
#include "ident/scene/read_scene.hpp"
#include "ident/whole_check.hpp"
#include "impedance/check_lines.hpp"
#include "impedance/scene/read_line_scene.hpp"
#include "laws/scene/read_law_scene.hpp"
#include "laws/task/identify_laws.hpp"
#include "laws/task/law_bound.hpp"
#include "python/lines.hpp"
#include "report/check_json.hpp"
#include "report/json_value.hpp"
#include "report/laws/law_bound_text.hpp"
#include "report/laws/law_page.hpp"
#include "report/laws/law_text.hpp"
#include "report/page/limits.hpp"
#include "report/result/bound_text.hpp"
#include "report/result/check_text.hpp"
#include "report/result/plan_text.hpp"
#include "report/result/solution_text.hpp"
#include "report/result/solve_page.hpp"
#include "report/solution_json.hpp"
#include "scene/kind.hpp"
#include "tasks/bound_report.hpp"
#include "tasks/regenerate.hpp"
#include "tasks/solution_details.hpp"

namespace jointid::python {
namespace {

/// A solved plan, whose FRFs pages and predictions read again, one at a time.
struct Solved {
  std::unique_ptr<ident::Plan> plan;
  ident::Solution solution;
  tasks::IterationLog log{};
  std::mutex mutex{};
};

std::string page_of(Solved& solved, const ident::Control& control) {
  const std::lock_guard lock(solved.mutex);
  tasks::SolutionDetails details = tasks::solution_details(*solved.plan, solved.solution,
                                                           {std::nullopt, report::most_frfs, report::worst_frfs_drawn}, control);
  details.iterations = solved.log.ended(solved.solution);
  return report::solve_report(*solved.plan, solved.solution, details);
}

/// All assembly FRFs that the substructures and the identified joint give, receptances.
frf::FrfSet predicted(Solved& solved, const ident::Control& control) {
  const std::lock_guard lock(solved.mutex);
  frf::FrfSet set;
  set.header.file = "predicted assembly";
  set.header.response = tasks::regenerable_responses(*solved.plan);
  set.header.reference = tasks::regenerable_references(*solved.plan);
  std::vector<tasks::FrfEntry> entries;
  for (const frf::Dof& response : set.header.response) {
    for (const frf::Dof& reference : set.header.reference) entries.push_back({response, reference});
  }
  const tasks::Regenerated frfs = tasks::regenerate(*solved.plan, solved.solution.bands, entries, control);
  set.header.frequency_hz = frfs.frequency_hz;
  for (std::size_t line = 0; line < frfs.frequency_hz.size(); ++line) {
    for (const tasks::RegeneratedFrf& frf : frfs.frfs) set.values.push_back(frf.predicted[line]);
  }
  return set;
}

Outcome solve_laws(const SceneText& text, const ident::Control& control) {
  const auto scene = std::make_shared<const laws::LawScene>(laws::parse_law_scene(text.text, text.file));
  const response::FitWork work = {.threads = threads_or_cores(control.threads), .interrupted = control.interrupted};
  const auto found = std::make_shared<const laws::LawIdentification>(laws::identify_laws(*scene, work));
  return {.status = name(found->status),
          .message = found->message,
          .usable = is_usable(found->status),
          .json = [=] { return report::law_json(*scene, *found); },
          .text = [=] { return report::law_text(*scene, *found); },
          .csv = [=] { return report::law_csv(*scene, *found); },
          .page = [=](const ident::Control&) { return report::law_page(*scene, *found); }};
}

/// The best estimate of a run that was interrupted; page and predictions would need the data again.
Outcome interrupted_outcome(ident::Solution best, const std::string& title) {
  tasks::mark_interrupted(best);
  const auto found = std::make_shared<const ident::Solution>(std::move(best));
  return {.status = ident::name(found->status),
          .message = found->message,
          .usable = false,
          .json = [found] { return report::solution_json(*found); },
          .text = [found, title] { return report::solution_text(*found, title); },
          .csv = [found] { return report::unknowns_csv(*found); }};
}

Outcome outcome_of(const std::shared_ptr<const ident::Plan>& plan, const std::shared_ptr<const tasks::BoundReport>& found) {
  return {.status = {},
          .message = found->interrupted ? "Interrupted: what was predicted so far." : "",
          .usable = !found->interrupted,
          .json = [=] { return report::plan_json(*plan, *found); },
          .text = [=] { return report::plan_text(*plan) + report::bound_text(*found); }};
}

[[noreturn]] void refuse_law_scene(const SceneText& scene, const char* problem, const char* remedy) {
  throw InputError({ErrorKind::usage, scene.file.string(), "[[joint.friction]]", problem, remedy});
}

Outcome bound_of_laws(const SceneText& text, bool has_candidates) {
  if (has_candidates)
    refuse_law_scene(text, "candidates of a friction scene are force levels", "add [[data.levels]] without responses");
  const auto scene = std::make_shared<const laws::LawScene>(laws::parse_law_scene(text.text, text.file));
  const auto bound = std::make_shared<const laws::LawBound>(laws::predict_law_bound(*scene));
  return {.status = {},
          .message = {},
          .json = [=] { return report::law_bound_json(*scene, *bound); },
          .text = [=] { return report::law_bound_text(*scene, *bound); }};
}

}  // namespace

Outcome solve(const SceneText& text, const ident::Control& control, SoFar& so_far) {
  if (scene::is_law_scene(text.text, text.file)) return solve_laws(text, control);
  if (scene::is_line_scene(text.text, text.file)) return solve_lines(text, control);
  auto plan = ident::make_plan(ident::parse_scene(text.text, text.file));
  ident::Control judging = control;
  judging.judgement = ident::Judgement::data;
  const auto solved = std::make_shared<Solved>();
  judging.so_far = [&so_far, &log = solved->log, title = plan->scene.title](const ident::Solution& best) {
    log.note(best);
    so_far.put([kept = best, title] { return interrupted_outcome(kept, title); });
  };
  solved->solution = ident::solve(*plan, judging);
  solved->plan = std::move(plan);
  const ident::Solution& found = solved->solution;
  return {.status = ident::name(found.status),
          .message = found.message,
          .usable = ident::is_usable(found.status),
          .json = [solved] { return report::solution_json(solved->solution); },
          .text = [solved] { return report::solution_text(solved->solution, solved->plan->scene.title); },
          .csv = [solved] { return report::unknowns_csv(solved->solution); },
          .page = [solved](const ident::Control& watch) { return page_of(*solved, watch); },
          .frfs = [solved](const ident::Control& watch) { return predicted(*solved, watch); }};
}

Outcome check(const SceneText& text, const ident::Control& control) {
  const auto result = std::make_shared<const ident::CheckResult>(
      scene::is_line_scene(text.text, text.file)
          ? impedance::check_lines(impedance::parse_line_scene(text.text, text.file), control)
          : ident::check_whole(ident::parse_scene(text.text, text.file), control));
  return {.status = ident::name(result->verdict),
          .message = {},
          .usable = result->verdict == ident::Verdict::clean,
          .json = [result] { return report::json_text(report::check_json(*result)); },
          .text = [result] { return report::check_text(*result); }};
}

Outcome plan(const SceneText& text, const ident::Control& control) {
  if (scene::is_line_scene(text.text, text.file)) return plan_lines(text, false, control);
  if (scene::is_law_scene(text.text, text.file))
    refuse_law_scene(text, "scenes of friction laws have no plan but the bound", "call bound(): what the levels will determine");
  const std::shared_ptr<const ident::Plan> made = ident::make_plan(ident::parse_scene(text.text, text.file));
  return {.status = {},
          .message = {},
          .json = [made] { return report::plan_json(*made); },
          .text = [made] { return report::plan_text(*made); }};
}

Outcome bound(const SceneText& text, const std::vector<frf::Dof>& candidates, const ident::Control& control, SoFar& so_far) {
  if (scene::is_law_scene(text.text, text.file)) return bound_of_laws(text, !candidates.empty());
  if (scene::is_line_scene(text.text, text.file)) {
    if (!candidates.empty()) {
      throw InputError({ErrorKind::usage, text.file.string(), "candidates",
                        "what further coordinates bring Z at every line is not predicted", "compare bound() of two scenes"});
    }
    return plan_lines(text, true, control);
  }
  const std::shared_ptr<ident::Plan> made = ident::make_plan(ident::parse_scene(text.text, text.file));
  const auto keep = [&so_far, made](const tasks::BoundReport& report) {
    so_far.put([made, kept = report]() mutable {
      kept.interrupted = true;
      return outcome_of(made, std::make_shared<const tasks::BoundReport>(kept));
    });
  };
  const auto found = std::make_shared<const tasks::BoundReport>(tasks::predict_bound(*made, candidates, control, keep));
  const std::string note = found->interrupted ? "" : tasks::suspect_note(*made, control);
  if (!note.empty()) made->notes.push_back(note);
  return outcome_of(made, found);
}

}  // namespace jointid::python
