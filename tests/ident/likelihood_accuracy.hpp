#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "problems/case/in_memory.hpp"
#include "problems/problem.hpp"
#include "study/trial_loop.hpp"
#include "tasks/bound.hpp"

namespace jointid::ident {

/// Scene and data of a built-in problem for method "likelihood".
struct LikelihoodCase {
  explicit LikelihoodCase(const std::string& name, std::vector<Equation> equations = {Equation::nn, Equation::nj})
      : problem(problems::make(name)), scene(problems::scene(problem)) {
    scene.identify.method = Method::likelihood;
    scene.identify.equations = std::move(equations);
    for (const problems::ExactUnknown& unknown : problem.unknowns) truth.push_back(unknown.value);
  }

  /// The problem's noise with another level.
  LikelihoodCase& at(double level) {
    frf::NoiseModel& model = std::get<frf::NoiseModel>(problem.noise);
    model.level = level;
    scene.noise = NoiseSection{.model = frf::name(model.kind), .level = level, .frf_model = model};
    return *this;
  }

  /// On exact FRFs.
  std::vector<double> bound() const {
    return tasks::cramer_rao_bound(*problems::plan(scene, {problem.substructures, problem.assembly}), truth, {});
  }

  problems::Problem problem;
  Scene scene;
  std::vector<double> truth;
};

/// What many trials of a case say about the unknowns of a kind that are not zero.
struct Accuracy {
  double mean = 0.0, worst = 0.0;  ///< rms error over `bound`
  double covered = 0.0, intervals = 0.0;
  std::size_t failed = 0;

  double coverage() const { return covered / intervals; }
  /// Four standard deviations below 95 %, as if the unknowns of a trial were one: they are correlated.
  double least_coverage(std::size_t trials) const { return 0.95 - 4.0 * std::sqrt(0.95 * 0.05 / double(trials)); }
};

inline Accuracy accuracy_of(const std::vector<study::Trial>& trials, const study::TrialData& data, const std::vector<double>& truth,
                            const std::vector<double>& bound, restrictions::Kind kind) {
  Accuracy out;
  double count = 0.0;
  for (std::size_t u = 0; u < truth.size(); ++u) {
    if (truth[u] == 0.0 || data.unknowns[u].kind != kind) continue;
    double squares = 0.0;
    for (const study::Trial& trial : trials) {
      squares += std::pow(trial.values[u] - truth[u], 2.0);
      out.covered += (*trial.ci95[u])[0] <= truth[u] && truth[u] <= (*trial.ci95[u])[1];
      ++out.intervals;
    }
    const double ratio = std::sqrt(squares / double(trials.size())) / bound[u];
    out.mean += ratio;
    out.worst = std::max(out.worst, ratio);
    ++count;
  }
  out.mean /= count;
  for (const study::Trial& trial : trials) out.failed += trial.status != Status::ok;
  return out;
}

inline Accuracy accuracy_of(const LikelihoodCase& run, const std::vector<double>& bound, std::size_t trials,
                            restrictions::Kind kind = restrictions::Kind::stiffness) {
  const auto data = problems::trial_data(run.scene, run.problem);
  return accuracy_of(study::run_trials(data, {.trials = trials}), *data, run.truth, bound, kind);
}

}  // namespace jointid::ident
