#include "report/laws/law_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/statistics.hpp"
#include "base/text.hpp"
#include "report/laws/direct_text.hpp"
#include "report/text/notes.hpp"

namespace jointid::report {
namespace {

using laws::LawIdentification;

std::string interval_text(const friction::FittedValue& value) {
  if (!value.ci95) return "–";
  return number((*value.ci95)[0], value.std_error) + " to " + number((*value.ci95)[1], value.std_error);
}

void add_value(Table& table, const friction::FittedValue& value) {
  table.add({value.name, number(value.value, value.std_error), value.unit,
             value.std_error ? fmt::format("{:.2g}", *value.std_error) : "–", interval_text(value),
             friction::name(value.knowledge)});
}

std::string harmonics_text(const std::vector<int>& numbers) {
  std::string text;
  for (const int n : numbers) text += (text.empty() ? "" : " ") + std::to_string(n);
  return text;
}

std::string choice_text(const LawIdentification& found) {
  std::string text = "law: " + laws::laws_text(found.laws());
  if (!found.not_told_apart.empty()) {
    text += "; the data do not separate it from " + comma_list(found.not_told_apart);
  }
  return text + "\n";
}

std::string fit_text(const response::LawFit& fit) {
  std::string text = fmt::format("χ² = {:.5g} of {} degrees of freedom, {} Gauss–Newton steps", fit.chi_square,
                                 static_cast<long>(fit.freedom), fit.steps);
  if (!fit.states.empty()) text += ", harmonics of the model " + harmonics_text(fit.states.front().solution.harmonics);
  return text + "\n";
}

/// By how much χ² would fall were the level's parameters its own, and by how much at most by chance.
std::pair<std::string, std::string> drift_cells(const LawIdentification& found, std::size_t level) {
  const auto drift = std::ranges::find(found.drifts, level, &response::LevelDrift::level);
  if (drift == found.drifts.end() || drift->freedom == 0) return {"–", "–"};
  return {fmt::format("−{:.3g}", drift->chi_square),
          fmt::format("{:.3g}", chi_square_quantile(static_cast<double>(drift->freedom), 4.0))};
}

}  // namespace

Table law_table(const LawIdentification& found) {
  Table table({{"law", Align::left}, {"unknowns"}, {"χ²"}, {"freedom"}, {"AIC − least"}, {"", Align::left}});
  const double least = found.compared.front().fit.aic;
  for (const response::LawCandidate& each : found.compared) {
    const bool defined = each.fit.values.size() > 0;
    table.add({laws::laws_text(each.laws), std::to_string(each.fit.values.size()), defined ? number(each.fit.chi_square) : "–",
               std::to_string(each.fit.freedom), defined ? fmt::format("{:.1f}", each.fit.aic - least) : "–",
               std::string(response::word(each.fit.status))});
  }
  return table;
}

Table joint_table(const response::FittedJoint& joint) {
  Table table(
      {{"", Align::left}, {"value"}, {"unit", Align::left}, {"std error"}, {"95 % interval", Align::left}, {"", Align::left}});
  if (joint.joint.friction) {
    add_value(table, joint.stiffness);
    if (std::isfinite(joint.limit.value)) add_value(table, joint.limit);
  }
  table.add({"least |Q₁|", number(joint.smallest_motion), "m", "", "", ""});
  table.add({"largest |Q₁|", number(joint.largest_motion), "m", "", "", ""});
  for (const friction::FittedValue& value : joint.parameters) add_value(table, value);
  return table;
}

Table direct_table(const LawIdentification& found, std::size_t joint) {
  const response::Joint none;
  return direct_table(found.steps, joint, joint < found.fit().joints.size() ? &found.fit().joints[joint].joint : &none);
}

Table level_table(const laws::LawScene& scene, const LawIdentification& found) {
  Table table({{"level", Align::left}, {"states"}, {"rms residual"}, {"largest"}, {"χ² alone"}, {"chance"}});
  for (std::size_t level = 0; level < scene.levels.size(); ++level) {
    double sum = 0.0, largest = 0.0;
    Eigen::Index count = 0;
    std::size_t states = 0;
    for (std::size_t i = 0; i < found.fit().states.size(); ++i) {
      if (found.data.level[i] != level) continue;
      const response::MeasuredState& state = found.data.states[i];
      const Eigen::VectorXd residual = response::in_deviations(state, found.fit().states[i].response - state.response);
      sum += residual.squaredNorm();
      largest = std::max(largest, residual.cwiseAbs().maxCoeff());
      count += residual.size();
      ++states;
    }
    const auto drift = drift_cells(found, level);
    table.add({scene.levels[level].name, std::to_string(states),
               count > 0 ? fmt::format("{:.2f}", std::sqrt(sum / static_cast<double>(count))) : "–",
               count > 0 ? fmt::format("{:.1f}", largest) : "–", drift.first, drift.second});
  }
  return table;
}

std::string law_text(const laws::LawScene& scene, const LawIdentification& found) {
  std::string text = (scene.title.empty() ? "" : scene.title + "\n") + states_text(scene, found.data) + "\n" +
                     choice_text(found) + law_table(found).text() + "\n";
  for (std::size_t j = 0; j < found.fit().joints.size(); ++j) {
    text += scene.joints[j].beside.name + ": " + found.laws()[j] + "\n" + joint_table(found.fit().joints[j]).text() + "\n";
  }
  text += fit_text(found.fit()) + consistency_text(found.consistency) + "residuals in standard deviations\n" +
          level_table(scene, found).text() + "\n";
  for (std::size_t j = 0; j < scene.joints.size(); ++j) {
    text += scene.joints[j].beside.name + ": stiffness and damping without a law\n" + direct_table(found, j).text() + "\n";
  }
  text += notes_text(found.notes);
  return text + "status: " + name(found.status) + (found.message.empty() ? "" : ": " + found.message) + "\n";
}

std::string law_csv(const laws::LawScene& scene, const LawIdentification& found) {
  std::string text = csv_line({"joint", "law", "quantity", "unit", "value", "std error", "ci95 low", "ci95 high", "knowledge"});
  const auto add = [&](std::size_t j, const friction::FittedValue& value) {
    std::optional<double> low, high;
    if (value.ci95) {
      low = (*value.ci95)[0];
      high = (*value.ci95)[1];
    }
    text += csv_line({scene.joints[j].beside.name, found.laws()[j], value.name, value.unit, csv_number(value.value),
                      csv_number(value.std_error), csv_number(low), csv_number(high), friction::name(value.knowledge)});
  };
  for (std::size_t j = 0; j < found.fit().joints.size(); ++j) {
    const response::FittedJoint& joint = found.fit().joints[j];
    if (joint.joint.friction) {
      add(j, joint.stiffness);
      add(j, joint.limit);
    }
    for (const friction::FittedValue& value : joint.parameters) add(j, value);
  }
  return text;
}

}  // namespace jointid::report
