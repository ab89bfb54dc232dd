#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/oscillate/oscillate_report.hpp"
#include "report/text/notes.hpp"
#include "report/text/table.hpp"

namespace jointid::report {
namespace {

constexpr Eigen::Index most_fractions = 12;

std::string with_error(double value, double error) { return fmt::format("{} ± {:.1g}", number(value, error), error); }

/// Distinct values of a point of the sweep, to a part in 10⁵ of the largest.
std::size_t distinct(std::vector<double> values) {
  if (values.empty()) return 0;
  std::ranges::sort(values);
  const double width = 1e-5 * std::max(std::abs(values.front()), std::abs(values.back()));
  std::size_t count = 1;
  for (std::size_t k = 1; k < values.size(); ++k) count += values[k] - values[k - 1] > width ? 1U : 0U;
  return count;
}

}  // namespace

std::string time_unit(const tasks::OscillateResult& run) {
  return run.system.kind == tasks::SystemKind::cantilever || run.system.kind == tasks::SystemKind::matrices ? "s"
                                                                                                            : "unit of time";
}

Table fractions_table(const tasks::SeenModes& modes) {
  Table table({{"modes"}, {"Σσ² %"}, {"std error"}, {"Σσ %"}});
  const Eigen::VectorXd sigmas = modes.pod.sigma_fractions();
  for (Eigen::Index k = 0; k < std::min(sigmas.size(), most_fractions); ++k) {
    table.add({fmt::format("{}", k + 1), fmt::format("{:.4f}", 100.0 * modes.fractions.value(k)),
               fmt::format("{:.4f}", 100.0 * modes.fractions.error(k)), fmt::format("{:.2f}", 100.0 * sigmas(k))});
  }
  return table;
}

Table shapes_table(const tasks::OscillateResult& run) {
  const oscillation::Pod& pod = run.modes->pod;
  const Eigen::Index count = std::min<Eigen::Index>(pod.modes.cols(), 6);
  std::vector<Column> columns = {{"", Align::left}, {"mean"}};
  for (Eigen::Index k = 0; k < count; ++k) columns.push_back({fmt::format("mode {}", k + 1)});
  Table table(columns);
  for (std::size_t i = 0; i < run.motion->seen; ++i) {
    std::vector<std::string> row = {run.motion->columns[i + 1].name, number(pod.mean(at(i)))};
    for (Eigen::Index k = 0; k < count; ++k) row.push_back(fmt::format("{:.5f}", pod.modes(at(i), k)));
    table.add(row);
  }
  return table;
}

Table multipliers_table(const oscillation::PeriodicOrbit& orbit) {
  Table table({{"multiplier"}, {"modulus"}, {"real"}, {"imaginary"}});
  for (std::size_t k = 0; k < std::min<std::size_t>(orbit.multipliers.size(), 6); ++k) {
    const Complex& each = orbit.multipliers[k];
    table.add({fmt::format("{}", k + 1), fmt::format("{:.8f}", std::abs(each)), fmt::format("{:.8f}", each.real()),
               fmt::format("{:.8f}", each.imag())});
  }
  return table;
}

Table exponents_table(const oscillation::Exponents& exponents, const std::string& unit) {
  Table table({{"exponent"}, {"nats per " + unit}, {"bits per " + unit}});
  for (std::size_t k = 0; k < exponents.exponent.size(); ++k) {
    const double nats = exponents.exponent[k], error = exponents.standard_error[k];
    table.add({fmt::format("{}", k + 1), with_error(nats, error), with_error(nats / std::log(2.0), error / std::log(2.0))});
  }
  return table;
}

Table reduction_table(const tasks::ReductionTable& reduction) {
  const bool strain = reduction.judged.unit == "m/m";
  const double scale = strain ? 1e6 : 1.0;
  Table table({{"basis", Align::left},
               {"m"},
               {"ΔX %"},
               {"ΔE %"},
               {fmt::format("largest error of {}{}", reduction.judged.name, strain ? ", µε" : "")},
               {"run time ms"},
               {"", Align::left}});
  table.add({"full model", "", "", "", fmt::format("of {:.4g}", scale * reduction.largest_judged),
             fmt::format("{:.2f}", 1e3 * reduction.full_seconds), ""});
  for (const tasks::ReducedRow& row : reduction.rows) {
    table.add({word(row.basis), fmt::format("{}", row.order), fmt::format("{:.3g}", 100.0 * row.error.motion),
               fmt::format("{:.3g}", 100.0 * row.error.energy), fmt::format("{:.3g}", scale * row.error.observed(0)),
               fmt::format("{:.2f}", 1e3 * row.error.seconds),
               row.error.status == oscillation::MotionEnd::ok ? "" : word(row.error.status)});
  }
  return table;
}

Table normal_table(const tasks::NormalVibrationResult& result) {
  Table table(
      {{"slider Hz"}, {"amplitude m"}, {"N0 N"}, {"N1 with the slider"}, {"N1 a quarter ahead"}, {"|N1|/N0 %"}, {"nub m"}});
  for (std::size_t k = 0; k < result.motions.size(); ++k) {
    const oscillation::NormalMotion& motion = result.motions[k];
    table.add({number(result.frequencies_hz[k]), number(result.amplitudes[k]), number(motion.force),
               number(motion.force_first.real()), number(motion.force_first.imag()),
               fmt::format("{:.3g}", 100.0 * std::abs(motion.force_first) / motion.force), number(std::abs(motion.first))});
  }
  return table;
}

std::string normal_line(const tasks::NormalVibrationResult& result) {
  return fmt::format(
      "N = {:.6g} N {} {:.6g} N/m times the slider's displacement while nothing vibrates; the nub and the springs resonate "
      "at {:.4g} Hz, where this changes its sign",
      result.system.static_force(), result.system.static_slope() < 0.0 ? "−" : "+", std::abs(result.system.static_slope()),
      result.system.natural_hz());
}

Table thick_table(const std::vector<oscillation::ThickMode>& modes) {
  Table table({{"mode"}, {"Euler Hz"}, {"rotary inertia %"}, {"shear %"}, {"both, first order Hz"}, {"Timoshenko Hz"}});
  for (std::size_t k = 0; k < modes.size(); ++k) {
    const oscillation::ThickMode& mode = modes[k];
    table.add({fmt::format("{}", k + 1), fmt::format("{:.7g}", mode.euler_hz), fmt::format("{:.3g}", 100.0 * mode.rotary),
               fmt::format("{:.3g}", 100.0 * mode.shear), fmt::format("{:.7g}", mode.euler_hz * (1.0 + mode.rotary + mode.shear)),
               fmt::format("{:.7g}", mode.timoshenko_hz)});
  }
  return table;
}

std::string motion_line(const tasks::OscillateResult& run) {
  const tasks::SampledMotion& motion = *run.motion;
  return fmt::format("{} samples, {} events, {} {} of the Poincaré section, sticking {:.1f} % of the time; status {}",
                     motion.samples.rows(), motion.events, motion.section.rows(),
                     run.system.is_driven() ? "cycles" : "break-aways", 100.0 * motion.stick_share, word(motion.status));
}

std::string orbit_line(const tasks::OscillateResult& run) {
  const oscillation::PeriodicOrbit& orbit = *run.orbit;
  if (!orbit.converged) return fmt::format("not found (residual {:.1e})", orbit.residual);
  const double largest = orbit.multipliers.empty() ? 0.0 : std::abs(orbit.multipliers.front());
  return fmt::format("period {:.12g} {}, residual {:.1e}, {}", orbit.period, time_unit(run), orbit.residual,
                     largest > 1.0 ? "unstable" : "stable");
}

std::string sweep_line(const tasks::OscillateResult& run) {
  std::size_t values = 0, single = 0, many = 0, none = 0;
  for (const oscillation::SweepPoint& point : run.sweep) {
    const std::size_t count = distinct(point.values);
    values += point.values.size();
    none += count == 0 || (run.system.is_driven() && point.values.empty()) ? 1U : 0U;
    single += count == 1 ? 1 : 0;
    many += count > 20 ? 1 : 0;
  }
  return fmt::format("{} from {:g} to {:g}: {} of {} parameters, {} values; one value at {}, more than 20 at {}, none at {}",
                     run.swept->parameter, run.swept->from, run.swept->to, run.sweep.size(),
                     run.swept->back ? 2 * run.swept->points - 1 : run.swept->points, values, single, many, none);
}

/// Of each parameter: from where it was reached, the range of the contact (a cantilever: the strain), how often it returns, how
/// long it sticks.
Table ranges_table(const tasks::OscillateResult& run, const std::vector<oscillation::SweepPoint>& points) {
  Table table({{run.swept->parameter},
               {"from", Align::left},
               {"smallest"},
               {"largest"},
               {"range"},
               {"returns"},
               {"period"},
               {"break-aways"},
               {"stick"}});
  for (const oscillation::SweepPoint& point : points) {
    const std::string from = point.direction == 0 ? "–" : point.direction > 0 ? "below" : "above";
    if (!point.range) {
      table.add({number(point.parameter), from, word(point.status), "–", "–", "–", "–", "–", "–"});
      continue;
    }
    const oscillation::SweptRange& range = *point.range;
    table.add({number(point.parameter), from, number(range.smallest), number(range.largest),
               number(range.largest - range.smallest), range.slips > 0 ? std::to_string(range.slips) : "–",
               range.slips > 0 ? number(range.period) : "–", std::to_string(range.break_aways),
               fmt::format("{:.3f}", range.stick_share)});
  }
  return table;
}

std::string oscillate_text(const tasks::OscillateResult& run) {
  std::string text = run.title.empty() ? "" : run.title + "\n";
  text += notes_text(run.remarks);
  text += "motion: " + motion_line(run) + "\n";
  if (run.modes) {
    text +=
        "\nproper orthogonal modes of what is seen; standard errors by a jackknife over 20 segments, which mean nothing for a "
        "periodic motion\n" +
        fractions_table(*run.modes).text() + "\n" + shapes_table(run).text();
  }
  if (run.orbit) {
    text += "\nperiodic orbit: " + orbit_line(run) + "\n";
    if (run.orbit->converged) text += multipliers_table(*run.orbit).text();
  }
  if (run.exponents) text += "\nexponents of the model\n" + exponents_table(*run.exponents, time_unit(run)).text();
  if (run.swept) text += "\nsweep: " + sweep_line(run) + "\n";
  if (run.sliding_limit) text += fmt::format("steady sliding is unstable below {:.10g}\n", *run.sliding_limit);
  if (run.swept && run.swept->ranges()) text += ranges_table(run, run.sweep).text();
  for (const tasks::ReducedSweep& model : run.reduced_sweeps)
    text +=
        fmt::format("\nthe same with {} of order {}\n", word(model.basis), model.order) + ranges_table(run, model.points).text();
  if (run.reduction) text += "\nreduced models\n" + reduction_table(*run.reduction).text();
  if (run.normal_vibrations)
    text += "\nnormal load: " + normal_line(*run.normal_vibrations) + "\n" + normal_table(*run.normal_vibrations).text();
  if (!run.thick_modes.empty()) text += "\nthe beam with shear and rotary inertia\n" + thick_table(run.thick_modes).text();
  return text;
}

}  // namespace jointid::report
