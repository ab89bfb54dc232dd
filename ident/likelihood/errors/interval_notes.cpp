#include "ident/likelihood/errors/interval_notes.hpp"

#include <algorithm>
#include <cmath>

#include "base/eigen.hpp"
#include "base/text.hpp"
#include "ident/judgement/judge.hpp"
#include "ident/likelihood/errors/gain_scores.hpp"

namespace jointid::ident {
namespace {

void add_note(std::size_t file, const std::string& sentence, Solution& out) {
  if (file >= out.variances.size()) return;
  std::string& note = out.variances[file].note;
  note += (note.empty() ? "" : "; ") + sentence;
}

/// The part of a bias that an interval does not hold, largest over the unknowns, in half widths.
double largest_part(const Eigen::VectorXd& bias, const Intervals& intervals) {
  return bias.cwiseAbs().cwiseQuotient(intervals.half_widths()).maxCoeff();
}

/// Of H1 in every file: θ as it would be if all that FRFs to one reference share were noise of the force.
Eigen::VectorXd bias_of(const TriedErrors& tried, Eigen::Index joint) {
  Eigen::VectorXd out = Eigen::VectorXd::Zero(joint);
  for (std::size_t f = 0; f < tried.files.size(); ++f) out += tried.shared.bias(f) * tried.files[f].answer.head(joint);
  return out;
}

/// How uncertain that is: the files apart.
Eigen::MatrixXd bias_scatter_of(const TriedErrors& tried, Eigen::Index joint) {
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(joint, joint);
  for (std::size_t f = 0; f < tried.files.size(); ++f) {
    const Eigen::VectorXd each = tried.shared.bias_deviation(f) * tried.files[f].answer.head(joint);
    out += each * each.transpose();
  }
  return out;
}

/// dθ/dδ of a joint that is not stretched with the assembly that is measured: K and D twice, C once.
Eigen::VectorXd of_a_free_joint(const Plan& plan, const LikelihoodFit& fit) {
  Eigen::VectorXd out(at(plan.columns->size()));
  for (std::size_t column = 0; column < plan.columns->size(); ++column) {
    using enum restrictions::Kind;
    const restrictions::Kind kind = plan.restriction.unknowns[plan.columns->unknown_of(column)].kind;
    out[at(column)] = fit.theta[column] * (kind == mass ? 0.0 : kind == viscous_damping ? 1.0 : 2.0);
  }
  return out;
}

double largest_bias(const TriedErrors& tried) {
  double out = 0.0;
  for (std::size_t f = 0; f < tried.files.size(); ++f) out = std::max(out, tried.shared.bias(f));
  return out;
}

}  // namespace

bool has_better_explanation(const TriedErrors& tried, const FileGain& gain) {
  if (tried.shared.are_seen()) return true;
  if (tried.stretch() && std::abs(tried.stretch()->score) > std::abs(gain.score)) return true;
  const auto suspects = suspect_gains(tried, static_cast<std::size_t>(gain.answer.size()));
  return !suspects.empty() && std::abs(suspects.front().score) > std::abs(gain.score);
}

void note_calibration(double cost, const std::optional<FileGain>& estimated, const TriedErrors& tried, Solution& out) {
  if (estimated || tried.files.empty() || tried.is_calibration_stated || out.variances.empty()) return;
  add_note(out.variances.size() - 1,
           "FRFs of the assembly have a gain of 1 ± " + digits(usual_calibration, "%.2g") +
               " against those of the parts: intervals are up to " + digits(cost, "%.3g") +
               " times as wide as with exact calibration ([[data.gains]] gain = 0)",
           out);
}

void tell_shared_errors(const Plan& plan, const TriedErrors& tried, const Eigen::MatrixXd& information, Intervals& intervals,
                        Solution& out) {
  if (tried.trials.references.empty()) return;
  if (!tried.shared.are_seen()) {
    add_note(0, "errors of FRFs of one hit are assumed independent; the residuals do not contradict it", out);
    return;
  }
  const double before = intervals.cost();
  intervals.add_shared(tried.shared, information);
  const Eigen::VectorXd bias = bias_of(tried, at(plan.columns->size()));
  const double part = largest_part(bias, intervals);
  intervals.add_bias({bias}, bias_scatter_of(tried, bias.size()));
  add_note(0,
           "errors of FRFs of one hit are alike, as noise of the force's signal makes them: intervals have it, and a bias of H1 up to " +
               percent(largest_bias(tried)) + ", and are up to " + digits(intervals.cost() / before, "%.2g") + " times as wide",
           out);
  if (!(part > 1.0)) return;
  tell(out, Status::doubtful,
       "Noise of the force's signal: errors of FRFs of one hit are alike, and H1 is then too low by up to " +
           percent(largest_bias(tried)) + ", which may move unknowns by up to " + digits(part, "%.2g") +
           " half widths of their intervals. Intervals cover both: no bias, and all of it. Use an estimator that noise of the "
           "force does not bias (H2, Hv), or a force with less noise.");
}

void tell_stretch(const Plan& plan, const LikelihoodFit& fit, const FileGain& stretch, const Eigen::VectorXd& step,
                  Intervals& intervals, Solution& out) {
  constexpr double told = 4.5, told_if_wide = 3.5;
  const Eigen::VectorXd answer = stretch.answer.head(at(plan.columns->size()));
  std::vector<Eigen::VectorXd> shifts = {step.head(answer.size()) + stretch.gain * answer};
  if (stretch.file.of_assembly) shifts.push_back(shifts.front() + stretch.gain * of_a_free_joint(plan, fit));
  const bool is_wide = largest_part(shifts.front(), intervals) > 1.0;
  intervals.add_bias(shifts, stretch.error * stretch.error * answer * answer.transpose());
  if (!(std::abs(stretch.score) >= (is_wide ? told_if_wide : told))) return;
  tell(out, Status::doubtful,
       (stretch.file.of_assembly ? "The assembly fits the parts" : stretch.file.name + " fits the other files") +
           " better with frequencies " + digits(100.0 * std::abs(stretch.gain), "%.2g") + " % " +
           (stretch.gain > 0.0 ? "lower" : "higher") + " (" + digits(std::abs(stretch.score), "%.2g") +
           " standard deviations): was the temperature another one, or a clock? Intervals cover both: no shift, and all of it.");
}

void tell_scatter(const Jackknife& jackknife, Solution& out) {
  tell(out, Status::doubtful,
       "Blocks of lines disagree on the joint by " + digits(std::sqrt(jackknife.mean), "%.2g") +
           " times what their errors explain, though χ² is as expected: the parts may have changed between the tests (temperature, "
           "supports). Standard errors and intervals include that.");
}

void tell_unexplained_gain(const TriedErrors& tried, Intervals& intervals, Solution& out) {
  constexpr double more = 3.0 * 4.5;
  const FileGain* const gain = telling_gain(tried.files);
  if (gain == nullptr || (tried.shared.are_seen() && std::abs(gain->score) < more)) return;
  if (tried.stretch() && std::abs(tried.stretch()->score) > std::abs(gain->score)) return;
  if (!gain->file.of_assembly) intervals.add_bias({gain->gain * gain->answer.head(intervals.covariance().rows())}, {});
  tell(out, Status::doubtful,
       "The FRFs of " + (gain->file.of_assembly ? std::string("the assembly") : gain->file.name) + " fit the others better with a " +
           "common gain of " + digits(1.0 + gain->gain, "%.4f") + " (" + digits(std::abs(gain->score), "%.2g") +
           " standard deviations from 1), which does not explain all: is a calibration off, or a sensor's? Intervals reach from none to "
           "all of what it does.");
}

void tell_common_gain(const FileGain& gain, Solution& out) {
  if (out.systematic.empty()) return;
  const SystematicEstimate& found = out.systematic.front();
  const std::string whose = gain.file.of_assembly ? "the assembly" : gain.file.name;
  tell(out, Status::doubtful,
       "The FRFs of " + whose + " fit the others with a common gain of " + digits(found.value, "%.4f") + " ± " +
           digits(found.std_error.value_or(0.0), "%.1g") + " (" + digits(std::abs(gain.score), "%.2g") +
           " standard deviations from 1): is a calibration off? Values and intervals are with this gain; where the other files are off in "
           "its place, the joint's matrices are " +
           digits(found.value, "%.4f") + " times what is given.");
}

}  // namespace jointid::ident
