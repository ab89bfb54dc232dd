#include "gui/solve/solve_job.hpp"

#include <cmath>

#include "base/control.hpp"
#include "ident/identify.hpp"
#include "report/solution_json.hpp"

namespace jointid::gui {
namespace {

ident::Control control_of(const Worker::Watch& watch) {
  ident::Control control;
  control.interrupted = watch.interrupted;
  control.progress = watch.progress;
  return control;
}

void mark_interrupted(ident::Solution& best) {
  const std::string when = best.fit.iterations > 0 ? " after " + std::to_string(best.fit.iterations) + " iterations" : "";
  best.status = ident::Status::not_converged;
  best.message = "Interrupted" + when + ": these are the best values so far." + (best.message.empty() ? "" : " ") + best.message;
}

Curve curve_of(const ident::Regenerated& all, const ident::RegeneratedFrf& frf, bool is_measured) {
  Curve curve;
  curve.name = (is_measured ? "measured  " : "regenerated  ") + frf.entry.response.name() + " / " + frf.entry.reference.name();
  curve.response = frf.entry.response;
  curve.reference = frf.entry.reference;
  curve.frequency_hz = all.frequency_hz;
  curve.values = is_measured ? frf.measured : frf.predicted;
  curve.is_measured = is_measured;
  return curve;
}

}  // namespace

Solved solve_scene(const ident::Scene& scene, const Worker::Watch& watch) {
  Solved solved;
  watch.progress("planning", 0, 0);
  solved.plan = ident::make_plan(scene);
  stop_if(watch.interrupted);
  std::optional<ident::Solution> best;
  ident::Control control = control_of(watch);
  control.judgement = ident::Judgement::data;
  control.so_far = [&](const ident::Solution& solution) { best = solution; };
  try {
    solved.solution = ident::solve(*solved.plan, control);
  } catch (const Interrupted&) {
    if (!best) throw;
    mark_interrupted(*best);
    solved.solution = std::move(*best);
  }
  return solved;
}

ident::BoundReport predict_bound(const ident::Scene& scene, const Worker::Watch& watch) {
  const auto plan = ident::make_plan(scene);
  return ident::predict_bound(*plan, {}, control_of(watch));
}

std::string json_of(const Solved& solved) { return report::solution_json(solved.solution); }

Overlay regenerate_frf(const Solved& solved, const ident::FrfEntry& entry, const Worker::Watch& watch) {
  const ident::Regenerated all = ident::regenerate(*solved.plan, solved.solution.bands, {entry}, control_of(watch));
  const ident::RegeneratedFrf& frf = all.frfs.front();
  return {{curve_of(all, frf, true), curve_of(all, frf, false)}, ident::decibel_error(frf)};
}

}  // namespace jointid::gui
