#include "report/laws/direct_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "base/complex.hpp"
#include "friction/curve/equivalent.hpp"
#include "laws/task/direct_bins.hpp"
#include "report/laws/state_json.hpp"
#include "report/text/notes.hpp"
#include "response/fourier/harmonics.hpp"

namespace jointid::report {
namespace {

constexpr std::size_t most_bins = 10;

std::string numbers_text(const std::set<int>& numbers) {
  std::string text;
  for (const int n : numbers) text += (text.empty() ? "" : " ") + std::to_string(n);
  return text;
}

}  // namespace

Table direct_table(const std::vector<response::DirectStep>& steps, std::size_t joint, const response::Joint* law) {
  std::vector<Column> columns = {{"|Q₁| m"}, {"k_e N/m"}, {"±"}, {"d_e N/m"}, {"±"}, {"states"}};
  if (law != nullptr) columns.insert(columns.end(), {{"law k_e"}, {"law d_e"}});
  Table table(columns);
  for (const laws::DirectBin& bin : laws::direct_bins(steps, at(joint), most_bins)) {
    std::vector<std::string> cells = {number(bin.motion),
                                      number(bin.equivalent.real(), bin.deviation.real()),
                                      fmt::format("{:.2g}", bin.deviation.real()),
                                      number(bin.equivalent.imag(), bin.deviation.imag()),
                                      fmt::format("{:.2g}", bin.deviation.imag()),
                                      std::to_string(bin.states)};
    if (law != nullptr && law->friction) {
      const friction::Equivalent by_law = friction::equivalent(*law->friction, bin.motion);
      cells.push_back(number(by_law.stiffness + law->stiffness));
      cells.push_back(number(by_law.damping));
    } else if (law != nullptr) {
      cells.insert(cells.end(), {"–", "–"});
    }
    table.add(cells);
  }
  return table;
}

std::string states_text(const laws::LawScene& scene, const laws::LevelStates& data) {
  std::set<double> lines;
  std::set<int> harmonics;
  for (const response::MeasuredState& state : data.states) {
    lines.insert(state.omega);
    harmonics.insert(state.harmonics.begin(), state.harmonics.end());
  }
  const auto plural = [](std::size_t count) { return count == 1 ? "" : "s"; };
  return fmt::format("{} state{} of {} level{}: {} line{} from {:.6g} to {:.6g} Hz, {} response{}, harmonics {}\n",
                     data.states.size(), plural(data.states.size()), scene.levels.size(), plural(scene.levels.size()),
                     lines.size(), plural(lines.size()), hertz(*lines.begin()), hertz(*lines.rbegin()), data.responses.size(),
                     plural(data.responses.size()), numbers_text(harmonics));
}

std::string consistency_text(const response::Consistency& test) {
  if (test.freedom == 0) return {};
  return fmt::format("without any law: χ² = {:.5g} of {} degrees of freedom, at most {:.5g} is to be expected\n", test.chi_square,
                     static_cast<long>(test.freedom), test.limit);
}

std::string direct_text(const laws::LawScene& scene, const laws::DirectIdentification& found) {
  std::string text = (scene.title.empty() ? "" : scene.title + "\n") + states_text(scene, found.data) +
                     consistency_text(found.consistency) + "\n";
  for (std::size_t j = 0; j < scene.joints.size(); ++j) {
    text += fmt::format("{}: stiffness and damping without a law, {} of {} states determine them to 30 %\n",
                        scene.joints[j].beside.name, found.known[j], found.steps.size());
    text += direct_table(found.steps, j).text() + "\n";
  }
  text += notes_text(found.notes);
  return text + "status: " + name(found.status) + (found.message.empty() ? "" : ": " + found.message) + "\n";
}

std::string direct_json(const laws::LawScene& scene, const laws::DirectIdentification& found) {
  Json out = {{"status", name(found.status)},
              {"message", found.message},
              {"joints", Json::array()},
              {"states", Json::array()},
              {"notes", found.notes}};
  for (std::size_t j = 0; j < scene.joints.size(); ++j)
    out["joints"].push_back({{"name", scene.joints[j].beside.name}, {"known_states", found.known[j]}});
  out["dofs"] = frf::names(found.data.responses);
  out["consistency"] = consistency_json(scene, found.data, found.consistency);
  out["even_harmonics"] = even_harmonics_json(scene, found.one_sided);
  for (std::size_t i = 0; i < found.steps.size(); ++i)
    out["states"].push_back(state_json(scene.levels[found.data.level[i]].name, found.data.states[i], found.steps[i]));
  return json_text(out);
}

std::string direct_csv(const laws::LawScene& scene, const laws::DirectIdentification& found) {
  std::string text = csv_line({"joint", "level", "frequency [Hz]", "displacement [m]", "displacement deviation [m]",
                               "stiffness [N/m]", "stiffness deviation [N/m]", "damping [N/m]", "damping deviation [N/m]"});
  for (std::size_t j = 0; j < scene.joints.size(); ++j) {
    for (std::size_t i = 0; i < found.steps.size(); ++i) {
      const response::DirectStep& step = found.steps[i];
      const Eigen::Index first = response::Harmonics(step.harmonics).find(1), joint = at(j);
      if (first < 0) continue;
      const Complex equivalent = step.equivalent(joint), deviation = step.equivalent_deviation(joint);
      text += csv_line({scene.joints[j].beside.name, scene.levels[found.data.level[i]].name, csv_number(hertz(step.omega)),
                        csv_number(std::abs(step.joint_motion(first, joint))),
                        csv_number(std::abs(step.motion_deviation(first, joint)) / std::sqrt(2.0)), csv_number(equivalent.real()),
                        csv_number(deviation.real()), csv_number(equivalent.imag()), csv_number(deviation.imag())});
    }
  }
  return text;
}

}  // namespace jointid::report
