#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ident/plan/plan.hpp"
#include "ident/result/control.hpp"
#include "ident/result/identifiability.hpp"

namespace jointid::tasks {

/// The Cramér–Rao bound of one unknown for an assumed joint.
struct UnknownBound {
  std::string name, unit;
  double value = 0.0;     ///< of the assumed joint, SI
  double bound = 0.0;     ///< SI; infinite if the data do not determine it
  double relative = 0.0;  ///< to the assumed value, see relative_scales()
};

/// Effect of other data on the bounds.
struct BoundChange {
  std::string what;             ///< "4:+Y", "400 to 460 Hz"
  std::vector<double> factors;  ///< bound then / bound now, per unknown; infinite if it is no longer determined
  double worst = 1.0;           ///< the same of the largest relative bound
  double mean = 1.0;            ///< geometric mean of the factors
};

/// Prediction of a test before it is made (docs/formulas.md §11g).
struct BoundReport {
  bool interrupted = false;  ///< some changes of the data are missing; without unknowns the bound is missing, too
  std::size_t lines = 0;     ///< of the plan
  std::size_t lines_looked_at =
      0;  ///< for the changes of the data: as many as take two minutes of one core of the reference machine
  std::vector<UnknownBound> unknowns;
  std::vector<ident::WeakCombination> weakest;
  std::vector<std::string> variances;           ///< their sources, one phrase each
  std::vector<BoundChange> without_coordinate;  ///< internal: not measured at all; joint: not measured on the assembly
  std::vector<BoundChange> without_lines;       ///< without a tenth of the lines
  std::vector<BoundChange> with_more;           ///< candidates, all lines of the files, all equations that they allow
};

/// Predicts standard errors with FRFs of a model or an earlier test. The noise is that of [noise] or of the files, the joint that
/// of [truth], else of [identify] start. `candidates`: coordinates of the files that count as not measured; `with_more` has the
/// effect of each of them and of all together. The bound is that of the likelihood for the equations of the scene, whatever its
/// method. If all lines would take more than a minute of one core of the reference machine, the bound is that of some lines
/// spread over all, scaled to all. An interrupted run returns the partial result. `keep` gets the partial result after every
/// step. Throws InputError for scenes without an assumed joint, and as make_plan() does.
BoundReport predict_bound(const ident::Plan& plan, const ident::Dofs& candidates, const ident::Control& control,
                          const std::function<void(const BoundReport&)>& keep = {});

/// Checks a few lines of the files (ident::quick_check()): the first suspect in a sentence, empty if there is none.
std::string suspect_note(const ident::Plan& plan, const ident::Control& control);

}  // namespace jointid::tasks
