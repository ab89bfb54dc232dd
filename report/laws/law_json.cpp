#include <nlohmann/json.hpp>

#include "report/json_value.hpp"
#include "report/laws/law_text.hpp"
#include "report/laws/state_json.hpp"

namespace jointid::report {
namespace {

using laws::LawIdentification;

Json fitted(const friction::FittedValue& of) {
  Json out = {{"name", of.name}, {"unit", of.unit}, {"value", value(of.value)}, {"std_error", value(of.std_error)}};
  out["ci95"] = value(of.ci95);
  out["knowledge"] = friction::name(of.knowledge);
  return out;
}

Json candidate(const response::LawCandidate& of) {
  Json rounds = Json::array();
  for (const response::HarmonicsRound& round : of.fit.rounds) {
    rounds.push_back(
        {{"largest_harmonic", round.largest}, {"chi_square", value(round.chi_square)}, {"moved", value(round.moved)}});
  }
  return {{"laws", of.laws},
          {"status", response::word(of.fit.status)},
          {"unknowns", of.fit.values.size()},
          {"numbers", of.fit.numbers},
          {"freedom", of.fit.freedom},
          {"chi_square", value(of.fit.chi_square)},
          {"aic", value(of.fit.aic)},
          {"steps", of.fit.steps},
          {"rounds", rounds}};
}

Json joint(const laws::LawScene& scene, const LawIdentification& found, std::size_t j) {
  const response::FittedJoint& of = found.fit().joints[j];
  Json out = {{"name", scene.joints[j].beside.name}, {"law", found.laws()[j]}};
  out["stiffness"] = of.joint.friction ? fitted(of.stiffness) : Json();
  out["limit"] = of.joint.friction ? fitted(of.limit) : Json();
  out["motion"] = {value(of.smallest_motion), value(of.largest_motion)};
  out["parameters"] = Json::array();
  for (const friction::FittedValue& parameter : of.parameters) out["parameters"].push_back(fitted(parameter));
  return out;
}

Json covariance(const Eigen::MatrixXd& matrix) {
  Json out = Json::array();
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    const Eigen::VectorXd row = matrix.row(i);
    out.push_back(values(std::span(row.data(), static_cast<std::size_t>(row.size()))));
  }
  return out;
}

Json state(const laws::LawScene& scene, const LawIdentification& found, std::size_t i) {
  const response::MeasuredState& measured = found.data.states[i];
  Json out = state_json(scene.levels[found.data.level[i]].name, measured, found.steps[i]);
  out["residual"] = Json();
  if (i < found.fit().states.size()) {
    const Eigen::VectorXd residual = response::in_deviations(measured, found.fit().states[i].response - measured.response);
    out["residual"] = values(std::span(residual.data(), static_cast<std::size_t>(residual.size())));
  }
  return out;
}

Json drifts(const laws::LawScene& scene, const LawIdentification& found) {
  Json out = Json::array();
  for (const response::LevelDrift& drift : found.drifts) {
    out.push_back({{"level", scene.levels[drift.level].name},
                   {"chi_square", value(drift.chi_square)},
                   {"freedom", drift.freedom},
                   {"told", drift.is_told()},
                   {"change", values(std::span(drift.change.data(), static_cast<std::size_t>(drift.change.size())))},
                   {"deviation", values(std::span(drift.deviation.data(), static_cast<std::size_t>(drift.deviation.size())))}});
  }
  return out;
}

}  // namespace

std::string law_json(const laws::LawScene& scene, const LawIdentification& found) {
  Json out = {{"status", name(found.status)},
              {"message", found.message},
              {"laws", found.laws()},
              {"not_told_apart", found.not_told_apart},
              {"joints", Json::array()},
              {"covariance", covariance(found.fit().covariance)},
              {"chi_square", value(found.fit().chi_square)},
              {"freedom", found.fit().freedom},
              {"compared", Json::array()},
              {"dofs", frf::names(found.data.responses)},
              {"states", Json::array()},
              {"notes", found.notes}};
  out["consistency"] = consistency_json(scene, found.data, found.consistency);
  out["drift"] = drifts(scene, found);
  out["even_harmonics"] = even_harmonics_json(scene, found.one_sided);
  for (std::size_t j = 0; j < found.fit().joints.size(); ++j) out["joints"].push_back(joint(scene, found, j));
  for (const response::LawCandidate& each : found.compared) out["compared"].push_back(candidate(each));
  for (std::size_t i = 0; i < found.data.states.size(); ++i) out["states"].push_back(state(scene, found, i));
  return json_text(out);
}

}  // namespace jointid::report
