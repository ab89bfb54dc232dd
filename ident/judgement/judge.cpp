#include "ident/judgement/judge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/eigen.hpp"
#include "base/text.hpp"
#include "ident/judgement/constrained_scatter.hpp"
#include "ident/judgement/dominant_line.hpp"
#include "ident/judgement/h1_bias.hpp"
#include "ident/judgement/judge_constraints.hpp"
#include "ident/judgement/line_jackknife.hpp"
#include "ident/judgement/passivity.hpp"
#include "ident/judgement/predicted_fit.hpp"
#include "ident/judgement/relative_motion.hpp"
#include "ident/judgement/tell_errors.hpp"
#include "ident/judgement/whitened_fit.hpp"
#include "ident/scene/method_traits.hpp"
#include "ident/scene/variance_origin.hpp"
#include "modalfit/poles/selection.hpp"

namespace jointid::ident {
namespace {

constexpr double poor_misfit = 4.0, doubtful_misfit = 1.5;     // squares of errors over expected ones
constexpr double doubtful_unsure = 3.0;                        // the same where noise or bias are known less well
constexpr double poor_channel = 16.0, doubtful_channel = 4.0;  // of a row or column
constexpr double no_joint_misfit = 1.3;
constexpr double no_joint_effect = 0.8;  // JointVisibility::effect; 0.7 is expected of no joint
constexpr std::size_t jackknife_lines = 256;

constexpr const char* remedy =
    " `jointid check SCENE` looks for the cause: a sign, a label, a unit, another quantity, a file of another state.";

/// The DOF whose equations fit worst among rows and columns.
struct WorstChannel {
  double misfit = 0.0;
  std::string dof;
  bool is_row = false;
};

WorstChannel worst_channel(const NoisyLines& data, const WhitenedFit& fit) {
  WorstChannel worst;
  const auto look = [&](const std::vector<double>& misfits, const Dofs& dofs, bool is_row) {
    for (std::size_t i = 0; i < misfits.size(); ++i) {
      if (misfits[i] > worst.misfit) worst = {misfits[i], dofs[i].name(), is_row};
    }
  };
  look(fit.row_misfit, data.rows, true);
  look(fit.column_misfit, data.columns, false);
  return worst;
}

void tell_misfit(const NoisyLines& data, const WhitenedFit& fit, Solution& out) {
  const WorstChannel worst = worst_channel(data, fit);
  const bool poor = fit.misfit > poor_misfit || worst.misfit > poor_channel;
  const double doubtful = data.from_knowledge && fit.corrected ? doubtful_misfit : doubtful_unsure;
  if (!poor && !(fit.misfit > doubtful || worst.misfit > doubtful_channel)) return;
  tell(out, poor ? Status::poor_fit : Status::doubtful,
       "No joint of this scene explains the FRFs: its residuals are " + digits(std::sqrt(fit.misfit)) +
           " times their expected noise, and " + digits(std::sqrt(worst.misfit)) + " times with the " +
           (worst.is_row ? "response " : "reference ") + worst.dof + "." + remedy);
}

void tell_no_joint(Solution& out) {
  tell(out, Status::doubtful,
       "The assembly's FRFs are those of the parts without a joint, within their noise: is it the file of the assembly, and was "
       "the joint closed?");
}

void tell_active(const std::vector<ActiveMotion>& found, Solution& out) {
  if (found.empty()) return;
  tell(out, Status::poor_fit,
       "The joint is not passive: " + text(found.front()) + ". Are FRFs conjugated, delayed, or of the wrong sign?" + remedy);
}

/// Error estimates from the scatter and, where a fit without bias is there, the difference to that; and from what the coherences
/// leave open of H1, which moves all unknowns in proportion.
void fill_errors(const Plan& plan, const std::vector<double>& theta, const Eigen::VectorXd& scatter,
                 const std::optional<FreeEstimate>& fit, Solution& out) {
  const double too_low = h1_bias(plan);
  for (std::size_t column = 0; column < out.unknowns.size(); ++column) {
    const auto c = at(column);
    Estimate& estimate = out.unknowns[column];
    const double unit = std::abs(plan.unscale(column));
    double square = scatter[c] + std::pow(too_low * theta[column], 2);
    if (fit) {
      const double bias = theta[column] - fit->theta[column];
      square += std::max(0.0, bias * bias - fit->covariance(c, c));
      estimate.bias = bias * plan.unscale(column);
    }
    estimate.error_estimate = std::sqrt(square) * unit;
  }
}

/// Errors of the elements of the joint matrices: those of the unknowns in them, added as squares.
void fill_matrix_errors(const Plan& plan, Solution& out) {
  for (BandMatrices& band : out.bands) {
    const double inside = band.band_hz ? 0.5 * ((*band.band_hz)[0] + (*band.band_hz)[1]) : 0.0;
    const std::vector<std::size_t> columns = plan.columns->at(inside);
    const std::size_t n = plan.restriction.dofs.size();
    for (const restrictions::MatrixTerms& matrix : plan.restriction.matrices) {
      Matrix& errors = band.errors[matrix.kind];
      errors.assign(n, std::vector<double>(n, 0.0));
      for (const auto& [row, column, unknown, coefficient] : matrix.terms) {
        errors[row][column] = std::hypot(errors[row][column], coefficient * *out.unknowns[columns[unknown]].error_estimate);
      }
    }
  }
}

/// Motions that give energy away by the estimate without bias, and by the estimate itself with its bias as a part of its error.
void judge_errors(const Plan& plan, const std::vector<double>& theta, const Eigen::MatrixXd& scatter,
                  const std::optional<FreeEstimate>& fit, Solution& out) {
  fill_errors(plan, theta, scatter.diagonal(), fit, out);
  fill_matrix_errors(plan, out);
  Eigen::MatrixXd covariance = scatter;
  if (fit) {
    const Eigen::VectorXd bias = vector_of(theta) - vector_of(fit->theta);
    covariance += bias * bias.transpose();
    if (!active_motions(plan, theta, covariance, 5.0).empty())
      tell_active(active_motions(plan, fit->theta, fit->covariance, 6.0), out);
  }
  tell_errors(plan, theta, covariance, out);
}

/// Rows by parts: the scatter of groups of lines, whose covariance of all pairs of unknowns is not formed.
void judge_parts(const Plan& plan, const std::vector<double>& theta, const Control& control, Solution& out) {
  if (control.detail == Detail::full) tell_relative_motions(plan, out);
  const std::optional<Eigen::VectorXd> scatter = line_scatter(plan, jackknife_lines, control);
  if (!scatter) return;
  fill_errors(plan, theta, *scatter, std::nullopt, out);
  fill_matrix_errors(plan, out);
  tell_useless_errors(plan, out);
  const auto is_noisy = [](const Estimate& each) { return each.error_estimate && *each.error_estimate > 1e-6 * std::abs(each.value); };
  if (std::ranges::any_of(out.unknowns, is_noisy)) {
    tell(out, Status::doubtful,
         "The rows of single substructures are not compared with the assembly: errors are the scatter of groups of lines alone, and what "
         "noise biases is not in them (docs/many-joints.md). Excite the assembly at its joints, or take method \"likelihood\".");
  }
}

/// Errors of an estimate under constraints: `fit`, the second estimate without them, is moved to the nearest joint that meets them.
void judge_constrained_errors(const Plan& plan, const std::vector<double>& theta, const std::optional<FreeEstimate>& fit,
                              const std::optional<ConstrainedScatter>& scatter, Solution& out) {
  if (out.status == Status::not_converged || !scatter) return;
  if (plan.why_by_parts) {
    fill_errors(plan, theta, scatter->variances(), std::nullopt, out);
    fill_matrix_errors(plan, out);
    return tell_useless_errors(plan, out);
  }
  std::optional<FreeEstimate> second;
  if (fit) second = under_constraints(plan, *fit, *scatter);
  judge_errors(plan, theta, scatter->covariance(), second, out);
}

/// By the equations of Method One.
std::optional<FreeEstimate> judge_equations(const Plan& plan, const std::vector<double>& theta, Solution& out) {
  const std::optional<NoisyLines> data = lines_to_judge(plan);
  std::optional<WhitenedFit> fit = data ? whitened_fit(plan, *data, theta) : std::nullopt;
  if (!fit) return std::nullopt;
  out.fit.misfit = fit->misfit;
  tell_misfit(*data, *fit, out);
  if (fit->free_misfit < no_joint_misfit) tell_no_joint(out);
  if (!fit->corrected) return std::nullopt;
  return FreeEstimate{std::move(fit->theta), std::move(fit->covariance), std::move(fit->jackknife), fit->lines, data->from_knowledge};
}

/// By what parts and joint predict of H_nn.
std::optional<FreeEstimate> judge_prediction(const Plan& plan, const std::vector<double>& theta, Solution& out) {
  const std::optional<PredictedLines> data = predicted_lines_to_judge(plan);
  std::optional<PredictedFit> fit = data ? predicted_fit(plan, *data, theta) : std::nullopt;
  if (!fit) return std::nullopt;
  out.fit.misfit = fit->misfit;
  const bool poor = fit->misfit > poor_misfit;
  if (poor || fit->misfit > (data->from_knowledge ? doubtful_misfit : doubtful_unsure)) {
    tell(out, poor ? Status::poor_fit : Status::doubtful,
         "This joint does not explain H_nn: the prediction from substructures and joint is off by " +
             digits(std::sqrt(fit->misfit)) +
             " times its expected noise. Another joint may fit: method \"likelihood\" looks for it; give a start near "
             "the joint, "
             "or measure the assembly at the joint.");
    return std::nullopt;
  }
  return FreeEstimate{std::move(fit->theta), fit->covariance, fit->covariance, data->lines.size(), data->from_knowledge};
}

/// `free`: the unknowns of the method's own equations without the constraints; empty: not known.
void judge_constrained(const Plan& plan, const std::optional<FreeEstimate>& fit, const std::vector<double>& free,
                       const std::vector<double>& theta, Solution& out) {
  if (out.status == Status::not_converged) return;  // what holds there is not what the scene asks for
  if (fit) return judge_constraints(plan, *fit, free, theta, out);
  judge_constraints_by_residuals(plan, free, theta, out);
}

void tell_dominant(const Plan& plan, const DominantLine& found, Solution& out) {
  const auto value = [&](double scaled) { return digits(scaled * plan.unscale(found.column), "%.3g"); };
  const std::string hz = digits(found.frequency_hz, "%.6g");
  const std::string frf = found.frf.empty() ? ""
                                            : " FRF " + found.frf + " is " + digits(found.over_neighbours, "%.2g") +
                                                  " times off its neighbours there.";
  tell(out, Status::doubtful,
       "One line decides against all others: with " + hz + " Hz " + out.unknowns[found.column].name + " is " + value(found.with) +
           ", without it " + value(found.without) + " " + out.unknowns[found.column].unit + "." + frf +
           " Leave the line out (exclude in [frequency]) or put the file right.");
}

/// Errors that would not hold, and what was said from them.
void withhold_errors(Solution& out) {
  for (Estimate& estimate : out.unknowns) {
    estimate.std_error.reset();
    estimate.ci95.reset();
  }
  out.intervals = IntervalKind::none;
  if (!out.identifiability) return;
  out.identifiability->weakest.clear();
  out.identifiability->largest_relative_error = std::numeric_limits<double>::quiet_NaN();
  std::erase_if(out.identifiability->findings,
                [](const Finding& finding) { return finding.kind != FindingKind::misfit && finding.kind != FindingKind::gain; });
}

}  // namespace

std::string phrase(const Suspect& suspect) { return "Most suspect: " + title(suspect) + ". " + suspect.evidence + "."; }

void tell_check(const CheckResult& found, Solution& out) {
  if (found.verdict == Verdict::clean || found.suspects.empty()) return;
  tell(out, found.verdict == Verdict::wrong ? Status::poor_fit : Status::doubtful, phrase(found.suspects.front()));
  if (out.status == Status::poor_fit) withhold_errors(out);
}

void judge_linear(const Plan& plan, const minimise::LinearSolution& linear, const std::vector<double>& free, const Control& control,
                  Solution& out) {
  if (linear.rank != plan.columns->size()) return;
  if (plan.why_by_parts && !plan.admissible) return judge_parts(plan, linear.y, control, out);
  if (plan.why_by_parts) {
    judge_constraints_by_residuals(plan, free, linear.y, out);
    return judge_constrained_errors(plan, linear.y, std::nullopt, constrained_scatter(plan, jackknife_lines, control), out);
  }
  const bool from_prediction = !traits(plan.scene.identify.method).joint_on_assembly;
  const auto fit = from_prediction ? judge_prediction(plan, linear.y, out) : judge_equations(plan, linear.y, out);
  if (plan.admissible) {
    judge_constrained(plan, fit, free, linear.y, out);
    return judge_constrained_errors(plan, linear.y, fit, constrained_scatter(plan, jackknife_lines, control), out);
  }
  std::optional<LineJackknife> jackknife = line_jackknife(plan, jackknife_lines, control);
  if (!jackknife) return;
  judge_errors(plan, linear.y, jackknife->covariance, fit, out);
  if (const auto line = dominant_line(plan, *jackknife, linear.y, control)) tell_dominant(plan, *line, out);
}

void judge_predicted_constraints(const Plan& plan, const std::vector<double>& theta, const std::optional<ConstrainedScatter>& scatter,
                                 Solution& out) {
  const std::optional<FreeEstimate> fit = judge_prediction(plan, theta, out);
  judge_constrained(plan, fit, {}, theta, out);
  judge_constrained_errors(plan, theta, fit, scatter, out);
}

void judge_predicted(const Plan& plan, const std::vector<double>& theta, const Eigen::MatrixXd& scatter, Solution& out) {
  judge_errors(plan, theta, scatter, judge_prediction(plan, theta, out), out);
}

void judge_unknown_noise(Solution& out) {
  constexpr double far = 10.0;  // dB: noise alone leaves up to 9.3 in 30 seeds of the built-in problem G1
  if (out.fit.misfit || !out.fit.asm_frf_error || !(*out.fit.asm_frf_error > far) || !is_usable(out.status)) return;
  tell(out, Status::doubtful,
       "The FRFs of the assembly by this joint are off by " + digits(*out.fit.asm_frf_error, "%.3g") +
           " dB (rms), and nothing states the noise: it may be the joint's form, or a faulty FRF. State the noise ([noise], or "
           "variances in the files): then the misfit shows which." +
           remedy);
}

namespace {

/// Whether some variances are estimates themselves.
bool estimated_variances(const Solution& out) {
  return std::ranges::any_of(out.variances, [](const VarianceSource& file) {
    return file.origin == phrase(VarianceOrigin::coherence) || file.origin == phrase(VarianceOrigin::repeats) ||
           file.origin == phrase(VarianceOrigin::scatter);
  });
}

/// χ² over degrees of freedom line by line.
struct LineRatios {
  /// Of the lines that are not outlying, where those are a third at most: they count for little in the estimate.
  double mean = 0.0;
  std::size_t outlying = 0, lines = 0;

