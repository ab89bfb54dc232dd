#pragma once

#include <functional>

#include "base/control.hpp"
#include "ident/result/solution.hpp"
#include "ident/team/line_shares.hpp"

namespace jointid::ident {

/// Results of solve() beside the estimates.
enum class Detail {
  estimates,  ///< estimates, matrices and quality; Fit::condition is 0 unless the rank is not full, no asm_frf_error
  full
};

/// Evidence for the verdict of solve(), beside rank, rounding and convergence.
enum class Judgement {
  none,
  fit,  ///< and the fit itself: χ² and the passivity of the joint; no further data are read
  data  ///< and, with Detail::full, against its data: judge_linear() and quick_check(), which read FRFs of some lines beyond the plan's
};

/// Progress and stop of a run. All functions are optional. Any thread calls `progress` and `interrupted`, between lines or chunks
/// of lines; the calling thread calls `so_far`. A stage without lines has a total of 0.
struct Control {
  std::size_t threads = 0;  ///< 0: all cores. The result does not depend on it.
  std::function<void(const char* stage, std::size_t done, std::size_t total)> progress;
  std::function<bool()> interrupted;
  Detail detail = Detail::full;
  Judgement judgement = Judgement::fit;
  /// Gets the best estimate, to keep if the run is interrupted: after every step of an iterative method (status not_converged),
  /// and before the final judgements of the estimate.
  std::function<void(const Solution&)> so_far = {};
  LineShares shares = {};  ///< with other processes that solve the same
};

}  // namespace jointid::ident
