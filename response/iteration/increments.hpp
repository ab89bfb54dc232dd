#pragma once

#include <string_view>

#include "response/harmonic/condensed_equations.hpp"

namespace jointid::response {

struct NewtonRaphsonOptions {
  double tolerance = 1e-8;  ///< of the last step over the motion: the next one would be its square
  int most_steps = 60;
};

struct NewtonRaphson {
  bool converged = false;
  int steps = 0;  ///< the last one included
  Eigen::VectorXd motion;
};

/// The Newton–Raphson method as chapter 4 of Ren's thesis has it (4.65, 4.66), with the exact Jacobian: steps are halved while
/// ‖g‖, all unknowns alike, does not fall. newton() of harmonic/ weights joint by joint, and converges more often.
NewtonRaphson newton_raphson(const CondensedEquations& equations, const HarmonicLine& line, double level, Eigen::VectorXd start,
                             const NewtonRaphsonOptions& options = {});

/// What grows from a linear structure to the one asked for (4.68, 4.69).
enum class Increment {
  force,  ///< α_p P, α_p = 1/n … 1, first from joints that stick
  joint   ///< α_j F, α_j = 1/n … 1, first from joints without force
};
std::string_view word(Increment increment);

/// Where Newton's method starts after a step of α: the last solution (4.70), a line through two (4.72), a parabola through three
/// (4.74), or that of the three with the least ‖g‖.
enum class Estimate { direct, linear, quadratic, best };
std::string_view word(Estimate estimate);

struct IncrementRun {
  bool converged = false;
  int steps = 0;         ///< of Newton's method, all increments together
  double reached = 0.0;  ///< the last α, 1 where it converged; else the one that failed
  Eigen::VectorXd motion;
};

/// `count` equal increments; it ends at the first that does not converge in 40 steps.
IncrementRun increments(Increment increment, Estimate estimate, int count, const CondensedEquations& equations,
                        const HarmonicLine& line, double level);

}  // namespace jointid::response
