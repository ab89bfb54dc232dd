#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "ident/plan/plan.hpp"
#include "ident/result/control.hpp"
#include "study/trial_data.hpp"

namespace jointid::study {

/// What one trial found.
struct Trial {
  ident::Status status = ident::Status::ok;
  std::vector<double> values;  ///< SI, one per TrialData::unknowns; NaN when there is no estimate
  std::vector<std::optional<std::array<double, 2>>> ci95;  ///< as long as values
  std::vector<ident::Quality> quality;                            ///< one per TrialData::judged; NaN when there is no estimate
  std::size_t iterations = 0;  ///< of iterative methods
  double solve_s = 0.0;  ///< assembling and solving, without drawing the noise
  std::size_t accumulator_bytes = 0;
};

/// Plans once, then pollutes and solves as often as asked. The numbers of a trial depend on (seed, trial) alone, not on
/// the runner, its thread or the trials before. Not thread-safe: one runner per thread on shared data.
class TrialRunner {
 public:
  /// `interrupted`: asked between lines; run() then throws Interrupted.
  explicit TrialRunner(std::shared_ptr<const TrialData> data, std::function<bool()> interrupted = {});
  ~TrialRunner();
  TrialRunner(TrialRunner&&) noexcept;

  Trial run(std::uint64_t seed, std::uint64_t trial);

  const ident::Plan& plan() const;

  /// The polluted data of the last trial.
  const Measurements& measurements() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace jointid::study
