#include "report/loading_curve/loading_curve_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace jointid::report {
namespace {

using friction::CurveFit;
using friction::Fit;
using friction::FittedValue;

std::string interval(const FittedValue& value) {
  return value.ci95 ? fmt::format("{:.5g} … {:.5g}", (*value.ci95)[0], (*value.ci95)[1]) : "–";
}

std::string remark(const FittedValue& value) {
  return value.knowledge == friction::Knowledge::determined ? "" : friction::name(value.knowledge);
}

void add_value(const FittedValue& value, const std::string& of, Table& table) {
  table.add({value.name + of, number(value.value), value.unit, value.std_error ? number(*value.std_error) : "–", interval(value),
             remark(value)});
}

std::string percent(double share) { return fmt::format("{:.2f}", 100.0 * share); }

/// Smallest, median and largest.
std::vector<std::string> three(std::vector<double> values, double factor) {
  std::ranges::sort(values);
  const std::size_t half = values.size() / 2;
  const double median = values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
  return {number(factor * values.front()), number(factor * median), number(factor * values.back())};
}

}  // namespace

Table laws_table(const tasks::LoadingCurveResult& result) {
  Table table({{"law", Align::left}, {"AIC"}, {"above best"}, {"rms residual"}, {"ΔE (2.58b)"}, {"unknowns"}, {"initial stiffness"},
               {"friction limit"}, {"", Align::left}});
  for (const Fit& fit : result.fits) {
    if (fit.curves.empty()) {
      table.add({fit.law, "–", "–", "–", "–", fmt::format("{}", fit.unknowns), "–", "–", fit.message});
      continue;
    }
    const CurveFit& first = fit.curves.front();
    const bool several = tasks::different(result, fit).size() > 1;
    const std::string note = fit.status == Status::ok ? (several ? "first curve" : remark(first.limit)) : fit.message;
    table.add({fit.law, fmt::format("{:.1f}", fit.aic), fmt::format("{:.1f}", fit.aic - result.fits.front().aic),
               fmt::format("{:.4g}", fit.residual_std), fmt::format("{:.3e}", fit.objective), fmt::format("{}", fit.unknowns),
               number(first.stiffness.value), number(first.limit.value), note});
  }
  return table;
}

Table parameters_table(const tasks::LoadingCurveResult& result, const Fit& fit) {
  Table table({{"", Align::left}, {"value"}, {"unit", Align::left}, {"std error"}, {"95 % interval", Align::left}, {"", Align::left}});
  const auto curves = tasks::different(result, fit);
  for (const CurveFit* each : curves) {
    const std::string of = curves.size() > 1 ? " of " + each->curve.name : "";
    for (const FittedValue& value : each->parameters) add_value(value, of, table);
    add_value(each->stiffness, of, table);
    if (std::isfinite(each->limit.value)) add_value(each->limit, of, table);
    if (each->friction_coefficient) add_value(*each->friction_coefficient, of, table);
    table.add({"slipped share h" + of, fmt::format("{:.4f}", each->slipped_share), "1", "", "at the largest displacement", ""});
  }
  return table;
}

Table loops_table(const tasks::LoadingCurveResult& result) {
  Table table({{"law", Align::left}, {"stiffness, least"}, {"median"}, {"most"}, {"limit, least"}, {"median"}, {"most"},
               {"energy error %, least"}, {"median"}, {"most"}});
  for (std::size_t i = 0; i < result.of_loops.size(); ++i) {
    std::vector<double> stiffness, limit, energy;
    for (const Fit& fit : result.of_loops[i]) {
      if (fit.curves.empty()) continue;
      stiffness.push_back(fit.curves[0].stiffness.value);
      limit.push_back(fit.curves[0].limit.value);
      energy.push_back(tasks::energy_error(fit.curves[0]));
    }
    if (stiffness.empty()) continue;
    std::vector<std::string> cells = {result.fits[i].law};
    for (const auto& part : {three(stiffness, 1.0), three(limit, 1.0), three(energy, 100.0)})
      cells.insert(cells.end(), part.begin(), part.end());
    table.add(std::move(cells));
  }
  return table;
}

Table equivalents_table(const CurveFit& fit, std::size_t count) {
  const std::string stiffness = fit.curve.force_unit + "/" + fit.curve.displacement_unit;
  Table table({{"amplitude " + fit.curve.displacement_unit},
               {"k_e " + stiffness},
               {"d_e " + stiffness},
               {"energy per cycle J"},
               {"d_e/k_e %"}});
  for (const friction::Equivalent& row : tasks::equivalents(fit, count)) {
    table.add({number(row.amplitude), number(row.stiffness), number(row.damping), number(row.energy), percent(row.loss_factor)});
  }
  return table;
}

Table slip_forms_table(const friction::SlipShares& shares) {
  Table table({{"law", Align::left}, {"parameters", Align::left}, {"rms over the largest u %"}});
  for (const friction::SlipForm& form : shares.forms) {
    std::string parameters;
    for (const double each : form.parameters) parameters += (parameters.empty() ? "" : ", ") + number(each);
    table.add({form.law, parameters, fmt::format("{:.3g}", 100.0 * form.rms)});
  }
  return table;
}

}  // namespace jointid::report
