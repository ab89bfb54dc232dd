#pragma once

#include <functional>
#include <optional>
#include <span>

#include "ident/newton/response_problem.hpp"
#include "minimise/linear/triangle.hpp"

namespace jointid::ident {

/// The rows J s ≈ −F of a line, weighted.
void append(const ResponseProblem::Rows& rows, minimise::Triangle& triangle);

/// Where an iteration of method "newton" ended, in the scaled unknowns of its problem.
struct NewtonFit {
  std::vector<double> q;
  std::size_t iterations = 0;
  bool converged = false;
  bool diverged = false;  ///< see runs_away()
};

/// Whether an unknown is beyond 1e12, or no number: those of a ResponseProblem are about 1, and a joint that stiff moves the FRFs
/// no more. An iteration ends there.
bool runs_away(std::span<const double> q);

struct NewtonOptions {
  std::size_t most_iterations = 100;
  /// Ends where so many iterations together do not take a hundredth off the misfit; without it that is not asked.
  std::optional<std::size_t> patience{};
  std::function<bool()> draw{};          ///< chooses lines anew in every iteration; empty: all that may be used
  std::function<void(const std::vector<double>& q)> watch{};  ///< called where every iteration begins, may throw to stop it
};

/// Levenberg–Marquardt with geodesic acceleration (Transtrum and Sethna 2012). Weights 1/‖J‖ and the choice of lines are those of
/// the point where a step begins; a step is taken when it lowers the cost of these lines with these weights. It ends when the next
/// Gauss–Newton step is below 1e-3 standard deviations, as the residuals tell them, or below 1e-10 of every unknown.
NewtonFit damped_newton(ResponseProblem& problem, std::vector<double> start, const NewtonOptions& options = {});

/// The scheme of the thesis: full Gauss–Newton steps, divided by five until the cost falls (docs/formulas.md §7, 6.85), with its weights
/// and choice of lines. The same end.
NewtonFit divided_newton(ResponseProblem& problem, std::vector<double> start, const NewtonOptions& options = {});

/// Coordinates in which the linearised problem at a point is a sphere, for searches:
/// q = centre + R⁻¹x with RᵀR = JᵀJ (weighted) there.
class RoundCoordinates {
 public:
  RoundCoordinates(ResponseProblem& problem, std::vector<double> centre);

  std::vector<double> point(std::span<const double> x) const;

  /// ‖R·centre‖: how far the free joint is.
  double size() const { return size_; }

 private:
  std::vector<double> centre_;
  Eigen::MatrixXd r_;
  double size_ = 0.0;
};

/// A minimiser for fixed weights run again and again: a few of its iterations, then new weights and lines, in at most 40 rounds until
/// the unknowns stay.
NewtonFit in_rounds(ResponseProblem& problem, std::vector<double> start,
                    const std::function<minimise::Minimum(std::span<const double>)>& minimum, const NewtonOptions& options = {});

}  // namespace jointid::ident
