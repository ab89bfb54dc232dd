#include "laws/task/law_bound.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "base/complex.hpp"
#include "laws/task/assumed_states.hpp"
#include "laws/task/identify_laws.hpp"

namespace jointid::laws {
namespace {

constexpr double nothing_known = 1e3;  ///< relative deviation that counts for a number that is not seen

/// What the levels that `wanted` names would tell.
class Predictor {
 public:
  Predictor(const LawScene& scene, const AssumedStates& assumed)
      : scene_(scene),
        data_(assumed.data),
        unknowns_(response::unknowns_of(assumed.joints, scene.constraints)),
        harmonics_(assumed.harmonics) {}

  LevelsBound of(const std::set<std::size_t>& wanted) const {
    std::vector<response::MeasuredState> states;
    for (std::size_t i = 0; i < data_.states.size(); ++i) {
      if (wanted.contains(data_.level[i])) states.push_back(data_.states[i]);
    }
    LevelsBound bound;
    bound.size = std::numeric_limits<double>::quiet_NaN();
    bound.status = response::LawFitEnd::too_few_data;
    if (states.empty()) return bound;
    response::LawFit found = response::bound_of_laws(data_.structure, states, unknowns_, harmonics_);
    bound.status = found.status;
    bound.joints = std::move(found.joints);
    bound.unseen = unseen(scene_, bound.joints);
    double sum = 0.0;
    for (const response::FittedJoint& joint : bound.joints) {
      for (const friction::FittedValue* value : {&joint.stiffness, &joint.limit})
        sum += std::log(value->std_error ? std::min(*value->std_error / value->value, nothing_known) : nothing_known);
    }
    if (!bound.joints.empty()) bound.size = std::exp(sum / (2.0 * static_cast<double>(bound.joints.size())));
    return bound;
  }

 private:
  const LawScene& scene_;
  const LevelStates& data_;
  response::LawUnknowns unknowns_;
  std::vector<int> harmonics_;
};

/// Numbers that are none last.
bool is_less(double a, double b) { return std::isnan(b) ? !std::isnan(a) : a < b; }

}  // namespace

LawBound predict_law_bound(const LawScene& scene) {
  std::set<std::size_t> every, measured;
  for (std::size_t level = 0; level < scene.levels.size(); ++level) {
    every.insert(level);
    if (!scene.levels[level].planned) measured.insert(level);
  }
  const AssumedStates assumed = assumed_states(scene);
  const LevelStates& data = assumed.data;
  LawBound out;
  out.laws = assumed.laws;
  out.assumed = assumed.told;
  out.harmonics = assumed.harmonics;
  out.measured = measured.size();
  out.notes = data.notes;
  std::set<double> lines;
  for (const response::MeasuredState& state : data.states) lines.insert(hertz(state.omega));
  out.lines_hz.assign(lines.begin(), lines.end());
  const Predictor predictor(scene, assumed);
  out.all = predictor.of(every);
  if (!measured.empty()) out.present = predictor.of(measured);
  for (const std::size_t level : every) {
    if (measured.contains(level)) continue;
    std::set<std::size_t> with = measured;
    if (measured.empty()) {
      with = every;
      with.erase(level);
    } else {
      with.insert(level);
    }
    out.worth.push_back({level, predictor.of(with)});
  }
  // With the level where others are there, without it where none is: the best adds, or leaves a gap.
  std::ranges::stable_sort(out.worth, [&](const LevelWorth& a, const LevelWorth& b) {
    return measured.empty() ? is_less(b.bound.size, a.bound.size) : is_less(a.bound.size, b.bound.size);
  });
  return out;
}

}  // namespace jointid::laws
