#pragma once

#include <functional>

#include "base/control.hpp"
#include "ident/result/solution.hpp"
#include "ident/team/line_shares.hpp"

namespace jointid::ident {

/// What solve() works out beside the estimates.
enum class Detail {
  estimates,  ///< estimates, matrices and quality; Fit::condition is 0 unless the rank is not full, no asm_frf_error
  full
};

/// By what solve() tells whether an answer may be trusted, beside rank, rounding and convergence.
enum class Judgement {
  none,
  fit,  ///< and by what the fit itself tells: χ² and energy that the joint gives away; nothing more is read
  data  ///< and, with Detail::full, against its data: judge_linear() and quick_check(), which read FRFs of some lines beyond the plan's
};

/// How the caller watches and stops a run. All functions are optional. `progress` and `interrupted` are called between lines or chunks of
/// lines, by any thread; `so_far` by the calling one. A stage without lines has a total of 0.
struct Control {
  std::size_t threads = 0;  ///< 0: all cores. The result does not depend on it.
  std::function<void(const char* stage, std::size_t done, std::size_t total)> progress;
  std::function<bool()> interrupted;
  Detail detail = Detail::full;
  Judgement judgement = Judgement::fit;
  /// Given the best estimate there is, to be kept should the run be interrupted: after every step of an iterative method (status
  /// not_converged), and when only judgements of the estimate are left to be worked out.
  std::function<void(const Solution&)> so_far = {};
  LineShares shares = {};  ///< with other processes that solve the same
};

}  // namespace jointid::ident
