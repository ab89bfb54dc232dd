#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ident/plan/plan.hpp"
#include "ident/result/control.hpp"
#include "ident/result/identifiability.hpp"

namespace jointid::tasks {

/// The bound of one unknown for a guessed joint.
struct UnknownBound {
  std::string name, unit;
  double value = 0.0;     ///< of the guess, SI
  double bound = 0.0;     ///< SI; infinite when the data do not fix it
  double relative = 0.0;  ///< to the guess, see relative_scales()
};

/// What other data would do to the bounds.
struct BoundChange {
  std::string what;             ///< "4:+Y", "400 to 460 Hz"
  std::vector<double> factors;  ///< bound then / bound now, per unknown; infinite when it is no longer fixed
  double worst = 1.0;           ///< the same of the largest relative bound
  double mean = 1.0;            ///< geometric mean of the factors
};

/// What a test can tell about a joint, before it is made (docs/formulas.md §11g).
struct BoundReport {
  bool interrupted = false;  ///< not all changes of the data are there; without unknowns the bound is not, either
  std::size_t lines = 0;     ///< of the plan
  std::size_t lines_looked_at =
      0;  ///< for the changes of the data: as many as take two minutes of one core of the reference machine
  std::vector<UnknownBound> unknowns;
  std::vector<ident::WeakCombination> weakest;
  std::vector<std::string> variances;           ///< where they come from, one phrase each
  std::vector<BoundChange> without_coordinate;  ///< non-joint: not measured at all; joint: not measured on the assembly
  std::vector<BoundChange> without_lines;       ///< without a tenth of the lines
  std::vector<BoundChange> with_more;           ///< candidates, all lines of the files, all equations that they allow
};

/// Predicts standard deviations on FRFs of a model or an earlier test, with the errors of [noise] or of the files, for the joint
/// of [truth], else of [identify] start. `candidates`: coordinates of the files that count as not measured, until `with_more`
/// tells what each of them and all together would change. The bound is that of the likelihood for the equations of the scene,
/// whatever its method. Where all lines would take more than a minute of one core of the reference machine, the bound is that of
/// some spread over all, as if they were all. Interrupted, what there is so far. Throws InputError for scenes without a joint to
/// assume, and as make_plan() does. `keep` is given what there is after every step, for who may not wait for its end.
BoundReport predict_bound(const ident::Plan& plan, const ident::Dofs& candidates, const ident::Control& control,
                          const std::function<void(const BoundReport&)>& keep = {});

/// Looks at a few lines of the files for mistakes (ident::quick_check()): what stands out first, in a sentence; empty where nothing does.
std::string suspect_note(const ident::Plan& plan, const ident::Control& control);

}  // namespace jointid::tasks
