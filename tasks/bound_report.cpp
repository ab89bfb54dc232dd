#include "tasks/bound_report.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "base/eigen.hpp"
#include "ident/check/check.hpp"
#include "ident/identify.hpp"
#include "ident/judgement/judge.hpp"
#include "ident/judgement/measured_rectangle.hpp"
#include "ident/likelihood/data/likelihood_plan.hpp"
#include "ident/likelihood/findings/bound_of.hpp"
#include "ident/likelihood/findings/identifiability.hpp"
#include "ident/likelihood/findings/weak_combinations.hpp"
#include "ident/likelihood/parts/likelihood_by_parts.hpp"
#include "ident/plan/expected_time.hpp"
#include "ident/plan/joint_guess.hpp"
#include "ident/scene/scene_failure.hpp"
#include "minimise/linear/covariance.hpp"

namespace jointid::tasks {
namespace {

constexpr std::size_t parts = 10;  ///< of the lines

std::string hertz(double value) {
  std::string text = std::to_string(value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string range_text(const ident::Plan& plan, std::size_t first, std::size_t last) {
  const std::string low = hertz(plan.lines[first].frequency_hz), high = hertz(plan.lines[last - 1].frequency_hz);
  return last - first == 1 ? low + " Hz" : low + " to " + high + " Hz";
}

/// Compares bounds with those of the data as planned.
class Baseline {
 public:
  Baseline(std::vector<double> bound, std::vector<double> scales) : bound_(std::move(bound)), scales_(std::move(scales)) {}

  double bound(std::size_t column) const { return bound_[column]; }
  double relative(std::size_t column) const { return relative(bound_, column); }

  BoundChange change(std::string what, const std::vector<double>& then) const {
    BoundChange out{.what = std::move(what), .factors = {}, .worst = 1.0, .mean = 1.0};
    double logarithms = 0.0, before = 0.0, after = 0.0;
    for (std::size_t column = 0; column < bound_.size(); ++column) {
      const bool both_infinite = std::isinf(bound_[column]) && std::isinf(then[column]);
      out.factors.push_back(both_infinite ? 1.0 : then[column] / bound_[column]);
      logarithms += std::log(out.factors.back());
      before = std::max(before, relative(bound_, column));
      after = std::max(after, relative(then, column));
    }
    out.worst = std::isinf(before) && std::isinf(after) ? 1.0 : after / before;
    out.mean = std::exp(logarithms / static_cast<double>(bound_.size()));
    return out;
  }

 private:
  double relative(const std::vector<double>& bound, std::size_t column) const {
    return bound[column] / (scales_[column] > 0.0 ? scales_[column] : 1.0);
  }

  std::vector<double> bound_, scales_;
};

/// The plan of a scene with method "likelihood" and a solver, on files that are open.
std::unique_ptr<ident::Plan> likelihood_plan(const ident::Plan& plan, ident::Scene scene, ident::Solver solver) {
  scene.identify.method = ident::Method::likelihood;
  scene.identify.automatic = false;
  scene.identify.solver = solver;
  // A start that is not used saves planning a linear estimate.
  if (scene.identify.start.empty()) scene.identify.start = scene.truth;
  scene.couple_first = {};  // done already
  return make_plan(scene, plan.substructures, plan.assembly);
}

std::vector<std::size_t> without(std::vector<std::size_t> from, std::size_t one) {
  std::erase(from, one);
  return from;
}

std::vector<std::size_t> with(std::vector<std::size_t> to, std::size_t one) {
  to.push_back(one);
  return to;
}

/// Seconds of one core of the reference machine for the information of one line: its FRFs are optimised and linearised.
double line_seconds(const ident::Plan& plan) {
  constexpr std::size_t usual = 4;
  ident::Cost cost = plan.cost;
  cost.iteration.expected = usual;
  return ident::expected_seconds(cost, 1) / static_cast<double>(std::max<std::size_t>(1, cost.lines));
}

/// How many lines are worked out in so many seconds of one core, for so many choices of the data.
std::size_t affordable_lines(const ident::Plan& plan, double seconds, std::size_t choices) {
  constexpr std::size_t least = 2 * parts;
  const double lines = seconds / (line_seconds(plan) * static_cast<double>(std::max<std::size_t>(1, choices)));
  return std::min(plan.lines.size(), std::max(least, static_cast<std::size_t>(std::min(lines, 1e9))));
}

/// The bound of each unknown, and what the data determine least.
void tell_unknowns(const ident::Plan& plan, const std::vector<double>& guess, const Eigen::MatrixXd& information,
                   const std::vector<ident::FileVariances>& origins, const Baseline& now, BoundReport& out) {
  std::vector<std::size_t> determined;
  std::vector<std::string> names;
  for (std::size_t column = 0; column < guess.size(); ++column) {
    const std::string name = plan.columns->name(column, plan.restriction);
    out.unknowns.push_back({name, plan.restriction.unknowns[plan.columns->unknown_of(column)].unit, guess[column], now.bound(column),
                            now.relative(column)});
    if (std::isinf(now.bound(column))) continue;
    determined.push_back(column);
    names.push_back(name);
  }
  out.weakest =
      ident::weak_combinations(relative_covariance(plan, minimise::covariance_of(information), guess, determined), names);
  std::set<std::string> told;
  for (const ident::FileVariances& file : origins) told.insert(phrase(file.origin));
  out.variances.assign(told.begin(), told.end());
}

/// Without each of the pieces of the lines whose information is given.
void leave_out_lines(const ident::Plan& plan, const Eigen::MatrixXd& information, const std::vector<Eigen::MatrixXd>& by_piece,
                     const Baseline& now, BoundReport& out) {
  const std::size_t lines = plan.lines.size(), count = by_piece.size();
  for (std::size_t piece = 0; piece < count && count > 1; ++piece) {
    const std::size_t first = piece * lines / count, last = (piece + 1) * lines / count;
    out.without_lines.push_back(now.change(range_text(plan, first, last), bound_of(plan, information - by_piece[piece])));
  }
}

/// Where the likelihood goes by parts: the bound of the same FRFs, each with a true value of its own.
BoundReport predict_by_parts(const ident::Plan& plan, const ident::Control& control) {
  BoundReport out;
  out.lines = out.lines_looked_at = plan.lines.size();
  const std::vector<double> guess = joint_guess(plan);
  try {
    const ident::WholeInformation found = *information_by_parts(plan, scaled(plan, guess), parts, control);
    Eigen::MatrixXd information = found.of_lines.front();
    for (std::size_t piece = 1; piece < found.of_lines.size(); ++piece) information += found.of_lines[piece];
    const Baseline now(bound_of(plan, information), relative_scales(plan, guess));
    tell_unknowns(plan, guess, information, found.origins, now, out);
    leave_out_lines(plan, information, found.of_lines, now, out);
  } catch (const Interrupted&) {
    out.interrupted = true;
  }
  return out;
}

/// Everything that is asked of the data of one plan.
class Predictor {
 public:
  /// `plan`: of the whole likelihood.
  Predictor(std::unique_ptr<ident::Plan> plan, const ident::Dofs& candidates, const ident::Control& control,
            const std::function<void(const BoundReport&)>& keep)
      : plan_(std::move(plan)),
        guess_(joint_guess(*plan_)),
        control_(control),
        keep_(keep),
        all_lines_(plan_->lines.size()) {
    const ident::Dofs& coordinates = likelihood_plan(*plan_)->observations->layout().coordinates;
    for (const frf::Dof& dof : candidates) absent_.push_back(find_candidate(plan_->scene, coordinates, dof));
    left_out_ = coordinates_of_assembly();
    changes_ = left_out_.size() + absent_.size() + (absent_.size() > 1 ? 1 : 0) + 2;
    plan_->lines = spread_lines(plan_->lines, affordable_lines(*plan_, most_seconds, 1));
  }

  BoundReport run() {
    BoundReport out;
    out.lines = all_lines_;
    try {
      tell_bound(out);
      keep(out);
      tell_changes(out);
    } catch (const Interrupted&) {
      out.interrupted = true;
    }
    return out;
  }

 private:
  static constexpr double most_seconds =
      60.0;  ///< of one core of the reference machine: for the bound, and twice that for all changes

  void keep(const BoundReport& so_far) const {
    if (keep_) keep_(so_far);
  }

  /// The information of all lines of which `some` is that of those that are looked at; priors are there once.
  Eigen::MatrixXd of_all(Eigen::MatrixXd some) const {
    if (plan_->lines.size() == all_lines_) return some;
    Eigen::VectorXd priors = Eigen::VectorXd::Zero(some.rows());
    for (const auto& [column, value, weight] : likelihood_plan(*plan_)->priors) priors[at(column)] += weight * weight;
    some.diagonal() -= priors;
    some *= static_cast<double>(all_lines_) / static_cast<double>(plan_->lines.size());
    some.diagonal() += priors;
    return some;
  }

  /// The bound by the lines of the plan, or by as many as are worked out in a minute, as if they were all.
  void tell_bound(BoundReport& out) {
    read_for_bound(*plan_, control_);
    information_ = of_all(information_without(absent_, &by_part_));
    const double share = static_cast<double>(all_lines_) / static_cast<double>(plan_->lines.size());
    for (Eigen::MatrixXd& part : by_part_) part *= share;
    scales_ = relative_scales(*plan_, guess_);
    const Baseline now(bound_of(*plan_, information_), scales_);
    out.lines_looked_at = plan_->lines.size();
    tell_unknowns(*plan_, guess_, information_, likelihood_plan(*plan_)->observations->origins(), now, out);
    leave_out_lines(*plan_, information_, by_part_, now, out);
  }

  /// What other data would do, by so many lines that it takes two minutes: factors do not change with the number of lines.
  void tell_changes(BoundReport& out) {
    const std::size_t lines = affordable_lines(*plan_, 2.0 * most_seconds, changes_);
    Eigen::MatrixXd information = information_;
    if (lines < plan_->lines.size()) {
      plan_->lines = spread_lines(plan_->lines, lines);
      read_for_bound(*plan_, control_);
      information = of_all(information_without(absent_));
    }
    out.lines_looked_at = plan_->lines.size();
    const Baseline now(bound_of(*plan_, information), scales_);
    leave_out_coordinates(now, out);
    add_candidates(now, out);
    add_lines(now, out);
    keep(out);
    add_equations(now, out);
  }

  Eigen::MatrixXd information_without(const std::vector<std::size_t>& coordinates,
                                      std::vector<Eigen::MatrixXd>* by_part = nullptr) {
    stop_if(control_.interrupted);
    likelihood_plan(*plan_)->observations->leave_out(coordinates);
    const ident::LinearisedLikelihood there = make_estimator(*plan_, control_, next_stage()).at(scaled(*plan_, guess_));
    Eigen::MatrixXd information = there.fit.information;
    const std::size_t lines = plan_->lines.size(), count = std::min(parts, lines);
    for (std::size_t part = 0; by_part != nullptr && part < count; ++part) {
      by_part->push_back(Eigen::MatrixXd::Zero(information.rows(), information.cols()));
      for (std::size_t i = part * lines / count; i < (part + 1) * lines / count; ++i)
        by_part->back() += there.information_of(i);
    }
    return information;
  }

  /// For progress: how many choices of the data were begun, of how many.
  std::shared_ptr<const std::string> next_stage() {
    ++choices_;
    return std::make_shared<const std::string>("predicting errors, data set " + std::to_string(choices_) + " of " +
                                               std::to_string(std::max(choices_, changes_ + 1)));
  }

  std::vector<double> bound_without(const std::vector<std::size_t>& coordinates) {
    return bound_of(*plan_, of_all(information_without(coordinates)));
  }

  /// Those whose absence is looked at.
  std::vector<std::size_t> coordinates_of_assembly() const {
    const ident::Dofs& coordinates = likelihood_plan(*plan_)->observations->layout().coordinates;
    std::vector<std::size_t> out;
    for (std::size_t c = 0; c < coordinates.size(); ++c) {
      const bool on_assembly =
          frf::has(plan_->assembly->responses(), coordinates[c]) || frf::has(plan_->assembly->references(), coordinates[c]);
      if (std::ranges::find(absent_, c) == absent_.end() && on_assembly) out.push_back(c);
    }
    return out;
  }

  void leave_out_coordinates(const Baseline& now, BoundReport& out) {
    const ident::LineLayout& layout = likelihood_plan(*plan_)->observations->layout();
    const ident::Dofs coordinates = layout.coordinates;
    const std::size_t others = layout.others;
    for (const std::size_t c : left_out_) {
      out.without_coordinate.push_back(
          now.change(coordinates[c].name() + (c < others ? "" : " on the assembly"), bound_without(with(absent_, c))));
      keep(out);
    }
  }

  void add_candidates(const Baseline& now, BoundReport& out) {
    const ident::Dofs coordinates = likelihood_plan(*plan_)->observations->layout().coordinates;
    for (const std::size_t c : absent_) {
      out.with_more.push_back(now.change(coordinates[c].name(), bound_without(without(absent_, c))));
      keep(out);
    }
    if (absent_.size() > 1) out.with_more.push_back(now.change("all candidates", bound_without({})));
  }

  /// The bound of another scene on the same files, without the candidates; of its lines the same part is looked at.
  std::vector<double> bound_of_other(std::unique_ptr<ident::Plan> other) {
    std::vector<std::size_t> absent;
    const ident::Dofs& coordinates = likelihood_plan(*other)->observations->layout().coordinates;
    const ident::Dofs& own = likelihood_plan(*plan_)->observations->layout().coordinates;
    for (const std::size_t c : absent_) absent.push_back(frf::find_coordinate(coordinates, own[c]));
    const std::size_t all = other->lines.size();
    other->lines = spread_lines(other->lines, std::max<std::size_t>(1, all * plan_->lines.size() / all_lines_));
    read_for_bound(*other, control_);
    likelihood_plan(*other)->observations->leave_out(absent);
    const double share = static_cast<double>(all) / static_cast<double>(other->lines.size());
    return bound_of(*other, share * make_estimator(*other, control_, next_stage()).at(scaled(*other, guess_)).fit.information);
  }

  void add_lines(const Baseline& now, BoundReport& out) {
    ident::Scene wide = plan_->scene;
    wide.frequency = {};
    auto other = likelihood_plan(*plan_, wide, ident::Solver::gauss_helmert);
    if (other->lines.size() == all_lines_) return;
    const std::string what =
        "all " + std::to_string(other->lines.size()) + " lines of the files, " + range_text(*other, 0, other->lines.size());
    out.with_more.push_back(now.change(what, bound_of_other(std::move(other))));
  }

  void add_equations(const Baseline& now, BoundReport& out) {
    ident::Scene all = plan_->scene;
    all.identify.equations.clear();
    auto other = likelihood_plan(*plan_, all, ident::Solver::gauss_helmert);
    std::string added;
    for (const ident::Equation equation : other->equations) {
      if (std::ranges::find(plan_->equations, equation) == plan_->equations.end()) added += " " + name(equation);
    }
    if (!added.empty()) out.with_more.push_back(now.change("equations" + added, bound_of_other(std::move(other))));
  }

  std::unique_ptr<ident::Plan> plan_;
  std::vector<double> guess_, scales_;
  const ident::Control& control_;
  const std::function<void(const BoundReport&)>& keep_;
  std::size_t all_lines_;
  std::vector<std::size_t> absent_;    ///< candidates
  std::vector<std::size_t> left_out_;  ///< one after the other
  std::size_t choices_ = 0, changes_ = 0;
  Eigen::MatrixXd information_;
  std::vector<Eigen::MatrixXd> by_part_;
};

}  // namespace

BoundReport predict_bound(const ident::Plan& plan, const ident::Dofs& candidates, const ident::Control& control,
                          const std::function<void(const BoundReport&)>& keep) {
  const bool by_parts = plan.scene.identify.solver == ident::Solver::by_parts;
  auto likelihood = likelihood_plan(plan, plan.scene, by_parts ? ident::Solver::by_parts : ident::Solver::automatic);
  if (likelihood->solver != ident::Solver::by_parts) return Predictor(std::move(likelihood), candidates, control, keep).run();
  if (!candidates.empty()) {
    fail(plan.scene, "--candidates", "the bound of the likelihood by parts does not compare coordinates",
         "leave --candidates out, or set solver = \"gauss-helmert\" in [identify]");
  }
  return predict_by_parts(*likelihood, control);
}

std::string suspect_note(const ident::Plan& plan, const ident::Control& control) {
  const ident::CheckResult found = ident::quick_check(plan, control);
  return found.verdict == ident::Verdict::clean ? "" : ident::phrase(found.suspects.front());
}

}  // namespace jointid::tasks
