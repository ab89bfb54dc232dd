#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/oscillate/oscillate_report.hpp"
#include "report/json_value.hpp"
#include "report/text/table.hpp"

namespace jointid::cli {
namespace {

std::vector<double> list(const Eigen::VectorXd& numbers) { return {numbers.begin(), numbers.end()}; }

report::Json motion_json(const OscillateRun& run) {
  const SampledMotion& motion = *run.motion;
  report::Json out = {{"status", word(motion.status)},
                      {"samples", motion.samples.rows()},
                      {"events", motion.events},
                      {"section_points", motion.section.rows()},
                      {"stick_share", report::value(motion.stick_share)}};
  for (const SampledColumn& column : motion.columns) out["columns"].push_back({{"name", column.name}, {"unit", column.unit}});
  return out;
}

report::Json modes_json(const SeenModes& modes) {
  report::Json out = {{"fractions_of_sigma_squared", report::values(list(modes.fractions.value))},
                      {"standard_errors", report::values(list(modes.fractions.error))},
                      {"fractions_of_sigma", report::values(list(modes.pod.sigma_fractions()))},
                      {"sigma", report::values(list(modes.pod.sigma))},
                      {"mean", report::values(list(modes.pod.mean))},
                      {"modes", report::Json::array()}};
  for (Eigen::Index k = 0; k < modes.pod.modes.cols(); ++k) out["modes"].push_back(report::values(list(modes.pod.modes.col(k))));
  return out;
}

report::Json orbit_json(const OscillateRun& run) {
  const oscillation::PeriodicOrbit& orbit = *run.orbit;
  report::Json out = {{"converged", orbit.converged}};
  if (!orbit.converged) return out;
  const Eigen::Index n = (orbit.state.size() - 4) / 2;
  out["period"] = report::value(orbit.period);
  out["residual"] = report::value(orbit.residual);
  out["displacement"] = report::values(list(orbit.state.head(n)));
  out["velocity"] = report::values(list(orbit.state.segment(n, n)));
  for (const Complex& each : orbit.multipliers)
    out["multipliers"].push_back({report::value(each.real()), report::value(each.imag())});
  return out;
}

report::Json exponents_json(const oscillation::Exponents& exponents) {
  return {{"status", word(exponents.status)},
          {"nats_per_second", report::values(exponents.exponent)},
          {"standard_errors", report::values(exponents.standard_error)}};
}

report::Json sweep_json(const OscillateRun& run) {
  report::Json out = {
      {"parameter", run.swept->parameter}, {"unit", swept_unit(run.swept->parameter)}, {"points", report::Json::array()}};
  for (const oscillation::SweepPoint& point : run.sweep)
    out["points"].push_back({{"parameter", report::value(point.parameter)},
                             {"status", word(point.status)},
                             {"values", report::values(point.values)}});
  return out;
}

report::Json reduction_json(const ReductionTable& reduction) {
  report::Json out = {{"judged", reduction.judged.name},
                      {"unit", reduction.judged.unit},
                      {"largest", report::value(reduction.largest_judged)},
                      {"full_seconds", report::value(reduction.full_seconds)},
                      {"models", report::Json::array()}};
  for (const ReducedRow& row : reduction.rows) {
    out["models"].push_back({{"basis", word(row.basis)},
                             {"order", row.order},
                             {"status", word(row.error.status)},
                             {"error_of_motion", report::value(row.error.motion)},
                             {"error_of_energy", report::value(row.error.energy)},
                             {"largest_error_judged", report::value(row.error.observed(0))},
                             {"seconds", report::value(row.error.seconds)}});
  }
  return out;
}

}  // namespace

std::string oscillate_json(const OscillateRun& run) {
  const std::string failure = failure_of(run);
  report::Json out = {{"status", run.interrupted   ? "interrupted"
                                 : failure.empty() ? "ok"
                                                   : "unusable"},
                      {"message", failure},
                      {"title", run.title},
                      {"remarks", run.remarks},
                      {"motion", motion_json(run)}};
  if (run.modes) out["modes"] = modes_json(*run.modes);
  if (run.orbit) out["orbit"] = orbit_json(run);
  if (run.exponents) out["exponents"] = exponents_json(*run.exponents);
  if (run.swept) out["sweep"] = sweep_json(run);
  if (run.reduction) out["reduction"] = reduction_json(*run.reduction);
  return report::json_text(out);
}

namespace {

std::string title(const SampledColumn& column) {
  return column.unit.empty() ? column.name : column.name + " [" + column.unit + "]";
}

}  // namespace

std::string motion_csv(const OscillateRun& run) {
  const SampledMotion& motion = *run.motion;
  std::vector<std::string> titles;
  for (const SampledColumn& column : motion.columns) titles.push_back(title(column));
  const Eigen::Index own = run.system.kind == SystemKind::cantilever ? motion.q.rows() : 0;
  for (Eigen::Index k = 0; k < own; ++k) titles.push_back("q" + std::to_string(k + 1) + " [m]");
  std::string text = report::csv_line(titles);
  for (Eigen::Index i = 0; i < motion.samples.rows(); ++i) {
    std::vector<std::string> row;
    for (const double number : motion.samples.row(i)) row.push_back(report::csv_number(number));
    for (Eigen::Index k = 0; k < own; ++k) row.push_back(report::csv_number(motion.q(k, i)));
    text += report::csv_line(row);
  }
  return text;
}

std::string sweep_csv(const OscillateRun& run) {
  const std::string parameter = run.swept ? run.swept->parameter : "parameter";
  std::string text = report::csv_line({parameter, "status", run.motion->columns[1].name});
  for (const oscillation::SweepPoint& point : run.sweep) {
    if (point.values.empty()) text += report::csv_line({report::csv_number(point.parameter), word(point.status), ""});
    for (const double value : point.values)
      text += report::csv_line({report::csv_number(point.parameter), word(point.status), report::csv_number(value)});
  }
  return text;
}

std::string events_csv(const OscillateRun& run) {
  const SampledMotion& motion = *run.motion;
  std::vector<std::string> titles;
  for (std::size_t k = 0; k < 2 * motion.seen; ++k) titles.push_back(title(motion.columns[k + 1]));
  std::string text = report::csv_line(titles);
  for (Eigen::Index i = 0; i < motion.section.rows(); ++i) {
    std::vector<std::string> row;
    for (const double number : motion.section.row(i)) row.push_back(report::csv_number(number));
    text += report::csv_line(row);
  }
  return text;
}

}  // namespace jointid::cli
