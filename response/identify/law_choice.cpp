#include "response/identify/law_choice.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include "base/error.hpp"
#include "base/statistics.hpp"
#include "friction/fit/fit_start.hpp"

namespace jointid::response {
namespace {

[[noreturn]] void fail_laws(std::string problem, std::string remedy) {
  throw InputError(
      {.kind = ErrorKind::usage, .file = "", .place = "laws", .problem = std::move(problem), .remedy = std::move(remedy)});
}

/// Unknown springs and dashpots that begin nowhere.
void begin_beside(const std::vector<DirectStep>& steps, const LawConstraints& constraints, std::vector<Joint>& joints) {
  constexpr double share = 0.1;
  for (std::size_t j = 0; j < joints.size() && j < constraints.beside.size(); ++j) {
    const double stiffness = joints[j].friction->response(0.0).tangent;
    for (const std::string& name : constraints.beside[j]) {
      if (name == "stiffness" && !(joints[j].stiffness > 0.0)) joints[j].stiffness = share * stiffness;
      if (name == "damping" && !(joints[j].damping > 0.0)) joints[j].damping = share * stiffness / steps.front().omega;
    }
  }
}

/// Starts of one joint's law.
using StartsOfJoint = std::function<std::vector<Joint>(std::size_t joint)>;

/// One set of joints for each rank of start that every joint has.
std::vector<std::vector<Joint>> together(const std::vector<Joint>& beside, const LawConstraints& constraints,
                                         const StartsOfJoint& starts_of_joint) {
  std::vector<std::vector<Joint>> starts;
  for (std::size_t j = 0; j < beside.size(); ++j) {
    if (const auto leader = constraints.leader(j)) {
      for (std::vector<Joint>& start : starts) {
        start.push_back(beside[j]);
        start.back().friction = start[*leader].friction;
      }
      continue;
    }
    const std::vector<Joint> own = starts_of_joint(j);
    if (j == 0) starts.resize(own.size());
    starts.resize(std::min(starts.size(), own.size()));
    for (std::size_t i = 0; i < starts.size(); ++i) starts[i].push_back(own[i]);
  }
  return starts;
}

/// Where fits of a candidate begin.
struct Starts {
  std::vector<std::vector<Joint>> joints;
  double distance = 0.0;  ///< χ² of the forces of the direct steps at the first
};

/// Starts by the direct steps.
Starts starts_of(const std::vector<DirectStep>& steps, const std::vector<std::string>& laws, const std::vector<Joint>& beside,
                 const LawConstraints& constraints) {
  if (laws.size() != beside.size()) {
    fail_laws(std::to_string(laws.size()) + " laws for " + std::to_string(beside.size()) + " joints", "name one for each joint");
  }
  Starts starts;
  starts.joints = together(beside, constraints, [&](std::size_t j) {
    ForceFit fit = fit_forces(steps, j, laws[j], beside[j]);
    if (!fit.joint.friction) fail_laws("no start of " + laws[j] + " suits joint " + std::to_string(j + 1), "give its values");
    fit.family.insert(fit.family.begin(), fit.joint);
    starts.distance += fit.chi_square;
    return fit.family;
  });
  for (std::vector<Joint>& start : starts.joints) begin_beside(steps, constraints, start);
  return starts;
}

/// Stiffness and limit of a fitted joint; a limit beyond all forces where it has none.
friction::Features features_of(const FittedJoint& joint) {
  constexpr double beyond = 100.0;
  const double stiffness = joint.stiffness.value;
  const bool limited = std::isfinite(joint.limit.value) && joint.limit.knowledge != friction::Knowledge::undetermined;
  return {stiffness, limited ? joint.limit.value : beyond * stiffness * joint.largest_motion};
}

/// Starts that do what the fit of other laws does; what acts beside the laws is that fit's.
std::vector<std::vector<Joint>> starts_like(const LawFit& other, const std::vector<std::string>& laws,
                                            const LawConstraints& constraints) {
  const std::vector<Joint> beside = joints_of(other);
  return together(beside, constraints, [&](std::size_t j) {
    std::vector<Joint> starts;
    for (auto& law : friction::family(laws[j]).starts(features_of(other.joints[j]))) {
      starts.push_back(beside[j]);
      starts.back().friction = std::move(law);
    }
    return starts;
  });
}

std::pair<bool, double> rank(const LawFit& fit) { return {!is_minimum(fit.status), fit.aic}; }

/// Of responses and forces of all states.
std::vector<int> measured_harmonics(const std::vector<MeasuredState>& states) {
  std::set<int> all;
  for (const MeasuredState& state : states) {
    all.insert(state.harmonics.begin(), state.harmonics.end());
    all.insert(state.force.harmonics.begin(), state.force.harmonics.end());
  }
  return {all.begin(), all.end()};
}

/// Of some lines where there are many: starts need no more.
std::vector<DirectStep> direct_steps(const Receptance& structure, const std::vector<MeasuredState>& states) {
  const std::vector<MeasuredState> some = some_lines(states, lines_for_a_start);
  std::vector<DirectStep> steps;
  for (const MeasuredState& state : some.empty() ? states : some) steps.push_back(direct_step(structure, state));
  return steps;
}

/// Whether another start need not be tried: the data do not contradict the fit.
bool is_good(const LawFit& fit) {
  constexpr double far = 5.0;  // deviations of χ²
  return is_minimum(fit.status) && fit.chi_square < chi_square_quantile(static_cast<double>(fit.freedom), far);
}

constexpr double hopeless = 4.0, room = 100.0;  ///< times χ² of the best law and so much more: far behind it

/// Whether another law, which the data do not contradict, leaves the end of a fit far behind.
bool is_beaten(const LawFit& fit, const LawFit* rival) {
  return rival != nullptr && !fit.joints.empty() &&
         chi_square_of_one(fit) > hopeless * chi_square_of_one(*rival) + room / static_cast<double>(fit.freedom);
}

constexpr int most_first_steps = 40;  ///< of a start: what has not come near a minimum by then is no start

/// The best of all starts; `rival`: where two end far behind that one no other is tried.
LawFit best_of(const std::shared_ptr<const Receptance>& structure, const std::vector<MeasuredState>& states,
               const std::vector<std::vector<Joint>>& starts, const LawFitOptions& options, const LawConstraints& constraints,
               const LawFit* rival) {
  constexpr double same = 0.1, far = 2.0;  // of χ², and of χ² of one number
  LawFit best;
  bool again = false;
  int beaten = 0;
  for (std::size_t i = 0; i < starts.size() && !again && beaten < 2 && !(i > 0 && is_good(best)); ++i) {
    LawFit fit = fit_laws(structure, states, unknowns_of(starts[i], constraints), options);
    if (is_beaten(fit, rival)) ++beaten;
    again = i > 0 && is_minimum(fit.status) && is_minimum(best.status) && std::abs(fit.chi_square - best.chi_square) < same &&
            chi_square_of_one(fit) < far;
    if (i == 0 || rank(fit) < rank(best)) best = std::move(fit);
  }
  return best;
}

/// Of all lines from the best fit to so many of them, of other ones where the data contradict it; only if it is as good for all.
/// A wrong start takes as many steps of some lines, and each in a part of the time; where a resonance leads all starts astray,
/// other lines often do not.
std::optional<LawFit> fit_by_some(const std::shared_ptr<const Receptance>& structure, const std::vector<MeasuredState>& states,
                                  std::size_t count, const std::vector<std::vector<Joint>>& starts, const LawFitOptions& options,
                                  const LawConstraints& constraints, const LawFit* rival) {
  constexpr double as_good = 2.0;
  std::optional<LawFit> best;
  for (const double share : {0.5, 0.25, 0.75}) {
    const std::vector<MeasuredState> some = some_lines(states, count, share);
    if (some.empty()) return std::nullopt;
    LawFit found = best_of(structure, some, starts, options, constraints, rival);
    if (is_minimum(found.status) && (!best || chi_square_of_one(found) < chi_square_of_one(*best))) best = std::move(found);
    if (best && (is_good(*best) || is_beaten(*best, rival))) break;
  }
  if (!best) return std::nullopt;
  LawFit fit = fit_laws(structure, states, unknowns_of(joints_of(*best), constraints), options);
  const bool as_well = is_minimum(fit.status) && chi_square_of_one(fit) < as_good * std::max(1.0, chi_square_of_one(*best));
  return as_well ? std::optional(std::move(fit)) : std::nullopt;
}

/// The best of all starts; harmonics are not added yet. Of many lines some tell first where to start, of fewer where no start
/// did.
LawFit first_fit(const std::shared_ptr<const Receptance>& structure, const std::vector<MeasuredState>& states,
                 const std::vector<std::vector<Joint>>& starts, LawFitOptions options, const LawConstraints& constraints,
                 const LawFit* rival = nullptr) {
  constexpr double roughly = 0.01;  // of a deviation
  if (options.harmonics.empty()) {
    options.harmonics = measured_harmonics(states);
    options.steps.enough = roughly;
  }
  options.steps.most_steps = std::min(options.steps.most_steps, most_first_steps);
  if (auto fit = fit_by_some(structure, states, lines_for_a_start, starts, options, constraints, rival)) return std::move(*fit);
  LawFit best = best_of(structure, states, starts, options, constraints, rival);
  if (is_good(best) || is_beaten(best, rival)) return best;
  auto fit = fit_by_some(structure, states, lines_for_a_start / 2, starts, options, constraints, rival);
  return fit && rank(*fit) < rank(best) ? std::move(*fit) : best;
}

/// Laws that the data do not contradict, but that others beat, once more from where the best one is: many can do what it does
/// (all are springs below slip), and ended in a minimum beside.
void begin_again(const std::shared_ptr<const Receptance>& structure, const std::vector<MeasuredState>& states,
                 const LawFitOptions& options, const LawConstraints& constraints, std::vector<LawCandidate>& fitted) {
  constexpr double beaten = 1.0;  // by χ²
  const auto best = std::ranges::min_element(
      fitted, {}, [](const LawCandidate& each) { return std::pair(!is_minimum(each.fit.status), each.fit.chi_square); });
  if (best == fitted.end() || !is_good(best->fit)) return;
  for (LawCandidate& each : fitted) {
    if (!is_good(each.fit) || !(each.fit.chi_square > best->fit.chi_square + beaten)) continue;
    LawFit again = first_fit(structure, states, starts_like(best->fit, each.laws, constraints), options, constraints);
    if (is_minimum(again.status) && again.chi_square < each.fit.chi_square) each.fit = std::move(again);
  }
}

/// From the first fit as the options say.
LawFit last_fit(const std::shared_ptr<const Receptance>& structure, const std::vector<MeasuredState>& states, LawFit first,
                const LawFitOptions& options, const LawConstraints& constraints) {
  if (!options.harmonics.empty() || first.joints.empty()) return first;
  LawFitOptions further = options;
  if (is_minimum(first.status)) further.from = first.end;
  LawFit fit = fit_laws(structure, states, unknowns_of(joints_of(first), constraints), further);
  if (is_minimum(fit.status) || !is_minimum(first.status)) return fit;
  first.status = LawFitEnd::harmonics_not_enough;
  return first;
}

}  // namespace

std::vector<std::vector<Joint>> law_starts(const Receptance& structure, const std::vector<MeasuredState>& states,
                                           const std::vector<std::string>& laws, const std::vector<Joint>& beside,
                                           const LawConstraints& constraints) {
  return starts_of(direct_steps(structure, states), laws, beside, constraints).joints;
}

LawFit fit_from(const std::shared_ptr<const Receptance>& structure, const std::vector<MeasuredState>& states,
                const std::vector<std::vector<Joint>>& starts, const LawFitOptions& options, const LawConstraints& constraints) {
  return last_fit(structure, states, first_fit(structure, states, starts, options, constraints), options, constraints);
}

std::vector<LawCandidate> compare_laws(const std::shared_ptr<const Receptance>& structure,
                                       const std::vector<MeasuredState>& states,
                                       const std::vector<std::vector<std::string>>& candidates, const std::vector<Joint>& beside,
                                       const LawFitOptions& options, const LawConstraints& constraints) {
  const std::vector<DirectStep> steps = direct_steps(*structure, states);
  std::vector<std::pair<Starts, std::vector<std::string>>> nearest_first;
  for (const std::vector<std::string>& laws : candidates)
    nearest_first.emplace_back(starts_of(steps, laws, beside, constraints), laws);
  std::ranges::stable_sort(nearest_first, {}, [](const auto& each) { return each.first.distance; });
  std::vector<LawCandidate> fitted;
  std::optional<LawFit> rival;  // the best of those that the data do not contradict
  double least = std::numeric_limits<double>::infinity();
  for (auto& [starts, laws] : nearest_first) {
    if (rival) {
      const std::vector<std::vector<Joint>> like = starts_like(*rival, laws, constraints);
      if (!like.empty() && !starts.joints.empty()) starts.joints.insert(starts.joints.begin() + 1, like.front());
    }
    fitted.push_back({laws, first_fit(structure, states, starts.joints, options, constraints, rival ? &*rival : nullptr)});
    const LawFit& fit = fitted.back().fit;
    if (is_minimum(fit.status)) least = std::min(least, fit.aic);
    if (is_good(fit) && (!rival || fit.aic < rival->aic)) rival = fit;
  }
  begin_again(structure, states, options, constraints, fitted);
  for (LawCandidate& each : fitted) {
    const bool is_hopeless = each.fit.joints.empty() || each.fit.aic > hopeless * least + room;
    if (!is_hopeless) each.fit = last_fit(structure, states, std::move(each.fit), options, constraints);
  }
  std::ranges::stable_sort(fitted, {}, [](const LawCandidate& each) { return rank(each.fit); });
  return fitted;
}

std::size_t chosen_law(const std::vector<LawCandidate>& compared) {
  constexpr double as_good = 2.0;
  std::size_t chosen = 0;
  for (std::size_t i = 1; i < compared.size() && is_minimum(compared[i].fit.status); ++i) {
    const LawFit& fit = compared[i].fit;
    if (fit.aic > compared[0].fit.aic + as_good) break;
    if (fit.values.size() < compared[chosen].fit.values.size()) chosen = i;
  }
  return chosen;
}

}  // namespace jointid::response
