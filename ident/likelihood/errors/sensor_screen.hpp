#pragma once

#include <oneapi/tbb/enumerable_thread_specific.h>

#include <memory>
#include <vector>

#include "ident/likelihood/data/observations.hpp"
#include "ident/likelihood/errors/error_trials.hpp"
#include "ident/likelihood/errors/line_scores.hpp"

namespace jointid::ident {

/// Whether the gains of sensors are worth a place in a pass over many lines, where they are most of its columns. Score tests need the
/// gradient g of a gain, which costs little on every line, and the information I on it, which costs much. Here g is of all lines, and I
/// of 128 spread ones, in proportion. A gain whose |g|/√I stays below the score that is told though I were half of that is excluded.
class SensorScreen {
 public:
  /// Score of a gain that is told, in standard deviations (suspect_gains()).
  static constexpr double significant = 5.0;

  /// Of lines enough, with independent errors and no systematic error as an unknown; else nullptr. Works on the spread lines.
  /// `inflation`: of errors, as TriedErrors has it.
  static std::unique_ptr<SensorScreen> of(const Plan& plan, const LinearisedLikelihood& estimator, const LikelihoodFit& fit,
                                          double inflation, const Control& control);

  /// Whether no gain has a score on the spread lines with which excludes_all() is not to be expected.
  bool is_promising() const;

  /// A line, while `model` has its factors: the gradient of the gains with the FRFs of the line eliminated. By any thread.
  void take(std::size_t line, LineModel& model);

  /// Σ weight · gradient of the gains over the lines of all processes.
  Eigen::VectorXd gradient() const;

  /// Once all lines that count were taken: whether no gain can be told. `known`: gradient of the unknowns of the fit.
  bool excludes_all(const Eigen::VectorXd& known) const;

 private:
  /// What a thread takes over from line to line.
  struct Room {
    LineData data;
    std::shared_ptr<SystematicFrfs> frfs = std::make_shared<SystematicFrfs>();
    SystematicTerms terms;
  };

  SensorScreen(const Plan& plan, const LinearisedLikelihood& estimator, const LikelihoodFit& fit, double inflation, ErrorTrials sensors);
  Scores scores_of(const std::vector<std::size_t>& lines, const Control& control) const;
  void look(const std::vector<std::size_t>& used, const Control& control);

  const Plan& plan_;
  const Observations& observations_;
  const LinearisedLikelihood& estimator_;
  const LikelihoodFit& fit_;
  double inflation_;
  ErrorTrials sensors_;
  SystematicLines lines_;
  std::vector<SystematicUnknown> unknowns_;
  double in_all_ = 1.0;                  ///< lines that count over those that are looked at
  Scores spread_;                        ///< of these, of the unknowns of the fit and of the gains
  Eigen::VectorXd own_;                  ///< information on each gain, that of all else taken off
  bool agree_ = true;                    ///< whether two halves of these lines tell about the same of each gain
  std::vector<Eigen::VectorXd> of_lines_;
  oneapi::tbb::enumerable_thread_specific<Room> rooms_;
};

}  // namespace jointid::ident
