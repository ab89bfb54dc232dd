#include "python/trials.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "base/control.hpp"
#include "base/error.hpp"
#include "base/parallel.hpp"
#include "ident/scene/read_scene.hpp"
#include "laws/scene/read_law_scene.hpp"
#include "laws/task/law_comparison.hpp"
#include "python/outputs.hpp"
#include "report/laws/law_comparison_text.hpp"
#include "report/laws/law_study_page.hpp"
#include "report/laws/law_study_text.hpp"
#include "report/result/comparison_page.hpp"
#include "report/result/comparison_text.hpp"
#include "report/result/study_page.hpp"
#include "report/result/study_text.hpp"
#include "scene/kind.hpp"
#include "study/trial_data.hpp"
#include "tasks/compare/compare_ways.hpp"
#include "tasks/study/run_law_study.hpp"
#include "tasks/study/run_study.hpp"

namespace jointid::python {
namespace {

void require_trials(std::size_t trials) {
  if (trials == 0) throw InputError({ErrorKind::usage, "", "trials", "it is 0", "give 1 or more"});
}

std::function<void(std::size_t, std::size_t)> of_trials(const ident::Control& control) {
  return [&control](std::size_t done, std::size_t total) { control.progress("trial", done, total); };
}

laws::LawStudyOptions law_options(std::size_t trials, std::uint64_t seed, const ident::Control& control) {
  laws::LawStudyOptions options;
  options.trials = trials;
  options.seed = seed;
  options.threads = threads_or_cores(control.threads);
  options.interrupted = control.interrupted;
  options.progress = of_trials(control);
  return options;
}

Outcome study_laws(const SceneText& text, const StudyTask& task, const ident::Control& control) {
  const auto scene = std::make_shared<const laws::LawScene>(laws::parse_law_scene(text.text, text.file));
  refuse_inputs(task.out, laws::files_of(*scene));
  const auto found = std::make_shared<const laws::LawStudy>(
      tasks::run_law_study(*scene, {task.out, text.text, task.resume}, law_options(task.trials, task.seed, control)));
  return {.status = {},
          .message = {},
          .usable = found->usable > 0,
          .json = [=] { return report::law_study_json(*found); },
          .text = [=] { return report::law_study_text(*scene, *found); },
          .csv = [=] { return report::law_study_csv(*found); },
          .page = [=](const ident::Control&) { return report::law_study_page(*scene, *found); }};
}

study::StudyOptions study_options(const SceneText& text, const StudyTask& task, const ident::Control& control) {
  study::StudyOptions options;
  options.trials = task.trials;
  options.seed = task.seed;
  options.threads = threads_or_cores(control.threads);
  options.resume = task.resume;
  options.out = task.out;
  options.texts = tasks::study_texts(text.text);
  return options;
}

Outcome compare_laws(const SceneText& text, const CompareTask& task, const ident::Control& control) {
  const auto scene = std::make_shared<const laws::LawScene>(laws::parse_law_scene(text.text, text.file));
  const bool asked = !(task.methods.empty() && task.weightings.empty() && task.solvers.empty() && task.regenerate.empty() &&
                       task.equations.empty() && task.deltas.empty());
  if (asked) {
    throw InputError({ErrorKind::usage, text.file.string(), "compare",
                      "the scene is one of friction laws: its ways are the likelihood and two steps", "name no others"});
  }
  const auto found =
      std::make_shared<const laws::LawComparison>(laws::compare_law_ways(*scene, law_options(task.trials, task.seed, control)));
  return {.status = {},
          .message = {},
          .usable = std::ranges::any_of(found->values, [](const auto& value) { return value.ways.front().answers > 0; }),
          .json = [=] { return report::law_comparison_json(*found); },
          .text = [=] { return report::law_comparison_text(*scene, *found); },
          .csv = [=] { return report::law_comparison_csv(*found); },
          .page = [=](const ident::Control&) { return report::law_comparison_page(*scene, *found); }};
}

study::Alternatives alternatives(const CompareTask& task) {
  study::Alternatives out;
  for (const std::string& word : task.methods) out.methods.push_back(ident::parse_method(word));
  for (const std::vector<std::string>& words : task.equations) {
    std::vector<ident::Equation>& set = out.equations.emplace_back();
    for (const std::string& word : words) set.push_back(ident::parse_equation(word));
  }
  for (const std::string& word : task.weightings) out.weightings.push_back(weighting::parse_weighting(word));
  for (const std::string& word : task.regenerate) out.regenerations.push_back(ident::parse_regeneration(word));
  out.deltas = task.deltas;
  for (const std::string& word : task.solvers) out.solvers.push_back(ident::parse_solver(word));
  return out;
}

Outcome outcome_of(tasks::ComparisonResult ways, const std::shared_ptr<const ident::Scene>& scene) {
  const auto found = std::make_shared<const tasks::ComparisonResult>(std::move(ways));
  return {.status = {},
          .message = {},
          .usable = tasks::some_usable(*found),
          .json = [=] { return report::comparison_json(*found); },
          .text = [=] { return report::comparison_text(*found); },
          .csv = [=] { return report::comparison_csv(*found); },
          .page = [=](const ident::Control&) { return report::comparison_page(*found, *scene); }};
}

Outcome interrupted_outcome(tasks::ComparisonResult ways, const std::shared_ptr<const ident::Scene>& scene) {
  ways.comparison.interrupted = true;
  study::mark_fronts(ways.comparison.combinations);
  Outcome out = outcome_of(std::move(ways), scene);
  out.message = "Interrupted: the ways that were finished.";
  return out;
}

void require_delta(double delta) {
  if (delta >= 0.0 && delta < 2.0) return;
  throw InputError({ErrorKind::usage, "", "deltas", std::to_string(delta) + " is outside 0 <= delta < 2", "0 drops no equation"});
}

}  // namespace

Outcome study(const SceneText& text, const StudyTask& task, const ident::Control& control) {
  require_trials(task.trials);
  if (scene::is_law_scene(text.text, text.file)) return study_laws(text, task, control);
  const ident::Scene scene = ident::parse_scene(text.text, text.file);
  refuse_inputs(task.out, ident::files_of(scene));
  const auto data = study::load_trial_data(scene);
  study::StudyControl watch;
  watch.progress = of_trials(control);
  watch.interrupted = control.interrupted;
  const auto found =
      std::make_shared<const tasks::StudyResult>(tasks::run_study(data, study_options(text, task, control), watch));
  if (!found->run.complete) throw Interrupted();
  return {.status = {},
          .message = {},
          .usable = found->statistics.usable > 0,
          .json = [=] { return report::study_json(*found); },
          .text = [=] { return report::study_text(*found); },
          .csv = [=] { return report::study_csv(*found); },
          .page =
              [=](const ident::Control&) {
                return report::study_page(*found, data->scene,
                                          tasks::study_histograms(found->file, found->statistics, report::most_unknowns_shown));
              }};
}

Outcome compare(const SceneText& text, const CompareTask& task, const ident::Control& control, SoFar& so_far) {
  require_trials(task.trials);
  if (scene::is_law_scene(text.text, text.file)) return compare_laws(text, task, control);
  std::ranges::for_each(task.deltas, require_delta);
  const auto scene = std::make_shared<const ident::Scene>(ident::parse_scene(text.text, text.file));
  study::TrialOptions options;
  options.trials = task.trials;
  options.seed = task.seed;
  options.threads = control.threads;
  options.progress = of_trials(control);
  options.interrupted = control.interrupted;
  const auto keep = [&so_far, scene](const tasks::ComparisonResult& ways) {
    so_far.put([kept = ways, scene] { return interrupted_outcome(kept, scene); });
  };
  return outcome_of(tasks::compare_ways(*scene, alternatives(task), options, keep), scene);
}

}  // namespace jointid::python
