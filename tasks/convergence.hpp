#pragma once

#include "ident/plan/plan.hpp"
#include "ident/result/control.hpp"

namespace jointid::tasks {

/// Figures of merit of the joint identified from the first `lines` lines.
struct LineQuality {
  std::size_t lines = 0;
  double frequency_hz = 0.0;  ///< of the last of them
  std::map<restrictions::Kind, ident::Quality> quality;
};

/// RJCF and ARVF against the number of frequency lines (docs/formulas.md §6): the scene solved from its first line,
/// its first two, … Starts where the lines fix every unknown. With more than `points` lines, that many numbers of lines
/// spread evenly. Empty when the scene tells no truth.
std::vector<LineQuality> quality_by_line(const ident::Plan& plan, std::size_t points, const ident::Control& control = {});

/// The unknowns from the first `lines` lines together, and from the last of these lines alone; empty where they do not fix every
/// unknown.
struct LineUnknowns {
  std::size_t lines = 0;
  double frequency_hz = 0.0;
  std::vector<double> together, alone;  ///< in the order of `names`
};
struct UnknownsByLine {
  std::vector<std::string> names;
  std::vector<LineUnknowns> lines;
};

/// Each unknown over the accumulated lines, and from each line by itself (Ren's figures 6.4, 6.19, 6.20): lines that move an estimate
/// or give another one are bad, which needs no truth. Points as of quality_by_line(). Throws InputError (usage) for methods that do
/// not accumulate lines.
UnknownsByLine unknowns_by_line(const ident::Plan& plan, std::size_t points, const ident::Control& control = {});

/// A step of an iterative method that came nearer to the minimum than all before.
struct IterationUnknowns {
  std::size_t iteration = 0;
  std::optional<double> objective{};  ///< ident::Fit::objective; none before it is known
  std::vector<double> values;         ///< in the order of `names`
};
struct UnknownsByIteration {
  std::vector<std::string> names;
  std::vector<IterationUnknowns> iterations;  ///< the solution itself is the last
};

/// The objective and each unknown over the iterations (Ren's figures 6.26, 6.27), by a solution of its own: an unknown that still moves
/// while the objective no longer does is not determined. Throws InputError (usage) for methods that do not iterate.
UnknownsByIteration unknowns_by_iteration(ident::Plan& plan, const ident::Control& control = {});

/// The same of a solution that is made anyway: gives each Control::so_far to note(), and the solution to ended().
class IterationLog {
 public:
  /// Steps of the iteration; what methods hand out at their end is no step.
  void note(const ident::Solution& best);
  /// With the solution as the last; no step of methods that do not iterate.
  UnknownsByIteration ended(const ident::Solution& solution) const;

 private:
  std::vector<IterationUnknowns> steps_;
};

}  // namespace jointid::tasks
