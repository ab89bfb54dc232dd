#include "problems/thesis/reproduction.hpp"

#include <algorithm>
#include <map>

#include "frf/noise/noise.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/problem.hpp"
#include "problems/thesis/median_floor.hpp"

namespace jointid::problems {
namespace {

/// The trials of one run of a table and what it takes to read them.
struct Outcome {
  std::vector<study::Trial> trials;
  std::vector<Kind> judged;
  restrictions::Restriction restriction;
};

ident::Scene scene_of(const TableRun& run, const Problem& problem) {
  ident::Scene result = scene(problem);
  if (!run.equations.empty()) result.identify.equations = run.equations;
  if (run.weighting) result.identify.weighting = *run.weighting;
  if (run.delta) result.identify.delta = *run.delta;
  if (run.range_hz) result.frequency.range_hz = run.range_hz;
  return result;
}

std::shared_ptr<const study::TrialData> data_with_floor(const ident::Scene& scene, const Problem& problem, double share) {
  const study::Measurements clean{problem.substructures, {problem.assembly}};
  const auto pollute = [&problem, clean, share](std::uint64_t seed, std::uint64_t trial, study::Measurements& data) {
    const auto& model = std::get<frf::NoiseModel>(problem.noise);
    std::uint64_t set = 0;
    for (frf::FrfSet& part : data.substructures) part = frf::polluted(part, model, seed, trial, set++);
    for (frf::FrfSet& whole : data.assembly) whole = frf::polluted(whole, model, seed, trial, set++);
    add_median_floor(data, clean, share, seed, trial);
  };
  return study::make_trial_data(scene, clean, pollute);
}

Outcome run_trials_of(const TableRun& run, const Problem& problem, const study::TrialOptions& options) {
  const ident::Scene chosen = scene_of(run, problem);
  const auto data = run.median_floor > 0.0 ? data_with_floor(chosen, problem, run.median_floor) : trial_data(chosen, problem);
  return {study::run_trials(data, options), data->judged, restrictions::build(chosen.joints)};
}

std::vector<double> figures(const Outcome& outcome, const TableEntry& entry) {
  const auto place = static_cast<std::size_t>(std::ranges::find(outcome.judged, entry.kind) - outcome.judged.begin());
  std::vector<double> values;
  for (const study::Trial& trial : outcome.trials) {
    values.push_back(
        study::figure_of(trial, place, entry.figure == TableFigure::rjcf ? &ident::Quality::rjcf : &ident::Quality::arvf));
  }
  return values;
}

std::vector<double> elements(const Outcome& outcome, const TableEntry& entry, const Problem& problem) {
  const double unit = entry.unit > 0.0 ? entry.unit : problem.truth.at(entry.kind)[entry.i][entry.j];
  const std::vector<TableTerm> terms = entry.sum.empty() ? std::vector<TableTerm>{{1.0, entry.i, entry.j}} : entry.sum;
  const std::size_t size = problem.joint_dofs.size();
  std::vector<double> values;
  for (const study::Trial& trial : outcome.trials) {
    if (!ident::is_usable(trial.status)) continue;
    const std::vector<double> matrix = outcome.restriction.matrix(entry.kind, trial.values);
    double sum = 0.0;
    for (const TableTerm& term : terms) sum += term.factor * matrix[term.i * size + term.j];
    values.push_back(sum / unit);
  }
  return values;
}

Reproduced judged(const Print& print, std::vector<double> values) {
  const Spread ours = spread(std::move(values));
  return {ours, ours.low <= print.value + print.half_unit && print.value - print.half_unit <= ours.high};
}

}  // namespace

std::vector<Reproduced> reproduce(const ThesisTable& table, const study::TrialOptions& options) {
  std::map<std::string, Problem> problems;
  std::vector<Reproduced> result(table.entries.size());
  for (std::size_t r = 0; r < table.runs.size(); ++r) {
    const TableRun& run = table.runs[r];
    auto found = problems.find(run.problem);
    if (found == problems.end()) found = problems.emplace(run.problem, make(run.problem)).first;
    Problem problem = found->second;
    if (run.noise_free) problem.noise = frf::NoiseModel{.level = 0.0};
    const Outcome outcome = run_trials_of(run, problem, study::counting_parts(options, r, table.runs.size()));
    for (std::size_t e = 0; e < table.entries.size(); ++e) {
      const TableEntry& entry = table.entries[e];
      if (entry.run != r) continue;
      const bool element = entry.figure == TableFigure::element;
      result[e] = judged(entry.print, element ? elements(outcome, entry, found->second) : figures(outcome, entry));
    }
  }
  return result;
}

}  // namespace jointid::problems
