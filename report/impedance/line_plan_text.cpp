#include "report/impedance/line_plan_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/statistics.hpp"
#include "base/text.hpp"
#include "report/impedance/line_report.hpp"
#include "report/json_value.hpp"
#include "report/text/dof_list.hpp"
#include "report/text/notes.hpp"
#include "report/text/table.hpp"
#include "report/text/variances_text.hpp"
#include "report/text/words.hpp"

namespace jointid::report {
namespace {

using impedance::LinePlan;
using impedance::LineScene;
using impedance::LineValue;

constexpr double seen = 0.1;  ///< of |z|: errors below

double relative_error(const LineValue& line, std::size_t element) {
  const auto t = static_cast<Eigen::Index>(element);
  return std::sqrt(line.variance(t)) / std::abs(line.z(t));
}

std::vector<double> relative_errors(const impedance::IdentifiedLines& bound, std::size_t element) {
  std::vector<double> out;
  for (const auto& line : bound.likelihood.lines) {
    if (line) out.push_back(relative_error(*line, element));
  }
  return out;
}

std::string elements_text(const LinePlan& plan) {
  constexpr std::size_t most = 40;
  std::vector<std::string> names;
  for (const impedance::ElementName& element : plan.elements) names.push_back(element.name);
  const std::size_t count = names.size();
  names.resize(std::min(count, most));
  return fmt::format("{}: {}{}", count, fmt::join(names, " "), count > most ? fmt::format(" … and {} more", count - most) : "");
}

template <class Kind>
std::string names_of(const std::vector<Kind>& list) {
  std::vector<std::string> names;
  for (const Kind each : list) names.push_back(impedance::name(each));
  return names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "));
}

/// Of every element over the lines.
Table element_table(const impedance::IdentifiedLines& bound) {
  Table table({{"element", Align::left},
               {"std error over |z|, median"},
               {"least"},
               {"at Hz"},
               {"largest"},
               {"at Hz"},
               {"lines below 10 %"}});
  for (std::size_t t = 0; t < bound.likelihood.elements.size(); ++t) {
    std::vector<double> errors, hz;
    for (std::size_t i = 0; i < bound.likelihood.lines.size(); ++i) {
      if (!bound.likelihood.lines[i]) continue;
      errors.push_back(relative_error(*bound.likelihood.lines[i], t));
      hz.push_back(bound.frequency_hz[i]);
    }
    if (errors.empty()) continue;
    const auto [least, most] = std::ranges::minmax_element(errors);
    const auto at = [&](auto place) { return fmt::format("{:.6g}", hz[static_cast<std::size_t>(place - errors.begin())]); };
    table.add({bound.likelihood.elements[t].name, percent(median(errors)), percent(*least), at(least), percent(*most), at(most),
               fmt::format("{} of {}", std::ranges::count_if(errors, [](double e) { return e < seen; }), errors.size())});
  }
  return table;
}

std::string bound_text(const impedance::IdentifiedLines& bound) {
  std::string text =
      "\nbound: smallest standard errors at a line with these FRFs and their errors\n" + element_table(bound).text();
  if (!bound.laws.empty() && bound.laws.front().converged) {
    text += "\nof law " + impedance::name(bound.laws.front().law) + "\n" + parameter_table(bound.laws.front()).text();
    if (bound.laws.size() > 1) text += "how far AIC separates the laws\n" + law_table(bound).text();
  }
  text += notes_text(bound.notes);
  return text + (bound.status == Status::ok ? "" : "The FRFs themselves: " + bound.message + "\n");
}

Json bound_json(const impedance::IdentifiedLines& bound) {
  Json out = {{"lines", Json::array()},
              {"relative_median", Json::array()},
              {"laws", Json::array()},
              {"status", name(bound.status)},
              {"message", bound.message}};
  for (const auto& line : bound.likelihood.lines) {
    if (!line) {
      out["lines"].push_back(nullptr);
      continue;
    }
    Json of_line = {{"std_error", Json::array()}, {"relative", Json::array()}};
    for (Eigen::Index t = 0; t < line->z.size(); ++t) {
      of_line["std_error"].push_back({value(line->re_error(t)), value(line->im_error(t))});
      of_line["relative"].push_back(value(relative_error(*line, static_cast<std::size_t>(t))));
    }
    out["lines"].push_back(std::move(of_line));
  }
  for (std::size_t t = 0; t < bound.likelihood.elements.size(); ++t) {
    const std::vector<double> errors = relative_errors(bound, t);
    out["relative_median"].push_back(errors.empty() ? Json(nullptr) : value(median(errors)));
  }
  for (const impedance::LawFit& law : bound.laws) {
    Json parameters = Json::array();
    for (const impedance::FittedParameter& one : law.parameters)
      parameters.push_back({{"name", one.name}, {"unit", one.unit}, {"std_error", value(one.std_error)}});
    out["laws"].push_back({{"law", impedance::name(law.law)},
                           {"converged", law.converged},
                           {"aic_above_least", value(law.aic - bound.laws.front().aic)},
                           {"parameters", parameters}});
  }
  return out;
}

}  // namespace

std::string line_plan_text(const LineScene& scene, const LinePlan& plan) {
  Table table({{"", Align::left}, {"", Align::left}});
  table.add({"joint DOFs", dof_list(plan.dofs)});
  table.add({"lines", fmt::format("{}, {:g} to {:g} Hz, each on its own", plan.frequency_hz.size(), plan.frequency_hz.front(),
                                  plan.frequency_hz.back())});
  table.add({"structure", impedance::name(scene.structure)});
  table.add({"unknowns of a line", elements_text(plan)});
  table.add({"ways", names_of(scene.ways)});
  table.add({"laws", names_of(scene.laws)});
  for (const auto& [block, count] : plan.blocks) table.add({"FRFs of a line, " + block, std::to_string(count)});
  table.add({"degrees of freedom of a line",
             fmt::format("{:.0f}{}", plan.freedom, plan.freedom > 0.0 ? "" : ": nothing can contradict the answer")});
  return (scene.scene.title.empty() ? "" : scene.scene.title + "\n") + table.text() + variances_text(plan.variances) +
         phrases("warnings", plan.warnings) + phrases("notes", plan.notes) + (plan.bound ? bound_text(*plan.bound) : "");
}

std::string line_plan_json(const LineScene& scene, const LinePlan& plan) {
  Json out = {{"kind", "lines"},
              {"title", scene.scene.title},
              {"structure", impedance::name(scene.structure)},
              {"dofs", frf::names(plan.dofs)},
              {"frequency_hz", values(plan.frequency_hz)},
              {"elements", Json::array()},
              {"ways", Json::array()},
              {"laws", Json::array()},
              {"frfs_of_line", Json::object()},
              {"degrees_of_freedom_of_line", value(plan.freedom)},
              {"variances", Json::array()},
              {"warnings", plan.warnings},
              {"notes", plan.notes}};
  for (const impedance::ElementName& element : plan.elements)
    out["elements"].push_back({{"name", element.name}, {"unit", element.unit}});
  for (const impedance::Way way : scene.ways) out["ways"].push_back(impedance::name(way));
  for (const impedance::LawKind law : scene.laws) out["laws"].push_back(impedance::name(law));
  for (const auto& [block, count] : plan.blocks) out["frfs_of_line"][block] = count;
  for (const ident::VarianceSource& file : plan.variances)
    out["variances"].push_back({{"file", file.file}, {"origin", file.origin}});
  if (plan.bound) out["bound"] = bound_json(*plan.bound);
  return json_text(out);
}

}  // namespace jointid::report
