#include "study/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <optional>

#include "base/error.hpp"

namespace jointid::study {
namespace {

using Data = std::shared_ptr<const TrialData>;

void require_truth(const ident::Scene& scene) {
  if (!scene.truth.empty()) return;
  throw InputError({ErrorKind::usage, scene.file.string(), "[truth]", "it is missing: errors need the exact joint",
                    "add it, e.g. from a model of the rig, or use a built-in problem (jointid problem list)"});
}

ident::Scene scene_for(ident::Scene scene, const Way& way) {
  scene.identify.method = way.method;
  scene.identify.automatic = false;
  scene.identify.equations = way.equations;
  scene.identify.weighting = way.weighting;
  scene.identify.delta = way.delta;
  scene.identify.solver = way.solver;
  scene.data.regenerate = way.regenerate;
  return scene;
}

bool same_data(const Way& a, const Way& b) {
  return a.method == b.method && a.equations == b.equations && a.regenerate == b.regenerate;
}

Spread spread_of(const std::vector<Trial>& trials, std::size_t matrix, double ident::Quality::*figure) {
  std::vector<double> values;
  for (const Trial& trial : trials) values.push_back(figure_of(trial, matrix, figure));
  return spread(std::move(values));
}

/// Mean of estimate/truth − 1 over the trials with status ok; empty when there is none.
std::optional<double> mean_error(const std::vector<Trial>& trials, std::size_t unknown, double truth) {
  double sum = 0.0, count = 0.0;
  for (const Trial& trial : trials) {
    if (!is_usable(trial.status)) continue;
    sum += trial.values[unknown] / truth - 1.0;
    count += 1.0;
  }
  return count > 0.0 ? std::optional(sum / count) : std::nullopt;
}

double bias_of(const std::vector<Trial>& trials, const TrialData& data, restrictions::Kind kind) {
  double squares = 0.0, count = 0.0;
  for (std::size_t i = 0; i < data.unknowns.size(); ++i) {
    const TrialUnknown& unknown = data.unknowns[i];
    if (unknown.kind != kind || unknown.truth.value_or(0.0) == 0.0) continue;
    if (const auto error = mean_error(trials, i, *unknown.truth)) {
      squares += *error * *error;
      count += 1.0;
    }
  }
  return std::sqrt(squares / count);
}

double median_time(const std::vector<Trial>& trials) {
  std::vector<double> times;
  for (const Trial& trial : trials) times.push_back(trial.solve_s);
  return spread(std::move(times)).median;
}

Combination summarise(const std::vector<Trial>& trials, const TrialData& data, Way way) {
  Combination out{.way = std::move(way), .matrices = {}, .statuses = {}, .solve_s = median_time(trials)};
  for (std::size_t m = 0; m < data.judged.size(); ++m) {
    out.matrices.push_back({.kind = data.judged[m],
                            .rjcf = spread_of(trials, m, &ident::Quality::rjcf),
                            .arvf = spread_of(trials, m, &ident::Quality::arvf),
                            .rms_relative_error = spread_of(trials, m, &ident::Quality::rms_relative_error),
                            .bias = bias_of(trials, data, data.judged[m])});
  }
  for (const Trial& trial : trials) {
    ++out.statuses[trial.status];
    out.accumulator_bytes = std::max(out.accumulator_bytes, trial.accumulator_bytes);
  }
  return out;
}

/// Runs the ways one after the other and keeps the data of the last method and equation set.
class Comparer {
 public:
  Comparer(const ident::Scene& scene, const TrialSource& source) : scene_(scene), source_(source) {}

  Combination run(const Way& way, const TrialOptions& options) {
    if (!data_ || !same_data(way, loaded_)) {
      data_ = source_(scene_for(scene_, way));
      loaded_ = way;
    }
    const Data data = with_way(*data_, way);
    Way used = way;
    const TrialRunner runner(data);
    used.equations = runner.plan().equations;
    used.solver = runner.plan().solver;
    return summarise(run_trials(data, options), *data, std::move(used));
  }

 private:
  const ident::Scene& scene_;
  const TrialSource& source_;
  Data data_;
  Way loaded_;
};

bool dominates(double error, double time, double other_error, double other_time) {
  return error <= other_error && time <= other_time && (error < other_error || time < other_time);
}

/// The list, or the scene's own choice when it is empty.
template <class T>
std::vector<T> or_own(std::vector<T> list, const T& own) {
  if (list.empty()) list.push_back(own);
  return list;
}

std::vector<Way> combinations_of_data(const ident::IdentifySection& identify, const Alternatives& alternatives) {
  std::vector<Way> ways;
  for (const ident::Method method : or_own(alternatives.methods, identify.method)) {
    const auto own = method == identify.method ? identify.equations : std::vector<ident::Equation>();
    for (const auto& equations : or_own(alternatives.equations, own)) {
      for (const ident::Solver solver : or_own(alternatives.solvers, identify.solver)) {
        if (!weighs_equations(method)) {
          ways.push_back({method, equations, identify.weighting, identify.delta, solver, {}});
          continue;
        }
        for (const auto weighting : or_own(alternatives.weightings, identify.weighting)) {
          for (const double delta : or_own(alternatives.deltas, identify.delta)) {
            ways.push_back({method, equations, weighting, delta, solver, {}});
          }
        }
      }
    }
  }
  return ways;
}

}  // namespace

std::vector<Way> combinations(const ident::IdentifySection& identify, const Alternatives& alternatives,
                              const ident::Regeneration& regenerate) {
  std::vector<Way> ways;
  for (const ident::Regeneration& chosen : or_own(alternatives.regenerations, regenerate)) {
    for (Way& way : combinations_of_data(identify, alternatives)) {
      way.regenerate = chosen;
      ways.push_back(std::move(way));
    }
  }
  return ways;
}

std::shared_ptr<const TrialData> with_way(const TrialData& data, const Way& way) {
  auto changed = std::make_shared<TrialData>(data);
  changed->scene.identify.weighting = way.weighting;
  changed->scene.identify.delta = way.delta;
  changed->scene.identify.solver = way.solver;
  return changed;
}

Comparison compare(const ident::Scene& scene, const std::vector<Way>& ways, const TrialSource& source,
                   const TrialOptions& options, const std::function<void(const Comparison&)>& so_far) {
  require_truth(scene);
  Comparison out;
  std::exception_ptr refused;
  Comparer comparer(scene, source);
  for (std::size_t i = 0; i < ways.size(); ++i) {
    try {
      out.combinations.push_back(comparer.run(ways[i], counting_parts(options, i, ways.size())));
    } catch (const InputError& error) {
      out.left_out.push_back({ways[i], error.what()});
      if (!refused) refused = std::current_exception();
    }
    if (so_far) so_far(out);
  }
  if (out.combinations.empty() && refused) std::rethrow_exception(refused);
  mark_fronts(out.combinations);
  return out;
}

void mark_fronts(std::vector<Combination>& combinations) {
  for (Combination& own : combinations) {
    for (std::size_t m = 0; m < own.matrices.size(); ++m) {
      const double error = own.matrices[m].rms_relative_error.median;
      own.matrices[m].on_front = !std::isnan(error) && std::ranges::none_of(combinations, [&](const Combination& other) {
        return dominates(other.matrices[m].rms_relative_error.median, other.solve_s, error, own.solve_s);
      });
    }
  }
}

}  // namespace jointid::study
