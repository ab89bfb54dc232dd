#include "report/result/by_line.hpp"

#include <nlohmann/json.hpp>

#include "report/json_value.hpp"
#include "report/text/table.hpp"

namespace jointid::report {

std::string by_line_csv(const tasks::UnknownsByLine& found) {
  std::vector<std::string> titles = {"lines", "frequency_hz"};
  titles.insert(titles.end(), found.names.begin(), found.names.end());
  for (const std::string& name : found.names) titles.push_back(name + " alone");
  std::string text = csv_line(titles);
  for (const tasks::LineUnknowns& line : found.lines) {
    std::vector<std::string> row = {std::to_string(line.lines), csv_number(line.frequency_hz)};
    for (const double each : line.together) row.push_back(csv_number(each));
    for (std::size_t i = 0; i < found.names.size(); ++i) row.push_back(line.alone.empty() ? "" : csv_number(line.alone[i]));
    text += csv_line(row);
  }
  return text;
}

std::string by_line_json(const tasks::UnknownsByLine& found) {
  Json out = {{"status", "ok"}, {"unknowns", found.names}, {"lines", Json::array()}};
  for (const tasks::LineUnknowns& line : found.lines) {
    out["lines"].push_back({{"lines", line.lines},
                            {"frequency_hz", value(line.frequency_hz)},
                            {"together", values(line.together)},
                            {"alone", line.alone.empty() ? Json() : Json(values(line.alone))}});
  }
  return json_text(out);
}

std::string by_iteration_csv(const tasks::UnknownsByIteration& found) {
  std::vector<std::string> titles = {"iteration", "objective"};
  titles.insert(titles.end(), found.names.begin(), found.names.end());
  std::string text = csv_line(titles);
  for (const tasks::IterationUnknowns& step : found.iterations) {
    std::vector<std::string> row = {std::to_string(step.iteration), csv_number(step.objective)};
    for (const double each : step.values) row.push_back(csv_number(each));
    text += csv_line(row);
  }
  return text;
}

std::string by_iteration_json(const tasks::UnknownsByIteration& found) {
  Json out = {{"status", "ok"}, {"unknowns", found.names}, {"iterations", Json::array()}};
  for (const tasks::IterationUnknowns& step : found.iterations) {
    out["iterations"].push_back({{"iteration", step.iteration}, {"objective", value(step.objective)}, {"values", values(step.values)}});
  }
  return json_text(out);
}

}  // namespace jointid::report
