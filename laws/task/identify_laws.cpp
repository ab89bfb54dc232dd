#include "laws/task/identify_laws.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "base/statistics.hpp"
#include "laws/task/contradiction.hpp"

namespace jointid::laws {
namespace {

using response::LawCandidate;
using response::LawFit;
using response::LawFitEnd;

/// Every choice of one law for each joint that is not tied; tied ones follow.
std::vector<std::vector<std::string>> combinations(const LawScene& scene) {
  std::vector<std::vector<std::string>> all = {{}};
  for (std::size_t j = 0; j < scene.joints.size(); ++j) {
    const auto leader = scene.constraints.leader(j);
    std::vector<std::vector<std::string>> longer;
    for (const auto& before : all) {
      for (const std::string& law : leader ? std::vector<std::string>{before[*leader]} : scene.joints[j].laws) {
        longer.push_back(before);
        longer.back().push_back(law);
      }
    }
    all = std::move(longer);
  }
  return all;
}

/// χ² of the freedom above which data contradict laws and deviations, at 4 deviations.
bool is_poor(const LawFit& fit) { return fit.chi_square > chi_square_quantile(static_cast<double>(fit.freedom), 4.0); }

void judge_fit(LawIdentification& found) {
  const LawFit& fit = found.fit();
  switch (fit.status) {
    case LawFitEnd::no_response:
      found.status = Status::no_response;
      found.message = "harmonic balance has no solution for any law to start with: name other laws, or check the forces";
      return;
    case LawFitEnd::too_few_data:
      found.status = Status::too_few_data;
      found.message = fmt::format("{} numbers measured do not fix the unknowns: give more lines or levels", fit.numbers);
      return;
    case LawFitEnd::not_converged:
      found.status = Status::not_converged;
      found.message = "the fit did not end in a minimum: give priors or bounds, or levels that make the joint slip";
      return;
    case LawFitEnd::harmonics_not_enough:
      found.status = Status::doubtful;
      found.message = "harmonics that the parts' lines do not hold may still move the estimate";
      break;
    case LawFitEnd::at_kink:
      found.status = Status::doubtful;
      found.message =
          "χ² bends sharply at the estimate (a loop of one state's motion appears or vanishes): it may be a standard error off";
      break;
    case LawFitEnd::converged:
      break;
  }
  if (!is_poor(fit)) return;
  found.status = Status::poor_fit;
  found.message = fmt::format("χ² = {:.4g} of {} degrees of freedom: the laws or the stated errors are wrong", fit.chi_square,
                              static_cast<long>(fit.freedom));
}

/// Data that agree with no law at all: the fit of one says nothing then.
void judge_data(const LawScene& scene, LawIdentification& found) {
  const response::Consistency& test = found.consistency;
  if (test.freedom == 0) {
    found.notes.push_back("no more responses than joints: nothing shows a wrong sign, gain or label of the data");
  } else if (test.contradicts()) {
    found.status = Status::poor_fit;
    found.message = contradiction_text(test, found.data.responses, level_names(scene));
  } else if (found.status == Status::poor_fit) {
    found.message += fmt::format("; the data do not contradict each other (χ² = {:.4g} of {} without any law): try other laws",
                                 test.chi_square, static_cast<long>(test.freedom));
  }
}

/// Levels that speak for other joints, and joints that no law here describes.
void judge_levels(const LawScene& scene, LawIdentification& found) {
  const LawFit& fit = found.fit();
  const std::vector<response::Joint> joints = joints_of(fit);
  std::vector<std::string> told;
  found.one_sided = test_even_harmonics(found.steps, found.data.structure->joints());
  for (const OneSidedJoint& joint : found.one_sided) {
    if (joint.is_told()) told.push_back(one_sided_text(joint, scene.joints[joint.joint].beside.name));
  }
  if (!joints.empty()) {
    const response::LawUnknowns unknowns = response::unknowns_of(joints, scene.constraints);
    found.drifts = response::test_level_drift(found.data.structure, found.data.states, found.data.level, unknowns, fit);
    if (!found.drifts.empty() && found.drifts.front().is_told())
      told.push_back(drift_text(found.drifts.front(), scene, unknowns));
  }
  for (std::string& what : told) {
    if (found.status == Status::ok) {
      found.status = Status::doubtful;
      found.message = what;
    }
    found.notes.push_back(std::move(what));
  }
}

/// Laws whose χ² is above that of the chosen one by less than chance moves it in 95 % of the cases: 4 (of one degree), 2 more for
/// every unknown beyond the first that they have less. That a law has more unknowns chooses the simpler one, but is nothing that
/// data say.
void find_rivals(LawIdentification& found) {
  constexpr double by_chance = 4.0, per_unknown = 2.0;
  const LawFit& best = found.fit();
  for (std::size_t i = 0; i < found.compared.size(); ++i) {
    const LawFit& fit = found.compared[i].fit;
    const auto fewer = static_cast<double>(best.values.size() - fit.values.size());
    const double allowed = by_chance + per_unknown * std::max(0.0, fewer - 1.0);
    if (i != found.chosen && response::is_minimum(fit.status) && fit.chi_square <= best.chi_square + allowed)
      found.not_told_apart.push_back(laws_text(found.compared[i].laws));
  }
}

}  // namespace

std::vector<std::string> unseen(const LawScene& scene, const std::vector<response::FittedJoint>& joints) {
  using friction::Knowledge;
  std::vector<std::string> what;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const response::FittedJoint& joint = joints[j];
    if (!joint.joint.friction) continue;
    const std::string& name = scene.joints[j].beside.name;
    if (joint.limit.knowledge == Knowledge::undetermined)
      what.push_back(name + ": the friction limit is not seen: the joint hardly slips; measure a higher level");
    if (joint.limit.knowledge == Knowledge::extrapolated)
      what.push_back(name + ": the friction limit is extrapolated: no state comes near macroslip");
    if (joint.stiffness.knowledge == Knowledge::undetermined)
      what.push_back(name + ": the initial stiffness is not seen: the joint always slips; measure a lower level");
  }
  return what;
}

