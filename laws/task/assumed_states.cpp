#include "laws/task/assumed_states.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/error.hpp"
#include "friction/law/laws.hpp"
#include "laws/task/identify_laws.hpp"
#include "response/harmonic/harmonic_balance.hpp"

namespace jointid::laws {
namespace {

constexpr int largest_harmonic = 9;  ///< of the model where the scene says nothing and the parts have it

/// The joints, and the names of their laws.
struct Laws {
  std::vector<response::Joint> joints;
  std::vector<std::string> laws;
};

[[noreturn]] void fail(const LawScene& scene, std::string place, std::string problem, std::string remedy) {
  throw InputError({.kind = ErrorKind::data,
                    .file = scene.file.string(),
                    .place = std::move(place),
                    .problem = std::move(problem),
                    .remedy = std::move(remedy)});
}

bool is_planned(const ForceLevel& level) { return level.planned; }

/// Whether the scene tells the law of every joint.
bool tells_laws(const LawScene& scene) {
  for (std::size_t j = 0; j < scene.joints.size(); ++j) {
    if (scene.joints[scene.constraints.leader(j).value_or(j)].assumed.empty()) return false;
  }
  return true;
}

Laws from_scene(const LawScene& scene) {
  Laws out;
  for (std::size_t j = 0; j < scene.joints.size(); ++j) {
    const std::size_t leader = scene.constraints.leader(j).value_or(j);
    out.joints.push_back(scene.joints[j].beside);
    out.laws.push_back(scene.joints[leader].assumed_law);
    out.joints.back().friction = friction::make_element(out.laws.back(), scene.joints[leader].assumed);
  }
  return out;
}

/// From the measured levels among `data`.
Laws from_data(const LawScene& scene, LevelStates data) {
  std::vector<response::MeasuredState> states;
  std::vector<std::size_t> level;
  for (std::size_t i = 0; i < data.states.size(); ++i) {
    if (is_planned(scene.levels[data.level[i]])) continue;
    states.push_back(std::move(data.states[i]));
    level.push_back(data.level[i]);
  }
  data.states = std::move(states);
  data.level = std::move(level);
  const LawIdentification found = identify_states(scene, std::move(data));
  if (!is_usable(found.status)) fail(scene, "[[data.levels]]", found.message, "give assumed laws, or correct the data first");
  return {.joints = joints_of(found.fit()), .laws = found.laws()};
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
void simulate(const LawScene& scene, AssumedStates& of) {
  LevelStates& data = of.data;
  LevelStates kept = data;
  kept.states.clear();
  kept.level.clear();
  std::vector<std::size_t> lost(scene.levels.size());
  for (std::size_t i = 0; i < data.states.size(); ++i) {
    response::MeasuredState state = data.states[i];
    const bool planned = scene.levels[data.level[i]].planned;
    const auto responses = responses_of(of, data.structure, state);
    if (!responses) {
      ++lost[data.level[i]];
      continue;
    }
    state.response = *responses;
    if (planned) state.deviation = deviations_of(*scene.errors, state.response);
    kept.states.push_back(std::move(state));
    kept.level.push_back(data.level[i]);
  }
  for (std::size_t level = 0; level < lost.size(); ++level) {
    if (lost[level] > 0)
      data.notes.push_back(scene.levels[level].name + ": no response found at " + std::to_string(lost[level]) + " lines, left out");
  }
  kept.notes = data.notes;
  data = std::move(kept);
}

}  // namespace

std::optional<Eigen::MatrixXcd> responses_of(const AssumedStates& assumed, const std::shared_ptr<const response::Receptance>& structure,
                                             const response::MeasuredState& state) {
  const response::HarmonicBalance balance(structure, assumed.joints, state.force, {.fixed = assumed.harmonics});
  const auto solved = balance.solve(state.omega);
  if (!solved.converged) return std::nullopt;
  const response::Harmonics numbers(solved.harmonics);
  Eigen::MatrixXcd responses(state.response.rows(), state.response.cols());
  for (Eigen::Index n = 0; n < responses.rows(); ++n)
    responses.row(n) = solved.response.row(numbers.find(state.harmonics[static_cast<std::size_t>(n)]));
  return responses;
}

AssumedStates assumed_states(const LawScene& scene) {
  const bool told_errors = scene.errors && scene.errors->of_responses();
  if (!told_errors && std::ranges::any_of(scene.levels, is_planned))
    fail(scene, "[errors]", "nothing states how exact a planned level will be", "give relative = 0.01, or floor in m");
  const bool told = tells_laws(scene);
  if (!told && std::ranges::all_of(scene.levels, is_planned)) {
    fail(scene, "[[joint.friction]]", "nothing states what laws the plan is for",
         "give each joint one law and assumed = { … } with its parameters, or levels that were measured");
  }
  AssumedStates out;
  out.data = read_level_states(scene);
  Laws laws = told ? from_scene(scene) : from_data(scene, out.data);
  out.joints = std::move(laws.joints);
  out.laws = std::move(laws.laws);
  out.told = told;
  out.harmonics = model_harmonics(scene, out.data);
  simulate(scene, out);
  return out;
}

}  // namespace jointid::laws
