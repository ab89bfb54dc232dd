#include "tasks/bound_report.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "ident/identify.hpp"
#include "ident/likelihood/data/likelihood_plan.hpp"
#include "ident/likelihood/findings/bound_of.hpp"
#include "ident/likelihood/findings/identifiability.hpp"
#include "ident/likelihood/findings/weak_combinations.hpp"
#include "ident/plan/joint_guess.hpp"
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

/// The plan of a scene with method "likelihood", on files that are open.
std::unique_ptr<ident::Plan> likelihood_plan(const ident::Plan& plan, ident::Scene scene) {
  scene.identify.method = ident::Method::likelihood;
  scene.identify.automatic = false;
  scene.identify.solver = "auto";
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

/// Everything that is asked of the data of one plan.
class Predictor {
 public:
  Predictor(const ident::Plan& plan, const ident::Dofs& candidates, const ident::Control& control)
      : plan_(likelihood_plan(plan, plan.scene)), guess_(joint_guess(*plan_)), control_(control) {
    const ident::Dofs& coordinates = likelihood_plan(*plan_)->observations->layout().coordinates;
    for (const frf::Dof& dof : candidates) absent_.push_back(find_candidate(plan.scene, coordinates, dof));
    read_observations(*plan_, control);
  }

  BoundReport run() {
    information_ = information_without(absent_, &by_line_);
    const std::vector<double> scales = relative_scales(*plan_, guess_);
    const Baseline now(bound_of(*plan_, information_), scales);
    BoundReport out;
    tell_unknowns(now, out);
    try {
      leave_out_lines(now, out);
      leave_out_coordinates(now, out);
      add_candidates(now, out);
      add_lines(now, out);
      add_equations(now, out);
    } catch (const Interrupted&) {
      out.interrupted = true;
    }
    return out;
  }

 private:
  Eigen::MatrixXd information_without(const std::vector<std::size_t>& coordinates,
                                      std::vector<Eigen::MatrixXd>* by_line = nullptr) {
    stop_if(control_.interrupted);
    likelihood_plan(*plan_)->observations->leave_out(coordinates);
    ident::LikelihoodEstimator estimator = make_estimator(*plan_, control_, next_stage());
    Eigen::MatrixXd information = estimator.information_at(scaled(*plan_, guess_));
    for (std::size_t i = 0; by_line != nullptr && i < plan_->lines.size(); ++i) by_line->push_back(estimator.information_of(i));
    return information;
  }

  /// For progress: how many choices of the data were begun.
  std::shared_ptr<const std::string> next_stage() {
    ++choices_;
    return std::make_shared<const std::string>("predicting errors, data set " + std::to_string(choices_));
  }

  std::vector<double> bound_without(const std::vector<std::size_t>& coordinates) {
    return bound_of(*plan_, information_without(coordinates));
  }

  void tell_unknowns(const Baseline& now, BoundReport& out) const {
    std::vector<std::size_t> determined;
    std::vector<std::string> names;
    for (std::size_t column = 0; column < guess_.size(); ++column) {
      const std::string name = plan_->columns->name(column, plan_->restriction);
      out.unknowns.push_back({name, plan_->restriction.unknowns[plan_->columns->unknown_of(column)].unit, guess_[column],
                              now.bound(column), now.relative(column)});
      if (std::isinf(now.bound(column))) continue;
      determined.push_back(column);
      names.push_back(name);
    }
    out.weakest =
        ident::weak_combinations(relative_covariance(*plan_, minimise::covariance_of(information_), guess_, determined), names);
    std::set<std::string> told;
    for (const ident::FileVariances& file : likelihood_plan(*plan_)->observations->origins()) told.insert(phrase(file.origin));
    out.variances.assign(told.begin(), told.end());
  }

  void leave_out_lines(const Baseline& now, BoundReport& out) const {
    const std::size_t lines = plan_->lines.size(), count = std::min(parts, lines);
    for (std::size_t part = 0; part < count && count > 1; ++part) {
      const std::size_t first = part * lines / count, last = (part + 1) * lines / count;
      Eigen::MatrixXd rest = information_;
      for (std::size_t i = first; i < last; ++i) rest -= by_line_[i];
      out.without_lines.push_back(now.change(range_text(*plan_, first, last), bound_of(*plan_, rest)));
    }
  }

  void leave_out_coordinates(const Baseline& now, BoundReport& out) {
    const ident::LineLayout& layout = likelihood_plan(*plan_)->observations->layout();
    const ident::Dofs coordinates = layout.coordinates;
    const std::size_t others = layout.others;
    for (std::size_t c = 0; c < coordinates.size(); ++c) {
      const bool on_assembly =
          frf::has(plan_->assembly->responses(), coordinates[c]) || frf::has(plan_->assembly->references(), coordinates[c]);
      if (std::ranges::find(absent_, c) != absent_.end() || !on_assembly) continue;
      out.without_coordinate.push_back(
          now.change(coordinates[c].name() + (c < others ? "" : " on the assembly"), bound_without(with(absent_, c))));
    }
  }

  void add_candidates(const Baseline& now, BoundReport& out) {
    const ident::Dofs coordinates = likelihood_plan(*plan_)->observations->layout().coordinates;
    for (const std::size_t c : absent_) {
      out.with_more.push_back(now.change(coordinates[c].name(), bound_without(without(absent_, c))));
    }
    if (absent_.size() > 1) out.with_more.push_back(now.change("all candidates", bound_without({})));
  }

  /// The bound of another scene on the same files, without the candidates.
  std::vector<double> bound_of_other(ident::Plan& other) {
    std::vector<std::size_t> absent;
    const ident::Dofs& coordinates = likelihood_plan(other)->observations->layout().coordinates;
    const ident::Dofs& own = likelihood_plan(*plan_)->observations->layout().coordinates;
    for (const std::size_t c : absent_) absent.push_back(frf::find_coordinate(coordinates, own[c]));
    read_observations(other, control_);
    likelihood_plan(other)->observations->leave_out(absent);
    return bound_of(other, make_estimator(other, control_, next_stage()).information_at(scaled(other, guess_)));
  }

  void add_lines(const Baseline& now, BoundReport& out) {
    ident::Scene wide = plan_->scene;
    wide.frequency = {};
    const auto other = likelihood_plan(*plan_, wide);
    if (other->lines.size() == plan_->lines.size()) return;
    out.with_more.push_back(now.change(
        "all " + std::to_string(other->lines.size()) + " lines of the files, " + range_text(*other, 0, other->lines.size()),
        bound_of_other(*other)));
  }

  void add_equations(const Baseline& now, BoundReport& out) {
    ident::Scene all = plan_->scene;
    all.identify.equations.clear();
    const auto other = likelihood_plan(*plan_, all);
    std::string added;
    for (const ident::Equation equation : other->equations) {
      if (std::ranges::find(plan_->equations, equation) == plan_->equations.end()) added += " " + name(equation);
    }
    if (!added.empty()) out.with_more.push_back(now.change("equations" + added, bound_of_other(*other)));
  }

  std::unique_ptr<ident::Plan> plan_;
  std::vector<double> guess_;
  const ident::Control& control_;
  std::vector<std::size_t> absent_;  ///< candidates
  std::size_t choices_ = 0;
  Eigen::MatrixXd information_;
  std::vector<Eigen::MatrixXd> by_line_;
};

}  // namespace

BoundReport predict_bound(const ident::Plan& plan, const ident::Dofs& candidates, const ident::Control& control) {
  return Predictor(plan, candidates, control).run();
}

}  // namespace jointid::tasks
