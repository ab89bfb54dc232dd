#include "tasks/joint_forecast.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/control.hpp"
#include "base/error.hpp"
#include "ident/identify.hpp"
#include "ident/plan/expected_time.hpp"

namespace jointid::tasks {
namespace {

constexpr std::size_t most_lines = 60, most_unknowns = 150;
constexpr double of_95_percent = 1.959963985;

/// The scene with Method One, over lines that are spread over those of the plan.
ident::Scene on_few_lines(ident::Scene scene, const ident::Plan& plan) {
  scene.identify = {};
  scene.truth.clear();
  const double low = plan.lines.front().frequency_hz, high = plan.lines.back().frequency_hz;
  if (plan.lines.size() > most_lines) {
    scene.frequency.range_hz = ident::Range{low, high};
    scene.frequency.step_hz = (high - low) / static_cast<double>(most_lines - 1);
  }
  return scene;
}

void find_bounds(const ident::Scene& scene, const ident::Plan& plan, const ident::Control& control, JointForecast& out) {
  ident::Scene few = on_few_lines(scene, plan);
  const auto linear = ident::make_plan(few);
  ident::Control quick = control;
  quick.detail = ident::Detail::estimates;
  quick.judgement = ident::Judgement::none;
  const ident::Solution start = ident::solve(*linear, quick);
  stop_if(control.interrupted);
  few.identify.method = ident::Method::likelihood;
  few.identify.start = start.bands.front().matrices;
  const auto likely = ident::make_plan(few);
  const BoundReport report = predict_bound(*likely, {}, control);
  if (report.interrupted) throw Interrupted();
  out.bounds = report.unknowns;
  const double share = std::sqrt(static_cast<double>(likely->lines.size()) / static_cast<double>(plan.lines.size()));
  for (UnknownBound& each : out.bounds) {
    each.bound *= share;
    each.relative *= share;
  }
}

}  // namespace

JointForecast forecast_joint(const ident::Scene& scene, const ident::Control& control) {
  JointForecast out;
  const auto plan = ident::make_plan(scene);
  out.unknowns = plan->restriction.unknowns.size();
  out.seconds = ident::expected_seconds(plan->cost);
  stop_if(control.interrupted);
  if (out.unknowns > most_unknowns) {
    out.why = "more than " + std::to_string(most_unknowns) + " unknowns";
    return out;
  }
  try {
    find_bounds(scene, *plan, control, out);
  } catch (const InputError& error) {
    out.why = error.parts().problem;
  }
  return out;
}

std::array<double, 2> relative_intervals(const JointForecast& forecast) {
  std::vector<double> widths;
  for (const UnknownBound& each : forecast.bounds) {
    const bool known = std::isfinite(each.bound) && std::abs(each.value) > 0.0;
    widths.push_back(known ? of_95_percent * each.bound / std::abs(each.value) : std::numeric_limits<double>::infinity());
  }
  if (widths.empty()) return {};
  std::ranges::sort(widths);
  return {widths[widths.size() / 2], widths.back()};
}

}  // namespace jointid::tasks
