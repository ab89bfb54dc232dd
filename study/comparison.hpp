#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/statistics.hpp"
#include "study/trial_loop.hpp"

namespace jointid::study {

/// One way to identify the joint of a scene.
struct Way {
  ident::Method method = ident::Method::one;
  std::vector<ident::Equation> equations;  ///< empty: all that the data allow
  weighting::Weighting weighting = weighting::Weighting::wb;
  double delta = 0.0;  ///< 0 ≤ Δ < 2
  ident::Solver solver = ident::Solver::automatic;
  ident::Regeneration regenerate{};  ///< of the data, by modal models
};

/// Alternatives per choice; an empty list means the scene's own. Equations for another method than the scene's: all that
/// the data allow.
struct Alternatives {
  std::vector<ident::Method> methods;
  std::vector<std::vector<ident::Equation>> equations;
  std::vector<weighting::Weighting> weightings;
  std::vector<double> deltas;
  std::vector<ident::Solver> solvers;
  std::vector<ident::Regeneration> regenerations{};
};

/// Every combination, Δ fastest, then weighting, solver, equations, method, regeneration; one weighting and Δ for methods that
/// have neither.
std::vector<Way> combinations(const ident::IdentifySection& identify, const Alternatives& alternatives,
                              const ident::Regeneration& regenerate = {});

/// How well one joint matrix was found, over the trials with status ok; NaN when there is none.
struct MatrixFigures {
  restrictions::Kind kind = restrictions::Kind::stiffness;
  Spread rjcf{}, arvf{}, rms_relative_error{};  ///< of Quality
  double bias = 0.0;  ///< rms over the unknowns with a truth that is not 0 of mean over trials (estimate/truth) − 1
  bool on_front = false;  ///< no other combination has less median rms error of this matrix in no more time, or less time
};

struct Combination {
  Way way;  ///< with the equations and the solver that were used
  std::vector<MatrixFigures> matrices;
  std::map<ident::Status, std::size_t> statuses;  ///< trials per status
  double solve_s = 0.0;                    ///< median time of assembling and solving on one thread
  std::size_t accumulator_bytes = 0;       ///< of the reduced system, the largest over the trials
};

struct LeftOut {
  Way way;
  std::string reason;
};

struct Comparison {
  std::vector<Combination> combinations;
  std::vector<LeftOut> left_out;  ///< ways that the scene or its data do not allow
  bool interrupted = false;       ///< not all ways are there
};

/// Base data and noise for a scene, e.g. load_trial_data.
using TrialSource = std::function<std::shared_ptr<const TrialData>(const ident::Scene&)>;

/// `data` for another weighting, Δ and solver.
std::shared_ptr<const TrialData> with_way(const TrialData& data, const Way& way);

/// Runs the same trials (same seed, hence the same errors on every FRF) for every way. The base data are loaded once per
/// regeneration, method and equation set. `so_far` is given what there is after every way, its fronts not marked. Throws
/// InputError for a scene without [truth], and when no way is possible.
Comparison compare(const ident::Scene& scene, const std::vector<Way>& ways, const TrialSource& source, const TrialOptions& options,
                   const std::function<void(const Comparison&)>& so_far = {});

/// Sets MatrixFigures::on_front: a combination is on the front when none is at least as good in error and time, and better in
/// one of them.
void mark_fronts(std::vector<Combination>& combinations);

}  // namespace jointid::study
