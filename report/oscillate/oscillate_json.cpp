#include <cmath>
#include <nlohmann/json.hpp>

#include "report/json_value.hpp"
#include "report/oscillate/oscillate_report.hpp"
#include "report/text/table.hpp"

namespace jointid::report {
namespace {

std::vector<double> list(const Eigen::VectorXd& numbers) { return {numbers.begin(), numbers.end()}; }

Json motion_json(const tasks::OscillateResult& run) {
  const tasks::SampledMotion& motion = *run.motion;
  Json out = {{"status", word(motion.status)},
              {"samples", motion.samples.rows()},
              {"events", motion.events},
              {"section_points", motion.section.rows()},
              {"stick_share", value(motion.stick_share)}};
  for (const tasks::SampledColumn& column : motion.columns)
    out["columns"].push_back({{"name", column.name}, {"unit", column.unit}});
  return out;
}

Json modes_json(const tasks::SeenModes& modes) {
  Json out = {{"fractions_of_sigma_squared", values(list(modes.fractions.value))},
              {"standard_errors", values(list(modes.fractions.error))},
              {"fractions_of_sigma", values(list(modes.pod.sigma_fractions()))},
              {"sigma", values(list(modes.pod.sigma))},
              {"mean", values(list(modes.pod.mean))},
              {"modes", Json::array()}};
  for (Eigen::Index k = 0; k < modes.pod.modes.cols(); ++k) out["modes"].push_back(values(list(modes.pod.modes.col(k))));
  return out;
}

Json orbit_json(const tasks::OscillateResult& run) {
  const oscillation::PeriodicOrbit& orbit = *run.orbit;
  Json out = {{"converged", orbit.converged}};
  if (!orbit.converged) return out;
  const Eigen::Index n = (orbit.state.size() - 4) / 2;
  out["period"] = value(orbit.period);
  out["residual"] = value(orbit.residual);
  out["displacement"] = values(list(orbit.state.head(n)));
  out["velocity"] = values(list(orbit.state.segment(n, n)));
  for (const Complex& each : orbit.multipliers) out["multipliers"].push_back({value(each.real()), value(each.imag())});
  return out;
}

Json exponents_json(const oscillation::Exponents& exponents) {
  return {{"status", word(exponents.status)},
          {"nats_per_second", values(exponents.exponent)},
          {"standard_errors", values(exponents.standard_error)}};
}

Json points_json(const std::vector<oscillation::SweepPoint>& points) {
  Json out = Json::array();
  for (const oscillation::SweepPoint& point : points) {
    Json one = {{"parameter", value(point.parameter)}, {"status", word(point.status)}, {"values", values(point.values)}};
    if (point.direction != 0) one["direction"] = point.direction > 0 ? "up" : "down";
    if (point.range) {
      one["smallest"] = value(point.range->smallest);
      one["largest"] = value(point.range->largest);
      one["stick_share"] = value(point.range->stick_share);
      one["break_aways"] = point.range->break_aways;
      one["returns"] = point.range->slips;
      one["period"] = point.range->slips > 0 ? value(point.range->period) : Json();
    }
    out.push_back(std::move(one));
  }
  return out;
}

Json sweep_json(const tasks::OscillateResult& run) {
  Json out = {
      {"parameter", run.swept->parameter}, {"unit", tasks::swept_unit(run.swept->parameter)}, {"points", points_json(run.sweep)}};
  if (run.sliding_limit) out["sliding_unstable_below"] = value(*run.sliding_limit);
  for (const tasks::ReducedSweep& model : run.reduced_sweeps)
    out["reduced"].push_back({{"basis", word(model.basis)}, {"order", model.order}, {"points", points_json(model.points)}});
  return out;
}

Json reduction_json(const tasks::ReductionTable& reduction) {
  Json out = {{"judged", reduction.judged.name},
              {"unit", reduction.judged.unit},
              {"largest", value(reduction.largest_judged)},
              {"full_seconds", value(reduction.full_seconds)},
              {"models", Json::array()}};
  for (const tasks::ReducedRow& row : reduction.rows) {
    out["models"].push_back({{"basis", word(row.basis)},
                             {"order", row.order},
                             {"status", word(row.error.status)},
                             {"error_of_motion", value(row.error.motion)},
                             {"error_of_energy", value(row.error.energy)},
                             {"largest_error_judged", value(row.error.observed(0))},
                             {"seconds", value(row.error.seconds)}});
  }
  return out;
}

Json normal_json(const tasks::NormalVibrationResult& result) {
  Json out = {{"natural_frequency_hz", value(result.system.natural_hz())},
              {"static_force", value(result.system.static_force())},
              {"static_slope", value(result.system.static_slope())},
              {"points", Json::array()}};
  for (std::size_t k = 0; k < result.motions.size(); ++k) {
    const oscillation::NormalMotion& motion = result.motions[k];
    out["points"].push_back({{"frequency_hz", value(result.frequencies_hz[k])},
                             {"amplitude", value(result.amplitudes[k])},
                             {"rest", value(motion.rest)},
                             {"first", {value(motion.first.real()), value(motion.first.imag())}},
                             {"force", value(motion.force)},
                             {"force_first", {value(motion.force_first.real()), value(motion.force_first.imag())}}});
  }
  return out;
}

Json thick_json(const std::vector<oscillation::ThickMode>& modes) {
  Json out = Json::array();
  for (const oscillation::ThickMode& mode : modes) {
    out.push_back({{"euler_hz", value(mode.euler_hz)},
                   {"rotary", value(mode.rotary)},
                   {"shear", value(mode.shear)},
                   {"timoshenko_hz", value(mode.timoshenko_hz)}});
  }
  return out;
}

}  // namespace

std::string oscillate_json(const tasks::OscillateResult& run) {
  const std::string failure = failure_of(run);
  Json out = {{"status", run.interrupted   ? "interrupted"
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
  if (run.normal_vibrations) out["normal_vibrations"] = normal_json(*run.normal_vibrations);
  if (!run.thick_modes.empty()) out["thick_modes"] = thick_json(run.thick_modes);
  return json_text(out);
}

namespace {

std::string title(const tasks::SampledColumn& column) {
  return column.unit.empty() ? column.name : column.name + " [" + column.unit + "]";
}

}  // namespace

std::string motion_csv(const tasks::OscillateResult& run) {
  const tasks::SampledMotion& motion = *run.motion;
  std::vector<std::string> titles;
  for (const tasks::SampledColumn& column : motion.columns) titles.push_back(title(column));
  const Eigen::Index own = run.system.kind == tasks::SystemKind::cantilever ? motion.q.rows() : 0;
  for (Eigen::Index k = 0; k < own; ++k) titles.push_back("q" + std::to_string(k + 1) + " [m]");
  std::string text = csv_line(titles);
  for (Eigen::Index i = 0; i < motion.samples.rows(); ++i) {
    std::vector<std::string> row;
    for (const double number : motion.samples.row(i)) row.push_back(csv_number(number));
    for (Eigen::Index k = 0; k < own; ++k) row.push_back(csv_number(motion.q(k, i)));
    text += csv_line(row);
  }
  return text;
}

std::string sweep_csv(const tasks::OscillateResult& run) {
  const std::string parameter = run.swept ? run.swept->parameter : "parameter";
  std::string text = csv_line({parameter, "status", run.motion->columns[1].name});
  for (const oscillation::SweepPoint& point : run.sweep) {
    if (point.values.empty()) text += csv_line({csv_number(point.parameter), word(point.status), ""});
    for (const double value : point.values)
      text += csv_line({csv_number(point.parameter), word(point.status), csv_number(value)});
  }
  return text;
}

std::string events_csv(const tasks::OscillateResult& run) {
  const tasks::SampledMotion& motion = *run.motion;
  std::vector<std::string> titles;
  for (std::size_t k = 0; k < 2 * motion.seen; ++k) titles.push_back(title(motion.columns[k + 1]));
  std::string text = csv_line(titles);
  for (Eigen::Index i = 0; i < motion.section.rows(); ++i) {
    std::vector<std::string> row;
    for (const double number : motion.section.row(i)) row.push_back(csv_number(number));
    text += csv_line(row);
  }
  return text;
}

}  // namespace jointid::report
