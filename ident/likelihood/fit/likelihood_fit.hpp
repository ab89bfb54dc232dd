#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace jointid::ident {

/// What the likelihood found, in the scaled unknowns x = {k, ω₀²m, ω₀c, d} and after them those of systematic errors.
struct LikelihoodFit {
  std::vector<double> theta;
  Eigen::MatrixXd information;    ///< Σ weighted reduced information at theta: its inverse is the Cramér–Rao covariance
  std::vector<double> line_cost;  ///< χ² per line
  std::vector<double> line_weight;  ///< robust weight, 1 for a line that fits, 0 for one that says nothing of the joint
  std::size_t iterations = 0;       ///< steps of the joint's unknowns
  std::size_t starts = 0;           ///< how many starts were tried
  double loss = 0.0;                ///< Σ L
  bool converged = false;           ///< the last step was below 10⁻³ standard deviations
  bool reached_known = false;       ///< ended where another start had settled
  bool hopeless = false;  ///< stopped, or no other start tried, because steps and starts did not mend lines that are far from fitting
  std::size_t bytes = 0;            ///< of the lines' states and what was linearised about them

  struct End {
    double loss;
    std::vector<double> theta;
  };
  std::vector<End> ends;  ///< of all starts that settled
};

/// How many starts are followed.
enum class Follow {
  until_it_fits,        ///< by χ², unless it is doubtful: then all
  until_reached_twice,  ///< it fits, by χ² at 95 % too, and two starts ended in the best; else all: for data with several minima.
                        ///< A start that comes to within its standard deviation is not followed to the end
  all
};

/// Whether an estimate is so uncertain that another minimum may fit as well.
using Doubt = std::function<bool(const LikelihoodFit& fit)>;

/// The k-th start, or empty when there is no other.
using Starts = std::function<std::optional<std::vector<double>>(std::size_t k)>;

/// Watches a fit; called once per iteration, may throw to stop it.
using FitWatcher = std::function<void(std::size_t iteration)>;

/// Called with every estimate on the way and Σ L there, infinite before the FRFs of the lines are optimised.
using FitListener = std::function<void(const LikelihoodFit& fit, double loss)>;

/// How starts are followed, and who is asked and told.
struct FollowOptions {
  Follow follow = Follow::until_it_fits;
  Doubt doubtful{};
  FitListener listener{};
  /// Asked at most once, and only where most lines are far from fitting: whether the data contradict every joint, as something else
  /// than this fit tells. Then one start is followed, and no longer than steps mend the misfit by a third.
  std::function<bool(const std::vector<double>& theta)> second_opinion{};
  bool gives_up = true;  ///< no other start is followed once some have ended about as far from fitting
};

}  // namespace jointid::ident
