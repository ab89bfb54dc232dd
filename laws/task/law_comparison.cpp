#include "laws/task/law_comparison.hpp"

#include <array>
#include <cmath>
#include <mutex>
#include <optional>

#include "base/control.hpp"
#include "base/statistics.hpp"
#include "base/stopwatch.hpp"
#include "laws/task/identify_laws.hpp"
#include "laws/task/simulated_levels.hpp"
#include "laws/task/two_steps.hpp"
#include "study/trial_threads.hpp"

namespace jointid::laws {
namespace {

/// Stiffness and limit of every joint in turn, by one way; NaN where there is no answer.
struct Answer {
  std::vector<double> values;
  double seconds = 0.0;
};

Answer by_likelihood(const LawScene& scene, LevelStates data) {
  const Clock::time_point start = Clock::now();
  Answer out{std::vector<double>(2 * scene.joints.size(), nan), 0.0};
  const LawIdentification found = identify_states(scene, std::move(data));
  for (std::size_t j = 0; is_usable(found.status) && j < found.fit().joints.size(); ++j) {
    out.values[2 * j] = found.fit().joints[j].stiffness.value;
    out.values[2 * j + 1] = found.fit().joints[j].limit.value;
  }
  out.seconds = seconds_since(start);
  return out;
}

Answer by_two_steps(const std::vector<std::string>& laws, const LevelStates& data) {
  const Clock::time_point start = Clock::now();
  Answer out;
  for (const auto& [stiffness, limit] : two_steps(direct_steps(data), laws)) {
    out.values.push_back(stiffness);
    out.values.push_back(limit);
  }
  out.seconds = seconds_since(start);
  return out;
}

WayError error_of(const std::vector<std::optional<std::array<Answer, 2>>>& trials, std::size_t way, std::size_t value,
                  double truth) {
  std::vector<double> found;
  for (const auto& trial : trials) {
    if (trial && std::isfinite((*trial)[way].values[value])) found.push_back((*trial)[way].values[value]);
  }
  const auto [bias, rms] = errors_about(truth, found);
  return {found.size(), bias, rms};
}

/// The scene with the assumed laws alone.
LawScene with_known_laws(LawScene scene, const AssumedStates& assumed) {
  for (std::size_t j = 0; j < scene.joints.size(); ++j) scene.joints[j].laws = {assumed.laws[j]};
  scene.harmonics = assumed.harmonics;
  return scene;
}

bool is_compared(const StudiedValue& value) { return value.name == "initial stiffness" || value.name == "friction limit"; }

}  // namespace

LawComparison compare_law_ways(const LawScene& scene, const LawStudyOptions& options) {
  const AssumedStates assumed = assumed_states(scene);
  const LawScene known = with_known_laws(scene, assumed);
  LawComparison out;
  out.laws = assumed.laws;
  out.assumed = assumed.told;
  out.trials = options.trials;
  out.notes = assumed.data.notes;
  std::vector<std::optional<std::array<Answer, 2>>> trials(options.trials);
  std::mutex mutex;
  std::size_t done = 0;
  const auto both_ways = [&](std::size_t trial) {
    stop_if(options.interrupted);
    if (const auto data = simulated_levels(assumed, options.seed, trial))
      trials[trial] = {by_likelihood(known, *data), by_two_steps(assumed.laws, *data)};
    const std::scoped_lock lock(mutex);
    if (options.progress) options.progress(++done, trials.size());
  };
  study::work_through(trials.size(), options.threads, options.interrupted, [&]() -> study::TrialWork { return both_ways; });
  for (std::size_t way = 0; way < out.ways.size(); ++way) {
    std::vector<double> seconds;
    for (const auto& trial : trials) {
      if (trial) seconds.push_back((*trial)[way].seconds);
    }
    if (way == 0) out.without_response = trials.size() - seconds.size();
    out.seconds.push_back(seconds.empty() ? nan : median(seconds));
  }
  for (const StudiedValue& value : law_study_plan(scene, assumed).values) {
    if (!is_compared(value)) continue;
    ComparedValue compared{value.joint, value.name, value.unit, value.truth, value.bound, {}};
    for (std::size_t way = 0; way < out.ways.size(); ++way)
      compared.ways.push_back(error_of(trials, way, out.values.size(), value.truth));
    out.values.push_back(std::move(compared));
  }
  return out;
}

}  // namespace jointid::laws
