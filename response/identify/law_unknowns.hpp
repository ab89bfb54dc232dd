#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "friction/path/parameter_scale.hpp"
#include "response/harmonic/condensed_equations.hpp"

namespace jointid::response {

/// Joints of which some parameters are unknown, and the numbers without bounds that stand for them: logarithms of what is
/// positive, the scales of friction::ParameterScale of the rest. A spring, dashpot or cubic spring is positive.
class LawUnknowns {
 public:
  /// All parameters of all friction laws are unknown, the values of the joints where a fit starts.
  explicit LawUnknowns(std::vector<Joint> joints);
  /// These are. Throws InputError (usage) for one that is not there, is named twice, or starts at a bound.
  LawUnknowns(std::vector<Joint> joints, std::vector<JointParameter> free);

  const std::vector<Joint>& joints() const { return joints_; }
  const std::vector<JointParameter>& free() const { return free_; }
  Eigen::Index size() const { return at(free_.size()); }

  /// The unknown parameter with its name, unit and bounds.
  const friction::Parameter& parameter(Eigen::Index i) const { return parameters_[static_cast<std::size_t>(i)]; }

  Eigen::VectorXd start() const;
  /// The joints of these numbers; nothing when a law does not make sense there.
  std::optional<std::vector<Joint>> at_numbers(const Eigen::VectorXd& numbers) const;
  Eigen::VectorXd values(const Eigen::VectorXd& numbers) const;
  /// d value/d number of each.
  Eigen::VectorXd slopes(const Eigen::VectorXd& numbers) const;

 private:
  std::vector<Joint> joints_;
  std::vector<JointParameter> free_;
  std::vector<friction::Parameter> parameters_;
};

}  // namespace jointid::response
