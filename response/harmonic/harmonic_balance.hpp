#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "response/harmonic/newton.hpp"
#include "response/harmonic/solution.hpp"

namespace jointid::response {

/// The harmonics of a solution.
struct HarmonicChoice {
  std::vector<int> fixed{};  ///< these; or, if empty, as many as necessary:
  double tolerance = 1e-6;   ///< added until ‖G_nF_n‖ ≤ tolerance ‖Q‖ for the next ones …
  int largest = 41;          ///< … up to this one
};

/// Periodic responses of a structure with friction joints under harmonic forces, condensed to the joints (docs/response.md).
class HarmonicBalance {
 public:
  /// Throws InputError (usage) unless there is a joint for each joint row of the structure and a force for each force column.
  HarmonicBalance(std::shared_ptr<const Receptance> structure, std::vector<Joint> joints, Excitation force,
                  HarmonicChoice choice = {});

  /// At ω (rad/s) with the forces times `level`. Starts: the neighbour if given, sticking joints, joints without force. Then
  /// force levels from low to this one, springs in series with the joints from soft to rigid, and harmonics one by one.
  HarmonicSolution solve(double omega, double level = 1.0, const HarmonicSolution* neighbour = nullptr) const;

  const Receptance& structure() const { return *structure_; }
  const std::vector<Joint>& joints() const { return joints_; }
  const Excitation& force() const { return force_; }
  const HarmonicChoice& choice() const { return choice_; }

  /// The same with another joint.
  HarmonicBalance with_joint(std::size_t index, Joint joint) const;

  /// Q, F, X and losses of the unknowns of these equations.
  HarmonicSolution describe(const CondensedEquations& equations, const HarmonicLine& line, double level,
                            const Eigen::VectorXd& motion) const;

 private:
  std::vector<int> covered(std::vector<int> numbers, double omega) const;
  std::vector<int> following(const Harmonics& harmonics) const;
  HarmonicSolution solve_for(const Harmonics& harmonics, double omega, double level, const HarmonicSolution* neighbour) const;
  void look_ahead(const CondensedEquations& equations, const Eigen::VectorXd& motion, HarmonicSolution& solution) const;

  std::shared_ptr<const Receptance> structure_;
  std::vector<Joint> joints_;
  Excitation force_;
  HarmonicChoice choice_;
};

/// Q, F, X and losses of a motion with these forces of the joints, [harmonic, joint]; they need not balance.
HarmonicSolution described(const CondensedEquations& equations, const HarmonicLine& line, double level, const Eigen::VectorXd& motion,
                           Eigen::MatrixXcd force);

}  // namespace jointid::response
