#include <nlohmann/json.hpp>

#include "friction/path/loops.hpp"
#include "report/json_value.hpp"
#include "report/loading_curve/loading_curve_text.hpp"
#include "report/text/table.hpp"
#include "tasks/loading_curve/loading_curve_result.hpp"

namespace jointid::report {
namespace {

using friction::CurveFit;
using friction::Fit;
using friction::FittedValue;

Json fitted_json(const FittedValue& each) {
  return {{"name", each.name},        {"value", value(each.value)},
          {"unit", each.unit},        {"std_error", value(each.std_error)},
          {"ci95", value(each.ci95)}, {"knowledge", friction::name(each.knowledge)}};
}

Json parameters(const CurveFit& curve) {
  Json all = Json::array();
  for (const FittedValue& each : curve.parameters) all.push_back(fitted_json(each));
  return all;
}

Json curve_fit(const CurveFit& curve) {
  Json out = {{"curve", curve.curve.name},
              {"parameters", parameters(curve)},
              {"initial_stiffness", fitted_json(curve.stiffness)},
              {"friction_limit", fitted_json(curve.limit)},
              {"mu", curve.friction_coefficient ? fitted_json(*curve.friction_coefficient) : Json(nullptr)},
              {"shows_slip", curve.shows_slip},
              {"slipped_share", value(curve.slipped_share)},
              {"objective", value(curve.objective)}};
  if (curve.curve.kind == friction::CurveKind::loop) out["energy_error"] = value(tasks::energy_error(curve));
  return out;
}

Json equivalent(const CurveFit& curve) {
  Json rows = Json::array();
  for (const friction::Equivalent& row : tasks::equivalents(curve, 40)) {
    rows.push_back({{"amplitude", row.amplitude},
                    {"stiffness", value(row.stiffness)},
                    {"damping", value(row.damping)},
                    {"energy", value(row.energy)}});
  }
  return rows;
}

Json fit_json(const tasks::LoadingCurveResult& result, const Fit& fit) {
  Json out = {{"law", fit.law},
              {"title", fit.title},
              {"status", name(fit.status)},
              {"message", fit.message},
              {"minimiser", fit.minimiser},
              {"iterations", fit.iterations},
              {"rows", fit.rows},
              {"unknowns", fit.names},
              {"aic", value(fit.aic)},
              {"aic_above_best", value(fit.aic - result.fits.front().aic)},
              {"objective", value(fit.objective)},
              {"residual_std", value(fit.residual_std)},
              {"neighbour_correlation", value(fit.neighbour_correlation)},
              {"correlation", values(fit.correlation)},
              {"findings", fit.findings}};
  out["curves"] = Json::array();
  for (const CurveFit* each : tasks::different(result, fit)) {
    out["curves"].push_back(curve_fit(*each));
    out["curves"].back()["equivalent"] = equivalent(*each);
  }
  return out;
}

Json curve_json(const friction::Curve& curve) {
  Json out = {{"name", curve.name}, {"samples", curve.u.size()}, {"largest_displacement", curve.largest_displacement()}};
  if (curve.kind == friction::CurveKind::loop) out["energy"] = friction::Loop{{curve.u, curve.value}, curve.turn}.energy();
  if (curve.normal_load) out["normal_load"] = *curve.normal_load;
  return out;
}

std::vector<std::string> csv_row(const Fit& fit, const CurveFit& curve, const FittedValue& each) {
  return {fit.law,
          curve.curve.name,
          each.name,
          csv_number(each.value),
          each.unit,
          csv_number(each.std_error),
          each.ci95 ? csv_number((*each.ci95)[0]) : "",
          each.ci95 ? csv_number((*each.ci95)[1]) : "",
          friction::name(each.knowledge),
          csv_number(fit.aic),
          name(fit.status)};
}

void add_rows(const Fit& fit, const CurveFit& curve, std::string& text) {
  std::vector<FittedValue> all = curve.parameters;
  all.push_back(curve.stiffness);
  all.push_back(curve.limit);
  if (curve.friction_coefficient) all.push_back(*curve.friction_coefficient);
  for (const FittedValue& each : all) text += csv_line(csv_row(fit, curve, each));
}

}  // namespace

std::string loading_curve_json(const tasks::LoadingCurveResult& result) {
  const Fit& best = result.fits.front();
  Json json = {
      {"status", name(best.status)}, {"message", best.message}, {"best_law", best.law}, {"notes", result.data.notes}};
  json["curves"] = Json::array();
  for (const friction::Curve& curve : result.data.curves) json["curves"].push_back(curve_json(curve));
  json["fits"] = Json::array();
  for (const Fit& fit : result.fits) json["fits"].push_back(fit_json(result, fit));
  for (const friction::SlipShares& slopes : result.slopes) {
    Json one = {{"stiffness", value(slopes.stiffness)}, {"displacement", values(slopes.u)}, {"share", values(slopes.h)}};
    for (const friction::SlipForm& form : slopes.forms)
      one["forms"].push_back({{"law", form.law}, {"parameters", values(form.parameters)}, {"rms", value(form.rms)}});
    json["slopes"].push_back(std::move(one));
  }
  if (!result.of_loops.empty()) {
    json["loops"] = Json::array();
    for (const auto& fits : result.of_loops) {
      for (const Fit& fit : fits) {
        if (fit.curves.empty()) continue;
        Json& loop = json["loops"].emplace_back(curve_fit(fit.curves[0]));
        loop["law"] = fit.law;
        loop["aic"] = value(fit.aic);
        loop["status"] = name(fit.status);
      }
    }
  }
  return json_text(json);
}

std::string loading_curve_csv(const tasks::LoadingCurveResult& result) {
  std::string text =
      csv_line({"law", "curve", "name", "value", "unit", "std_error", "ci95_low", "ci95_high", "knowledge", "aic", "status"});
  for (const Fit& fit : result.fits) {
    for (const CurveFit* curve : tasks::different(result, fit)) {
      CurveFit named = *curve;
      if (result.data.loops && fit.curves.size() > 1) named.curve.name = "all loops";
      add_rows(fit, named, text);
    }
  }
  for (const auto& fits : result.of_loops) {
    for (const Fit& fit : fits) {
      for (const CurveFit& curve : fit.curves) add_rows(fit, curve, text);
    }
  }
  return text;
}

}  // namespace jointid::report
