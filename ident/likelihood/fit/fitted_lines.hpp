#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "ident/likelihood/data/likelihood_data.hpp"
#include "ident/likelihood/model/fitted_line.hpp"

namespace jointid::ident {

/// All lines of a likelihood, worked on in parallel, and Σ L over them: L is χ² of a line that fits, and bounded for one with gross
/// errors (robust_loss()). The unknowns θ, the joint's and after them those of systematic errors, are the caller's. Sums go from line to
/// line in order: they do not depend on the number of threads. Of lines that other processes have (LikelihoodData::shares()) χ² and
/// weights are known here and nothing else.
class FittedLines {
 public:
  FittedLines(LikelihoodData& data, const restrictions::Restriction& restriction, const UnknownColumns& columns, double omega0,
              std::size_t threads);

  /// Every so many of those in use alone, as if the others said nothing; no line is anywhere yet.
  FittedLines spread(std::size_t every) const { return {*this, every}; }
  std::size_t used() const;
  /// Whether all of them are this process's.
  bool are_own() const { return own_.size() == lines_.size(); }

  /// Called before each line of every pass with how many of how many are begun, by any thread; may throw to stop.
  void set_watch(std::function<void(std::size_t begun, std::size_t lines)> watch) { watch_ = std::move(watch); }

  const LineLayout& layout() const { return data_->layout(); }
  const FittedLine& operator[](std::size_t line) const { return lines_[line]; }
  ComplexMatrix impedance(std::size_t line, const std::vector<double>& theta) const { return lines_[line].joint.at(theta); }

  /// Where all lines stand, to come back to.
  const std::vector<FittedLine>& snapshot() const { return lines_; }
  void restore(std::vector<FittedLine> snapshot) { lines_ = std::move(snapshot); }

  /// Until look_at_all() only lines spread over those in use are worked on, so many or a few more; false: these are all.
  bool look_at_some(std::size_t count);
  void look_at_all() { passed_over_.clear(); }

  /// first_state() of every line.
  void begin(const std::vector<double>& theta);

  /// χ² of every line as linearised where it stands for a joint, without what it tells of that.
  void linearise_frfs(const std::vector<double>& theta);

  /// linearised() every line where it stands.
  void linearise(const std::vector<double>& theta);

  /// Takes χ² of the linearised lines for theirs.
  void take_linearised_costs();

  /// Along the linearised constraint by a step of the joint from `theta` to `next` and what it makes of the FRFs.
  void advance(const std::vector<double>& theta, const std::vector<double>& next, const Eigen::VectorXd& step);

  /// The FRFs of every line optimised for a joint.
  void relax(const std::vector<double>& theta);

  /// Puts every line, which has been linearised, on the constraint; its FRFs are optimised where χ² is far from what was promised.
  void arrive(const std::vector<double>& theta);

  /// Puts every line on the constraint and linearises it there; its FRFs are optimised before where the linearised line promises that
  /// this would help much, or to the end.
  void settle(const std::vector<double>& theta, Relaxation until);

  /// The same of lines that stand where they were measured, for a joint that is nearly right (ident::settle_measured()).
  void settle_measured(const std::vector<double>& theta);

  /// Gradients of the lines where they stand, with information and U⁻¹W of the place where they were linearised last (take_gradient());
  /// lines that did not follow the last step as predicted are linearised again, and all that have not plain errors.
  void take_gradients(const std::vector<double>& theta);

  /// Σ weight · gradient of the lines, their FRFs optimised, at joints nearby, a column each: `theta` plus the offsets, from `before`,
  /// where they are linearised. The lines stay where they are. `known`: of lines what the other function returned there.
  Eigen::MatrixXd gradients_nearby(const std::vector<FittedLine>& before, const std::vector<double>& theta,
                                   const std::vector<Eigen::VectorXd>& offsets, std::vector<Eigen::MatrixXd> known = {});

