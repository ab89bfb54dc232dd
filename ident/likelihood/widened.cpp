#include "ident/likelihood/widened.hpp"

#include <algorithm>
#include <cmath>

#include "base/eigen.hpp"
#include "ident/likelihood/data/likelihood_plan.hpp"
#include "ident/likelihood/errors/chi_square_law.hpp"
#include "ident/likelihood/errors/interval_notes.hpp"
#include "ident/likelihood/errors/sensor_scatter.hpp"
#include "ident/likelihood/findings/chi_square.hpp"
#include "ident/likelihood/findings/joint_part.hpp"
#include "ident/likelihood/findings/under_ties.hpp"
#include "minimise/linear/covariance.hpp"
#include "minimise/linear/null_space.hpp"

namespace jointid::ident {
namespace {

/// A stretch of frequencies at three standard deviations or more; nullptr: none is seen.
const FileGain* seen_stretch(const TriedErrors& tried) {
  constexpr double seen = 3.0;
  const FileGain* const stretch = tried.stretch();
  return stretch != nullptr && std::abs(stretch->score) >= seen ? stretch : nullptr;
}

/// A stretch of a file's frequencies that is seen.
struct SeenStretch {
  const FileGain* stretch = nullptr;     ///< as the lines count in the fit; nullptr: none is seen
  FileGain told = {};                    ///< the same where lines that it explains count in full
  Eigen::VectorXd step = {};             ///< of the unknowns by the lines' weights, without the stretch
};

/// A stretch makes lines on resonances outliers, and the fit sets aside what tells most of it. Where it explains half of what is set
/// aside, the lines count in full.
SeenStretch seen_stretch(const Plan& plan, const Fitted& all, const Control& control) {
  const LikelihoodFit& fit = all.found.fit;
  SeenStretch seen{.stretch = seen_stretch(*all.tried)};
  const Eigen::Index known = at(fit.theta.size());
  seen.step = Eigen::VectorXd::Zero(known);
  if (seen.stretch == nullptr) return seen;
  seen.told = *seen.stretch;
  LikelihoodFit whole = fit;
  std::vector<double> aside;
  for (double& weight : whole.line_weight) {
    aside.push_back(weight > 0.0 ? 1.0 - weight : 0.0);
    if (weight > 0.0) weight = 1.0;
  }
  const double set_aside = excess_of(all.chi_square, *likelihood_plan(plan)->observations, aside);
  if (!(set_aside > 0.0)) return seen;
  LinearisedLikelihood::NearbyGradients of_no_use;
  Control without_sensors = control;
  without_sensors.detail = Detail::estimates;
  const auto more = try_errors(plan, all.found, whole, all.ratio, without_sensors, of_no_use);
  const FileGain* const found = more ? more->stretch() : nullptr;
  if (found == nullptr || found - more->stretches.data() != seen.stretch - all.tried->stretches.data()) return seen;
  const double explained = found->score * found->score - seen.stretch->score * seen.stretch->score;
  if (!(explained * all.tried->inflation * all.tried->inflation > 0.5 * set_aside)) return seen;
  seen.step = minimise::covariance_of(more->scores.information.topLeftCorner(known, known)) * more->scores.gradient.head(known);
  seen.told = *found;
  return seen;
}

/// χ² over degrees of freedom once a stretch is taken off: as much of its excess goes as of the lines as they count.
double ratio_without(const Plan& plan, const Fitted& all, const FileGain* stretch) {
  if (stretch == nullptr) return all.ratio;
  const double excess = excess_of(all.chi_square, *likelihood_plan(plan)->observations, all.found.fit.line_weight);
  const double explained = std::pow(stretch->score * all.tried->inflation, 2);
  return explained >= excess ? std::min(all.ratio, 1.0) : 1.0 + (all.ratio - 1.0) * (1.0 - explained / excess);
}

/// Where there is misfit, what a stretch does not explain of it is looked for at one standard deviation, not at five.
constexpr double still_there = 0.2;

}  // namespace

Widened widened(const Plan& plan, const Fitted& all, const Eigen::MatrixXd& information, const Control& control, Solution& out) {
  const ChiSquare& chi_square = all.chi_square;
  const std::size_t joint = plan.columns->size();
  Widened to{Intervals(covariance_under_ties(plan, joint_information(information, joint)))};
  to.likely = likely_chi_square(plan, chi_square.degrees_of_freedom, likelihood_plan(plan)->observations->mirror_differences());
  if (!all.tried || !all.may_widen(plan) || minimise::null_space_of(all.found.fit.information).cols() > 0) return to;
  const TriedErrors& tried = *all.tried;
  if (!tried.files.empty() && !tried.is_calibration_stated) to.intervals.add_gain(tried.files.front());
  note_calibration(to.intervals.cost(), all.without, tried, out);
  tell_shared_errors(plan, tried, information, to.intervals, out);
  const SeenStretch seen = seen_stretch(plan, all, control);
  if (seen.stretch != nullptr) tell_stretch(plan, all.found.fit, seen.told, seen.step, to.intervals, out);
  if (!all.without && !tried.is_calibration_stated) tell_unexplained_gain(tried, to.intervals, out);
  const double left = ratio_without(plan, all, seen.stretch);
  to.includes_misfit = all.ratio > to.likely;
  const bool exceeds = to.includes_misfit && left > 1.0 + still_there * (to.likely - 1.0);
  const auto jackknife = tried.jackknife(all.found.fit.theta.size(), seen.stretch);
  const bool scatters = jackknife && jackknife->tells_more() && !tried.shared.are_seen();
  if (jackknife && (exceeds || scatters)) to.intervals.include_misfit(*jackknife, exceeds ? std::sqrt(std::max(1.0, left)) : 1.0);
  const auto sensors = exceeds ? sensor_scatter(plan, all.found, all.found.fit, all.found.fit.information, control) : std::nullopt;
  if (sensors) to.intervals.include_sensors(*sensors);
  if (scatters && !to.includes_misfit) tell_scatter(*jackknife, out);
  to.includes_misfit = to.includes_misfit && (jackknife || sensors || !exceeds);
  return to;
}

}  // namespace jointid::ident
