#include "laws/task/law_study.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/statistics.hpp"
#include "laws/task/identify_laws.hpp"
#include "laws/task/shared_trials.hpp"
#include "laws/task/simulated_levels.hpp"

namespace jointid::laws {
namespace {

/// Every number of the joints that a fit tells, in one order.
std::vector<std::pair<std::size_t, friction::FittedValue>> values_of(const std::vector<response::FittedJoint>& joints) {
  std::vector<std::pair<std::size_t, friction::FittedValue>> all;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    all.emplace_back(j, joints[j].stiffness);
    all.emplace_back(j, joints[j].limit);
    for (const friction::FittedValue& value : joints[j].parameters) all.emplace_back(j, value);
  }
  return all;
}

/// Makes any trial of a study.
class Trials {
 public:
  Trials(const LawScene& scene, const AssumedStates& assumed, std::uint64_t seed)
      : scene_(scene), assumed_(assumed), seed_(seed) {
    scene_.harmonics = assumed.harmonics;
  }

  LawTrial made(std::size_t trial) const {
    LawTrial out;
    out.trial = trial;
    const auto found = identified(trial);
    if (!found) {
      out.status = "no_response";
      out.chi_square = nan;
      return out;
    }
    out.status = name(found->status);
    out.usable = is_usable(found->status);
    out.laws = laws_text(found->laws());
    out.contradicts = found->consistency.contradicts();
    out.chi_square = chi_square_of_one(found->fit());
    out.undecided = !found->not_told_apart.empty();
    const bool is_right = found->laws() == assumed_.laws;
    out.missed = !is_right && std::ranges::find(found->not_told_apart, laws_text(assumed_.laws)) == found->not_told_apart.end();
    if (!out.usable || !is_right) return out;
    for (const auto& [joint, value] : values_of(found->fit().joints)) {
      const auto interval = value.ci95.value_or(std::array{nan, nan});
      out.values.push_back({value.value, interval[0], interval[1]});
    }
    return out;
  }

 private:
  std::optional<LawIdentification> identified(std::size_t trial) const {
    auto data = simulated_levels(assumed_, seed_, trial);
    return data ? std::optional(identify_states(scene_, std::move(*data))) : std::nullopt;
  }

  LawScene scene_;
  const AssumedStates& assumed_;
  std::uint64_t seed_;
};

void add(const LawTrial& trial, std::vector<StudiedValue>& values) {
  for (std::size_t i = 0; i < std::min(trial.values.size(), values.size()); ++i) {
    const LawTrial::Value& told = trial.values[i];
    if (!std::isfinite(told.value)) continue;
    ++values[i].trials;
    values[i].found.push_back(told.value);
    if (told.low <= values[i].truth && values[i].truth <= told.high) ++values[i].covered;
  }
}

}  // namespace

LawStudy law_study_plan(const LawScene& scene, const AssumedStates& assumed) {
  LawStudy out;
  out.laws = assumed.laws;
  out.assumed = assumed.told;
  out.notes = assumed.data.notes;
  const response::LawFit bound = response::bound_of_laws(assumed.data.structure, assumed.data.states,
                                                         response::unknowns_of(assumed.joints, scene.constraints), assumed.harmonics);
  for (const auto& [j, value] : values_of(bound.joints)) {
    out.values.push_back({.joint = scene.joints[j].beside.name,
                          .name = value.name,
                          .unit = value.unit,
                          .truth = value.value,
                          .bound = value.std_error.value_or(nan)});
  }
  return out;
}

TrialErrors errors_about(double truth, const std::vector<double>& found) {
  if (found.empty()) return {nan, nan};
  TrialErrors out;
  for (const double value : found) {
    const double error = value - truth;
    out.bias += error;
    out.rms += error * error;
  }
  const auto count = static_cast<double>(found.size());
  return {out.bias / count, std::sqrt(out.rms / count)};
}

LawStudy study_laws(const LawScene& scene, const LawStudyOptions& options) {
  const auto alone = ident::make_team_of_one();
  return *study_laws_together(scene, assumed_states(scene), options, *alone);
}

std::optional<LawStudy> study_laws_together(const LawScene& scene, const AssumedStates& assumed, const LawStudyOptions& options,
                                            ident::Team& team) {
  LawStudy out;
  ident::start_together(team, [&] { out = law_study_plan(scene, assumed); });
  const Trials trials(scene, assumed, options.seed);
  const auto make = [&](std::size_t trial) { return trials.made(trial); };
  const auto all = trials_made_together(make, out.values.size(), options, team);
  if (!all) return std::nullopt;
  out.trials = options.trials;
  const std::string truth = laws_text(assumed.laws);
  for (const LawTrial& trial : *all) {
    ++out.statuses[trial.status];
    if (trial.contradicts) ++out.contradicting;
    if (!trial.usable) continue;
    ++out.usable;
    ++out.chosen[trial.laws];
    out.chi_square += trial.chi_square;
    if (trial.laws == truth) ++out.right;
    if (trial.undecided) ++out.undecided;
    if (trial.missed) ++out.missed;
    add(trial, out.values);
  }
  out.chi_square = out.usable > 0 ? out.chi_square / static_cast<double>(out.usable) : nan;
  for (StudiedValue& value : out.values) {
    const auto [bias, rms] = errors_about(value.truth, value.found);
    value.bias = bias;
    value.rms_error = rms;
  }
  return out;
}

}  // namespace jointid::laws
