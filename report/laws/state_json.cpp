#include "report/laws/state_json.hpp"

#include <nlohmann/json.hpp>

#include "base/complex.hpp"
#include "laws/task/contradiction.hpp"

namespace jointid::report {
namespace {

Json phasor(Complex number) { return {value(number.real()), value(number.imag())}; }

Json column(const Eigen::MatrixXcd& rows, Eigen::Index at) {
  Json out = Json::array();
  for (Eigen::Index n = 0; n < rows.rows(); ++n) out.push_back(phasor(rows(n, at)));
  return out;
}

}  // namespace

Json state_json(const std::string& level, const response::MeasuredState& measured, const response::DirectStep& step) {
  Json out = {{"level", level},
              {"frequency", value(hertz(measured.omega))},
              {"harmonics", measured.harmonics},
              {"joints", Json::array()}};
  for (Eigen::Index j = 0; j < step.joint_force.cols(); ++j) {
    Json one = {{"motion", column(step.joint_motion, j)},
                {"motion_deviation", column(step.motion_deviation, j)},
                {"force", column(step.joint_force, j)},
                {"force_deviation", column(step.force_deviation, j)}};
    one["equivalent"] = step.equivalent.size() > 0 ? phasor(step.equivalent(j)) : Json();
    one["equivalent_deviation"] = step.equivalent.size() > 0 ? phasor(step.equivalent_deviation(j)) : Json();
    out["joints"].push_back(one);
  }
  out["separation"] = value(step.separation);
  return out;
}

Json consistency_json(const laws::LawScene& scene, const laws::LevelStates& data, const response::Consistency& test) {
  using Kind = response::DataFault::Kind;
  const std::vector<std::string> levels = laws::level_names(scene);
  Json out = {{"chi_square", value(test.chi_square)},
              {"freedom", test.freedom},
              {"limit", value(test.limit)},
              {"contradicts", test.contradicts()},
              {"faults", Json::array()}};
  for (const response::DataFault& fault : test.faults) {
    const auto name = [&](Eigen::Index response) { return data.responses[static_cast<std::size_t>(response)].name(); };
    Json one = {{"text", laws::fault_text(fault, data.responses, levels)}, {"chi_square", value(fault.chi_square)}};
    const bool of_response = fault.kind == Kind::response || fault.kind == Kind::exchanged;
    if (of_response) one["dofs"] = {name(fault.first)};
    if (fault.kind == Kind::exchanged) one["dofs"].push_back(name(fault.second));
    if (fault.kind == Kind::response || fault.kind == Kind::force) one["gain"] = phasor(fault.gain);
    if (fault.level) one["level"] = levels[*fault.level];
    if (fault.kind == Kind::levels) one["other_level"] = levels[fault.other_level];
    out["faults"].push_back(one);
  }
  return out;
}

Json even_harmonics_json(const laws::LawScene& scene, const std::vector<laws::OneSidedJoint>& joints) {
  Json out = Json::array();
  for (const laws::OneSidedJoint& joint : joints) {
    if (joint.freedom == 0) continue;
    out.push_back({{"joint", scene.joints[joint.joint].beside.name},
                   {"chi_square", value(joint.chi_square)},
                   {"freedom", joint.freedom},
                   {"largest_share", value(joint.largest_share)},
                   {"told", joint.is_told()}});
  }
  return out;
}

}  // namespace jointid::report