  /// The same of one line alone from where it stands, without its weight, by a model that has its factors there: a row for each of its
  /// columns. Empty where its errors are not plain, or it tells nothing.
  Eigen::MatrixXd gradients_nearby(std::size_t line, const std::vector<double>& theta, const std::vector<Eigen::VectorXd>& offsets,
                                   LineModel& model) const;

  /// From `before`, where lines are linearised, with the FRFs as they answer to a step of the joint to `theta`.
  void answer(const std::vector<FittedLine>& before, const std::vector<double>& theta, const Eigen::VectorXd& step);

  /// From `before`, where lines are linearised, to a joint that is a step away: the FRFs of a line take their part of the common
  /// Gauss–Newton step. Where χ² is not what the linearised line predicts, or to the end of all, they are optimised for the joint.
  void follow(const std::vector<FittedLine>& before, const std::vector<double>& theta, const Eigen::VectorXd& step,
              Relaxation until);

  /// Robust weights by χ², or all 1.
  void weigh_robustly();
  void weigh_alike();

  /// Sets χ² over its expectation that counts as fitting: line_tolerance().
  void choose_tolerance();
  double tolerance() const { return tolerance_; }

  /// Variances by law are taken at the estimated values.
  void take_variances_here(const std::vector<double>& theta);
  void take_variances_as_measured();
  bool variances_by_law() const { return data_->variances_by_law(); }

  /// Σ L.
  double loss() const;

  /// What Σ χ² is expected to be, the joint's unknowns not yet taken off.
  double expected() const;

  /// Adds Σ weight · information and gradient of the lines as linearised.
  void add_to(Eigen::MatrixXd& information, Eigen::VectorXd& gradient) const;

  /// Adds weight · information of one line.
  void add_information(std::size_t line, double weight, Eigen::MatrixXd& information) const;

  /// At most one line in five is outlying, and χ² of the others is at most so many standard deviations above its expectation.
  bool fit(std::size_t unknowns, double deviations = 5.0) const;

  /// The mean of log(1 + χ²/r) over the lines that are looked at, as linearised, weighted by their redundancy r.
  double linearised_misfit() const;

  std::size_t bytes() const;

 private:
  FittedLines(const FittedLines& all, std::size_t every);
  /// A few lines that are far from fitting once more from other starts; whether there were any.
  bool relax_stuck(const std::vector<double>& theta);
  using Settles = std::function<bool(const LineData& data, const ComplexMatrix& z, LineModel& model, FittedLine& line)>;
  void settle_by(const std::vector<double>& theta, const Settles& settles);
  Eigen::MatrixXd relaxed_gradients(std::size_t line, const FittedLine& before, const std::vector<std::vector<double>>& nearby,
                                    const std::vector<Eigen::VectorXd>& offsets, LineModel& model);
  /// For this process's lines; then costs are known of all.
  void for_all(const std::function<void(std::size_t, LineModel&)>& work);
  void exchange_costs();
  bool is_looked_at(std::size_t line) const {
    return lines_[line].redundancy > 0.0 && (passed_over_.empty() || !passed_over_[line]);
  }

  /// The line without the systematic errors of `theta`; as measured where there are none.
  const LineData& data_at(std::size_t line, const std::vector<double>& theta);

  LikelihoodData* data_;
  std::size_t joint_unknowns_;
  std::vector<LineData> corrected_;  ///< data_at() of every line, where there are systematic errors
  std::size_t threads_;
  std::function<void(std::size_t, std::size_t)> watch_;
  std::vector<FittedLine> lines_;
  LineShares::Range own_;
  std::vector<std::unique_ptr<LineModel>> models_;  ///< one per thread, kept: their matrices are large
  double tolerance_ = 1.0;
  std::vector<bool> passed_over_;  ///< which lines; empty: none
  bool as_measured_ = true;  ///< the variances
};

}  // namespace jointid::ident
