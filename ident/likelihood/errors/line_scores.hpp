#pragma once

#include <Eigen/Core>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "ident/likelihood/data/systematic_lines.hpp"
#include "ident/likelihood/fit/estimator.hpp"
#include "ident/likelihood/model/line_model.hpp"
#include "ident/plan/plan.hpp"
#include "ident/result/control.hpp"

namespace jointid::ident {

/// A line at the estimate, reduced to the unknowns of the fit and, after them, to systematic errors that are tried.
struct ScoredLine {
  std::size_t line;
  double weight;                            ///< robust weight
  const std::vector<std::size_t>& columns;  ///< of all unknowns: those of reduced
  const ReducedLine& reduced;
  const LineData& data;  ///< as measured, with the factors of the trials
};

/// Weights of the blocks of a line as one list.
std::vector<Complex> weights_of(const LineData& line);

/// Runs of lines that are worked on side by side. They do not depend on the number of threads, so that sums of what the runs sum up
/// do not either.
constexpr std::size_t most_runs = 16;

/// Terms of a line by the FRFs that have what is tried, LineData::systematic.
using TermsOf = std::function<SystematicTerms(std::size_t line, const LineData& data)>;

/// What else is asked of a line while its factors are there, those of LineModel::reduce(). By any thread.
using FactorsOf = std::function<void(std::size_t line, LineModel& model)>;

/// Tells `look` every line of this process that counts, with the number of its run. `terms`: in place of those of trials.plan().
/// What a line refers to is the next one's afterwards.
void score_lines(const Plan& plan, const LinearisedLikelihood& estimator, const LikelihoodFit& fit, const SystematicLines& trials,
                 const Control& control, const std::function<void(std::size_t run, const ScoredLine& line)>& look,
                 const TermsOf& terms = {}, const FactorsOf& factors = {});

/// What the runs sum up, in their order: `none` and all lines of this process that count, by add(line) and +=.
template <class Sum>
Sum sum_over_lines(const Plan& plan, const LinearisedLikelihood& estimator, const LikelihoodFit& fit, const SystematicLines& trials,
                   const Control& control, const Sum& none, const TermsOf& terms = {}, const FactorsOf& factors = {}) {
  std::vector<Sum> runs(most_runs, none);
  const auto add = [&](std::size_t run, const ScoredLine& line) { runs[run].add(line); };
  score_lines(plan, estimator, fit, trials, control, add, terms, factors);
  Sum all = std::move(runs.front());
  for (std::size_t run = 1; run < runs.size(); ++run) all += runs[run];
  return all;
}

/// Information and gradient of unknowns.
struct Scores {
  Eigen::MatrixXd information;
  Eigen::VectorXd gradient;

  static Scores none(std::size_t unknowns);
  /// Adds a line; unknowns beyond those that are here are passed over.
  void add(const ScoredLine& line);
  Scores& operator+=(const Scores& other);
};

/// What is left of information and gradient of the last unknowns once the first `known` are eliminated.
Scores left_of(const Scores& whole, std::size_t known);

}  // namespace jointid::ident