  bool are_many_outlying() const { return 5 * outlying > lines; }
};

LineRatios ratios_of(const ChiSquare& chi_square) {
  constexpr double gross = 3.2;  // counts for less than half: robust_weight()
  std::vector<double> lines = chi_square.by_line;
  std::erase_if(lines, [](double ratio) { return std::isnan(ratio); });
  LineRatios out;
  if (lines.empty()) return out;
  out.lines = lines.size();
  out.outlying = static_cast<std::size_t>(std::ranges::count_if(lines, [](double ratio) { return ratio > gross; }));
  if (3 * out.outlying <= out.lines) std::erase_if(lines, [](double ratio) { return ratio > gross; });
  out.mean = std::accumulate(lines.begin(), lines.end(), 0.0) / static_cast<double>(lines.size());
  return out;
}

/// Errors that several FRFs share are not in the law of χ².
bool shares_errors(const Plan& plan) {
  return !plan.regenerated.empty() || (!plan.scene.couple_first.pairs.empty() && !plan.method->carries_shared_errors());
}

constexpr double poor_with_misfit = 4.0, hopeless_with_misfit = 64.0;  // χ² over f where errors include the misfit

bool is_poor(const LikelihoodJudgement& fit, double ratio, bool estimated) {
  return fit.hopeless || ratio > (estimated || fit.includes_misfit ? poor_with_misfit : 2.0);
}

/// What errors and intervals are worth.
std::string worth_of_errors(const LikelihoodJudgement& fit, double ratio, bool poor) {
  if (fit.includes_misfit && ratio <= hopeless_with_misfit) {
    return " Standard errors and intervals include the model error, estimated by leaving out blocks of lines and sensors. An error that "
           "looks like another joint, such as a misplaced sensor at the joint, can move the joint by more.";
  }
  return poor ? " Standard errors and intervals are not given, because they would be wrong."
              : " Standard errors and intervals are too small.";
}

void tell_chi_square(const Plan& plan, const LikelihoodJudgement& fit, Solution& out) {
  const ChiSquare& chi_square = *out.fit.chi_square;
  const LineRatios lines = ratios_of(chi_square);
  const double freedom = std::max(1.0, chi_square.degrees_of_freedom),
               ratio = lines.are_many_outlying() ? lines.mean : std::max(lines.mean, fit.ratio);
  const bool shares = shares_errors(plan), poor = is_poor(fit, ratio, estimated_variances(out) || shares);
  if (!poor && !(ratio > (shares ? std::max(fit.likely, 2.0) : fit.likely))) {
    if (!lines.are_many_outlying()) return;
    tell(out, Status::doubtful,
         std::to_string(lines.outlying) + " of " + std::to_string(lines.lines) +
             " lines are outliers, far beyond their standard errors. They have little weight; the others fit." + remedy);
    return;
  }
  tell(out, poor ? Status::poor_fit : Status::doubtful,
       std::string(fit.hopeless ? "Stopped early: n" : "N") +
           (fit.several_minima ? "one of the joints that starts led to explains" : "o joint of this scene explains") +
           " the FRFs: they are off by " + digits(std::sqrt(ratio), "%.3g") +
           " times their standard errors (χ² over degrees of freedom " + digits(ratio, "%.3g") + ", " +
           digits((ratio - 1.0) / std::sqrt(2.0 / freedom), "%.2g") + " standard deviations above 1)." +
           worth_of_errors(fit, ratio, poor) +
           (fit.several_minima ? " Give [identify] a start near the joint, or starts = 40; or measure the assembly at the joint."
                               : "") +
           remedy);
}

bool keeps_errors(const LikelihoodJudgement& fit, const Solution& out) {
  return fit.includes_misfit && ratios_of(*out.fit.chi_square).mean <= hopeless_with_misfit;
}

}  // namespace

void judge_likelihood(const Plan& plan, const LikelihoodJudgement& fit, const Control& control, Solution& out) {
  const Status before = out.status;
  tell_chi_square(plan, fit, out);
  const bool keeps = keeps_errors(fit, out);
  if (out.status == Status::doubtful && control.detail == Detail::estimates) {  // studies judge by their many trials
    out.status = before;
    out.message.clear();
  }
  if (control.detail == Detail::full && out.status != Status::rank_deficient && !plan.admissible) {
    const std::vector<ActiveMotion> active = active_motions(plan, fit.theta, fit.covariance, 5.0);
    tell_active(active, out);
    if (!active.empty()) withhold_errors(out);
  }
  if (control.detail == Detail::full && is_usable(out.status)) tell_errors(plan, fit.theta, fit.covariance, out);
  if (control.detail == Detail::full && plan.admissible) judge_constraints_by_variances(plan, fit.ratio, out);
  if (out.identifiability && out.identifiability->joint.effect && *out.identifiability->joint.effect < no_joint_effect)
    tell_no_joint(out);
  if (out.status == Status::poor_fit && !keeps) withhold_errors(out);
}

}  // namespace jointid::ident
