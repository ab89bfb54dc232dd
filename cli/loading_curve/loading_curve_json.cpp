#include <nlohmann/json.hpp>

#include "cli/loading_curve/loading_curve_report.hpp"
#include "friction/path/loops.hpp"
#include "report/json_value.hpp"
#include "report/loading_curve/loading_curve_report.hpp"
#include "report/text/table.hpp"

namespace jointid::cli {
namespace {

using friction::CurveFit;
using friction::Fit;
using friction::FittedValue;

report::Json fitted_json(const FittedValue& each) {
  return {{"name", each.name},
          {"value", report::value(each.value)},
          {"unit", each.unit},
          {"std_error", report::value(each.std_error)},
          {"ci95", report::value(each.ci95)},
          {"knowledge", friction::name(each.knowledge)}};
}

report::Json parameters(const CurveFit& curve) {
  report::Json all = report::Json::array();
  for (const FittedValue& each : curve.parameters) all.push_back(fitted_json(each));
  return all;
}

report::Json curve_fit(const CurveFit& curve) {
  report::Json out = {{"curve", curve.curve.name},
                      {"parameters", parameters(curve)},
                      {"initial_stiffness", fitted_json(curve.stiffness)},
                      {"friction_limit", fitted_json(curve.limit)},
                      {"mu", curve.friction_coefficient ? fitted_json(*curve.friction_coefficient) : report::Json(nullptr)},
                      {"shows_slip", curve.shows_slip},
                      {"slipped_share", report::value(curve.slipped_share)},
                      {"objective", report::value(curve.objective)}};
  if (curve.curve.kind == friction::CurveKind::loop) out["energy_error"] = report::value(report::energy_error(curve));
  return out;
}

report::Json equivalent(const CurveFit& curve) {
  report::Json rows = report::Json::array();
  for (const friction::Equivalent& row : report::equivalents(curve, 40)) {
    rows.push_back({{"amplitude", row.amplitude},
                    {"stiffness", report::value(row.stiffness)},
                    {"damping", report::value(row.damping)},
                    {"energy", report::value(row.energy)}});
  }
  return rows;
}

report::Json fit_json(const report::LoadingCurveReport& report, const Fit& fit) {
  report::Json out = {{"law", fit.law},
                      {"title", fit.title},
                      {"status", friction::name(fit.status)},
                      {"message", fit.message},
                      {"minimiser", fit.minimiser},
                      {"iterations", fit.iterations},
                      {"rows", fit.rows},
                      {"unknowns", fit.names},
                      {"aic", report::value(fit.aic)},
                      {"aic_above_best", report::value(fit.aic - report.fits.front().aic)},
                      {"objective", report::value(fit.objective)},
                      {"residual_std", report::value(fit.residual_std)},
                      {"neighbour_correlation", report::value(fit.neighbour_correlation)},
                      {"correlation", report::values(fit.correlation)},
                      {"findings", fit.findings}};
  out["curves"] = report::Json::array();
  for (const CurveFit* each : different(report, fit)) {
    out["curves"].push_back(curve_fit(*each));
    out["curves"].back()["equivalent"] = equivalent(*each);
  }
  return out;
}

report::Json curve_json(const friction::Curve& curve) {
  report::Json out = {{"name", curve.name}, {"samples", curve.u.size()}, {"largest_displacement", curve.largest_displacement()}};
  if (curve.kind == friction::CurveKind::loop) out["energy"] = friction::Loop{{curve.u, curve.value}, curve.turn}.energy();
  if (curve.normal_load) out["normal_load"] = *curve.normal_load;
  return out;
}

std::vector<std::string> csv_row(const Fit& fit, const CurveFit& curve, const FittedValue& each) {
  return {fit.law,
          curve.curve.name,
          each.name,
          report::csv_number(each.value),
          each.unit,
          report::csv_number(each.std_error),
          each.ci95 ? report::csv_number((*each.ci95)[0]) : "",
          each.ci95 ? report::csv_number((*each.ci95)[1]) : "",
          friction::name(each.knowledge),
          report::csv_number(fit.aic),
          friction::name(fit.status)};
}

void add_rows(const Fit& fit, const CurveFit& curve, std::string& text) {
  std::vector<FittedValue> all = curve.parameters;
  all.push_back(curve.stiffness);
  all.push_back(curve.limit);
  if (curve.friction_coefficient) all.push_back(*curve.friction_coefficient);
  for (const FittedValue& each : all) text += report::csv_line(csv_row(fit, curve, each));
}

}  // namespace

std::string loading_curve_json(const report::LoadingCurveReport& report) {
  const Fit& best = report.fits.front();
  report::Json json = {
      {"status", friction::name(best.status)}, {"message", best.message}, {"best_law", best.law}, {"notes", report.data.notes}};
  json["curves"] = report::Json::array();
  for (const friction::Curve& curve : report.data.curves) json["curves"].push_back(curve_json(curve));
  json["fits"] = report::Json::array();
  for (const Fit& fit : report.fits) json["fits"].push_back(fit_json(report, fit));
  if (!report.of_loops.empty()) {
    json["loops"] = report::Json::array();
    for (const auto& fits : report.of_loops) {
      for (const Fit& fit : fits) {
        if (fit.curves.empty()) continue;
        report::Json& loop = json["loops"].emplace_back(curve_fit(fit.curves[0]));
        loop["law"] = fit.law;
        loop["aic"] = report::value(fit.aic);
        loop["status"] = friction::name(fit.status);
      }
    }
  }
  return report::json_text(json);
}

std::string loading_curve_csv(const report::LoadingCurveReport& report) {
  std::string text = report::csv_line(
      {"law", "curve", "name", "value", "unit", "std_error", "ci95_low", "ci95_high", "knowledge", "aic", "status"});
  for (const Fit& fit : report.fits) {
    for (const CurveFit* curve : different(report, fit)) {
      CurveFit named = *curve;
      if (report.data.loops && fit.curves.size() > 1) named.curve.name = "all loops";
      add_rows(fit, named, text);
    }
  }
  for (const auto& fits : report.of_loops) {
    for (const Fit& fit : fits) {
      for (const CurveFit& curve : fit.curves) add_rows(fit, curve, text);
    }
  }
  return text;
}

}  // namespace jointid::cli
