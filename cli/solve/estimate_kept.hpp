#pragma once

#include <optional>
#include <string>

#include "base/stopwatch.hpp"
#include "cli/resume/kept_state.hpp"
#include "ident/result/solution.hpp"
#include "ident/scene/scene.hpp"

namespace jointid::cli {

/// The best values so far of an iterative method, kept in a file from which the next run starts. Linear methods take one pass and loose
/// joints start from nominal ones: nothing is kept of these.
class EstimateKept {
 public:
  /// `from_start`: put() writes the file; else words() alone does.
  EstimateKept(KeptState state, const ident::Scene& scene, bool from_start)
      : state_(std::move(state)), from_start_(from_start), is_loose_(scene.identify.loose) {}

  /// Of a run before, as the start of the scene, with the method that it used. Throws InputError as KeptState::read().
  void take_up(ident::Scene& scene);

  /// Why its method was chosen, for the plan of that scene; empty where nothing was taken up, or the scene names the method.
  const std::string& chosen() const { return chosen_; }

  /// At most once in a second.
  void put(const ident::Solution& best);

  /// Keeps it, and what is reported of that: ", FILE keeps …" or nothing.
  std::string words(const ident::Solution& best);

  /// Of a run that is complete.
  void remove() { state_.remove(); }

 private:
  /// Empty where a start would be of no use.
  std::string state_of(const ident::Solution& best) const;

  KeptState state_;
  bool from_start_, is_loose_;
  std::string chosen_{};  ///< of a run before
  std::optional<Clock::time_point> put_{};
};

}  // namespace jointid::cli
