#include "laws/task/law_bound.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "base/complex.hpp"
#include "base/error.hpp"
#include "friction/law/laws.hpp"
#include "laws/task/identify_laws.hpp"
#include "response/harmonic/harmonic_balance.hpp"

namespace jointid::laws {
namespace {

constexpr double nothing_known = 1e3;  ///< relative deviation that counts for a number that is not seen
constexpr int largest_harmonic = 9;  ///< of the model where the scene says nothing and the parts have it

[[noreturn]] void fail(const LawScene& scene, std::string place, std::string problem, std::string remedy) {
  throw InputError({.kind = ErrorKind::data,
                    .file = scene.file.string(),
                    .place = std::move(place),
                    .problem = std::move(problem),
                    .remedy = std::move(remedy)});
}

/// The joints of the plan, and the names of their laws.
struct Assumed {
  std::vector<response::Joint> joints;
  std::vector<std::string> laws;
  bool told = true;
};

Assumed from_scene(const LawScene& scene) {
  Assumed out;
  for (std::size_t j = 0; j < scene.joints.size(); ++j) {
    const std::size_t leader = scene.constraints.leader(j).value_or(j);
    out.joints.push_back(scene.joints[j].beside);
    out.laws.push_back(scene.joints[leader].laws.front());
    out.joints.back().friction = friction::make_element(out.laws.back(), scene.joints[leader].assumed);
  }
  return out;
}

Assumed from_data(LawScene scene) {
  std::erase_if(scene.levels, [](const ForceLevel& level) { return level.planned; });
  if (scene.levels.empty()) {
    fail(scene, "[[joint.friction]]", "nothing says what laws the plan is for",
         "give each joint one law and assumed = { … } with its parameters, or levels that were measured");
  }
  const LawIdentification found = identify_laws(scene);
  if (!is_usable(found.status)) fail(scene, "[[data.levels]]", found.message, "give assumed laws, or mend the data first");
  Assumed out{.joints = {}, .laws = found.laws(), .told = false};
  for (const response::FittedJoint& joint : found.fit().joints) out.joints.push_back(joint.joint);
  return out;
}

Assumed assumed_joints(const LawScene& scene) {
  bool all = true;
  for (std::size_t j = 0; j < scene.joints.size(); ++j)
    all = all && !scene.joints[scene.constraints.leader(j).value_or(j)].assumed.empty();
  return all ? from_scene(scene) : from_data(scene);
}

/// Those of the scene; else 1, 3, … that the parts have at every line.
std::vector<int> model_harmonics(const LawScene& scene, const LevelStates& data) {
  if (!scene.harmonics.empty()) return scene.harmonics;
  std::set<int> all;
  for (const response::MeasuredState& state : data.states) {
    all.insert(state.harmonics.begin(), state.harmonics.end());
    all.insert(state.force.harmonics.begin(), state.force.harmonics.end());
  }
  for (int n = 1; n <= largest_harmonic; n += 2) {
    const auto covered = [&](const response::MeasuredState& state) { return data.structure->covers(n * state.omega); };
    if (std::ranges::all_of(data.states, covered)) all.insert(n);
  }
  return {all.begin(), all.end()};
}

/// Those of [errors]; of a harmonic that hardly is there at least those of a thousandth of the largest: no channel is purer.
Eigen::MatrixXd deviations_of(const PhasorErrors& errors, const Eigen::MatrixXcd& response) {
  constexpr double purity = 1e-3;
  const Eigen::RowVectorXd least = purity * response.cwiseAbs().colwise().maxCoeff();
  const Eigen::MatrixXd size = response.cwiseAbs().cwiseMax(least.replicate(response.rows(), 1));
  return (0.5 * (errors.relative * size).array().square() + errors.floor * errors.floor).sqrt();
}

/// The responses of the assumed laws at each state; those without a solution are left out.
void simulate(const LawScene& scene, const Assumed& assumed, const std::vector<int>& harmonics, LevelStates& data,
              std::vector<std::string>& notes) {
  LevelStates kept = data;
  kept.states.clear();
  kept.level.clear();
  std::vector<std::size_t> lost(scene.levels.size());
  for (std::size_t i = 0; i < data.states.size(); ++i) {
    response::MeasuredState state = data.states[i];
    const bool planned = scene.levels[data.level[i]].planned;
    const auto solved =
        response::HarmonicBalance(data.structure, assumed.joints, state.force, {.fixed = harmonics}).solve(state.omega);
    if (!solved.converged) {
      ++lost[data.level[i]];
      continue;
    }
    const response::Harmonics numbers(solved.harmonics);
    for (Eigen::Index n = 0; n < state.response.rows(); ++n)
      state.response.row(n) = solved.response.row(numbers.find(state.harmonics[static_cast<std::size_t>(n)]));
    if (planned) state.deviation = deviations_of(*scene.errors, state.response);
    kept.states.push_back(std::move(state));
    kept.level.push_back(data.level[i]);
  }
  for (std::size_t level = 0; level < lost.size(); ++level) {
    if (lost[level] > 0)
      notes.push_back(scene.levels[level].name + ": no response found at " + std::to_string(lost[level]) + " lines, left out");
  }
  data = std::move(kept);
}

/// What the levels that `wanted` names would tell.
class Predictor {
 public:
  Predictor(const LawScene& scene, const LevelStates& data, const Assumed& assumed, std::vector<int> harmonics)
      : scene_(scene), data_(data), unknowns_(response::unknowns_of(assumed.joints, scene.constraints)), harmonics_(std::move(harmonics)) {}

  LevelsBound of(const std::set<std::size_t>& wanted) const {
    std::vector<response::MeasuredState> states;
    for (std::size_t i = 0; i < data_.states.size(); ++i) {
      if (wanted.contains(data_.level[i])) states.push_back(data_.states[i]);
    }
    LevelsBound bound;
    bound.size = std::numeric_limits<double>::quiet_NaN();
    bound.status = response::LawFitStatus::too_few_data;
    if (states.empty()) return bound;
    const response::LawFit found = response::bound_of_laws(data_.structure, states, unknowns_, harmonics_);
    bound.status = found.status;
    bound.joints = found.joints;
    double sum = 0.0;
    for (std::size_t j = 0; j < bound.joints.size(); ++j) {
      const response::FittedJoint& joint = bound.joints[j];
      for (const std::string& what : unseen(joint)) bound.unseen.push_back(scene_.joints[j].beside.name + ": " + what);
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
  if (measured.size() < every.size() && !scene.errors)
    fail(scene, "[errors]", "nobody says how exact a planned level will be", "give relative = 0.01, or floor in m");
  const Assumed assumed = assumed_joints(scene);
  LevelStates data = read_level_states(scene);
  LawBound out;
  out.laws = assumed.laws;
  out.assumed = assumed.told;
  out.notes = data.notes;
  out.harmonics = model_harmonics(scene, data);
  out.measured = measured.size();
  simulate(scene, assumed, out.harmonics, data, out.notes);
  std::set<double> lines;
  for (const response::MeasuredState& state : data.states) lines.insert(hertz(state.omega));
  out.lines_hz.assign(lines.begin(), lines.end());
  const Predictor predictor(scene, data, assumed, out.harmonics);
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