std::string laws_text(const std::vector<std::string>& laws) {
  std::string text;
  for (const std::string& law : laws) text += (text.empty() ? "" : " + ") + law;
  return text;
}

void require_measured(const LawScene& scene) {
  for (const ForceLevel& level : scene.levels) {
    if (!level.planned) continue;
    throw InputError({.kind = ErrorKind::data,
                      .file = scene.file.string(),
                      .place = "[[data.levels]] " + level.name,
                      .problem = "nothing was measured: there are no responses",
                      .remedy = "give responses; `jointid plan --bound` predicts what the level determines"});
  }
}

std::vector<response::DirectStep> direct_steps(const LevelStates& data) {
  std::vector<response::DirectStep> steps;
  for (const response::MeasuredState& state : data.states) steps.push_back(response::direct_step(*data.structure, state));
  return steps;
}

LawIdentification identify_laws(const LawScene& scene, const response::FitWork& work) {
  require_measured(scene);
  return identify_states(scene, read_level_states(scene), work);
}

LawIdentification identify_states(const LawScene& scene, LevelStates data, const response::FitWork& work) {
  LawIdentification found;
  found.data = std::move(data);
  found.notes = found.data.notes;
  found.steps = direct_steps(found.data);
  found.consistency = response::test_consistency(*found.data.structure, found.data.states, found.data.level);
  std::vector<response::Joint> beside;
  for (const FrictionJoint& joint : scene.joints) beside.push_back(joint.beside);
  found.compared = response::compare_laws(found.data.structure, found.data.states, combinations(scene), beside,
                                          {.harmonics = scene.harmonics, .work = work}, scene.constraints);
  found.chosen = response::chosen_law(found.compared);
  judge_fit(found);
  judge_data(scene, found);
  judge_levels(scene, found);
  find_rivals(found);
  for (std::string& what : unseen(scene, found.fit().joints)) found.notes.push_back(std::move(what));
  return found;
}

}  // namespace jointid::laws
