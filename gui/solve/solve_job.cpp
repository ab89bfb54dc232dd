#include "gui/solve/solve_job.hpp"

#include <QDateTime>
#include <algorithm>
#include <cmath>

#include "base/control.hpp"
#include "gui/look/said.hpp"
#include "gui/work/control_of.hpp"
#include "ident/identify.hpp"
#include "ident/scene/scene_files.hpp"
#include "report/page/limits.hpp"
#include "report/result/solve_page.hpp"
#include "report/solution_json.hpp"
#include "restrictions/restriction.hpp"

namespace jointid::gui {
namespace {

constexpr std::size_t passes_around_iterations = 3;               // over the lines: reading, predicting, the check of the data
constexpr std::uintmax_t quick_bytes = std::uintmax_t{64} << 20;  // of files whose headers are read at once

Curve curve_of(const tasks::Regenerated& all, const tasks::RegeneratedFrf& frf, bool is_measured, const std::string& name) {
  Curve curve;
  curve.name = name + "  " + frf.entry.response.name() + " / " + frf.entry.reference.name();
  curve.response = frf.entry.response;
  curve.reference = frf.entry.reference;
  curve.frequency_hz = all.frequency_hz;
  curve.values = is_measured ? frf.measured : frf.predicted;
  curve.is_measured = is_measured;
  return curve;
}

}  // namespace

bool is_quick_to_plan(const ident::Scene& scene) {
  if (scene.data.regenerate.any() || scene.frequency.exclude_resonances) return false;
  std::uintmax_t bytes = 0;
  for (const auto& file : ident::files_of(scene)) {
    std::error_code none;
    const std::uintmax_t size = std::filesystem::file_size(file.path, none);
    if (!none) bytes += size;
  }
  return bytes <= quick_bytes;
}

std::size_t unknowns_of(const ident::Scene& scene) {
  try {
    return restrictions::build(scene.joints).unknowns.size();
  } catch (const InputError&) {
    return 0;  // pattern "free" without positions: the plan knows them
  }
}

std::vector<std::filesystem::path> inputs_of(const std::optional<ident::Scene>& scene) {
  std::vector<std::filesystem::path> inputs;
  if (!scene) return inputs;
  for (const auto& file : ident::files_of(*scene)) inputs.push_back(file.path);
  return inputs;
}

report::RunInput input_as_it_is(const std::string& file) {
  report::RunInput out{file};
  std::error_code none;
  const std::uintmax_t bytes = std::filesystem::file_size(file, none);
  if (!none) out.bytes = bytes;
  const auto time = std::filesystem::last_write_time(file, none);
  if (!none) out.modified = time.time_since_epoch().count();
  return out;
}

Solved solve_scene(const ident::Scene& scene, const Worker::Watch& watch) {
  Solved solved;
  solved.made = QDateTime::currentDateTime().toString(Qt::ISODate).toStdString();
  for (const std::filesystem::path& file : inputs_of(scene))
    solved.inputs.push_back(input_as_it_is(std::filesystem::absolute(file).string()));
  watch.begin({1, 3, 0.0, 0.05});
  watch.progress("planning", 0, 0);
  solved.plan = ident::make_plan(scene);
  stop_if(watch.interrupted);
  watch.begin({2, 3, 0.05, 0.85, passes_around_iterations + solved.plan->cost.iteration.expected});
  std::optional<ident::Solution> best;
  ident::Control control = control_of(watch);
  control.judgement = ident::Judgement::data;
  tasks::IterationLog log;
  control.so_far = [&](const ident::Solution& solution) {
    best = solution;
    log.note(solution);
  };
  try {
    solved.solution = ident::solve(*solved.plan, control);
  } catch (const Interrupted&) {
    if (!best) throw;
    tasks::mark_interrupted(*best);
    solved.solution = std::move(*best);
    solved.iterations = log.ended(solved.solution);
    return solved;
  }
  solved.iterations = log.ended(solved.solution);
  watch.begin({3, 3, 0.85, 1.0, 2});
  try {
    solved.worth = tasks::worth(*solved.plan, solved.solution, control_of(watch));
  } catch (const Interrupted&) {
    // The solution is there; only its lights are not.
  }
  return solved;
}

tasks::BoundReport predict_bound(const ident::Scene& scene, const std::vector<frf::Dof>& candidates, const Worker::Watch& watch) {
  const auto plan = ident::make_plan(scene);
  return tasks::predict_bound(*plan, candidates, control_of(watch));
}

std::string json_of(const Solved& solved) { return report::solution_json(solved.solution); }

Overlay regenerate_frf(const Solved& solved, const tasks::FrfEntry& entry, const Worker::Watch& watch) {
  const tasks::Regenerated all = tasks::regenerate(*solved.plan, solved.solution.bands, {entry}, control_of(watch));
  const tasks::RegeneratedFrf& frf = all.frfs.front();
  return {{curve_of(all, frf, true, Said::tr("measured").toStdString()),
           curve_of(all, frf, false, Said::tr("synthesised").toStdString())},
          tasks::decibel_error(frf)};
}

void add_regenerated(Overlay& overlay, const Solved& other, const tasks::FrfEntry& entry, const Worker::Watch& watch) {
  if (other.plan == nullptr || other.solution.bands.empty() ||
      !frf::has(tasks::regenerable_responses(*other.plan), entry.response) ||
      !frf::has(tasks::regenerable_references(*other.plan), entry.reference)) {
    return;
  }
  const tasks::Regenerated all = tasks::regenerate(*other.plan, other.solution.bands, {entry}, control_of(watch));
  overlay.curves.push_back(curve_of(all, all.frfs.front(), false, Said::tr("run ").toStdString() + other.name));
}

std::vector<double> outlying_hz(const Solved& solved) {
  const auto& chi_square = solved.solution.fit.chi_square;
  if (!chi_square || solved.plan == nullptr || chi_square->by_line.size() != solved.plan->lines.size()) return {};
  const std::vector<double>& by_line = chi_square->by_line;
  std::vector<std::size_t> lines;
  for (std::size_t i = 0; i < by_line.size(); ++i) {
    if (std::isfinite(by_line[i])) lines.push_back(i);
  }
  std::ranges::stable_sort(lines, std::ranges::greater(), [&](std::size_t line) { return by_line[line]; });
  lines.resize(std::min(lines.size(), chi_square->outlying_lines));
  std::ranges::sort(lines);
  std::vector<double> out;
  for (const std::size_t line : lines) out.push_back(solved.plan->lines[line].frequency_hz);
  return out;
}

std::string report_of(const Solved& solved, const Worker::Watch& watch) {
  const tasks::DetailChoice choice{std::nullopt, report::most_frfs, report::worst_frfs_drawn};
  watch.begin({1, 1, 0.0, 1.0, solved.solution.quality.empty() ? std::size_t{2} : std::size_t{3}});
  tasks::SolutionDetails details = tasks::solution_details(*solved.plan, solved.solution, choice, control_of(watch));
  details.iterations = solved.iterations;
  return report::solve_report(*solved.plan, solved.solution, details);
}

}  // namespace jointid::gui
