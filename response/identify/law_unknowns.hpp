#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "friction/path/parameter_scale.hpp"
#include "response/harmonic/condensed_equations.hpp"

namespace jointid::response {

/// A parameter of a joint that is unknown, and those of other joints that are the same number.
struct Unknown {
  JointParameter parameter;
  std::vector<JointParameter> ties{};
  std::optional<std::array<double, 2>> bounds{};  ///< inside those of the law
  std::optional<std::array<double, 2>> prior{};   ///< value and standard deviation that an earlier test tells
};

/// Joints of which some parameters are unknown, and the numbers without bounds that stand for them: logarithms of what is
/// positive, the scales of friction::ParameterScale of the rest. A spring, dashpot or cubic spring is positive.
class LawUnknowns {
 public:
  /// All parameters of all friction laws are unknown, the values of the joints where a fit starts.
  explicit LawUnknowns(std::vector<Joint> joints);
  /// These are. Throws InputError (usage) for one that is not there, is named twice, or starts at a bound.
  LawUnknowns(std::vector<Joint> joints, const std::vector<JointParameter>& free);
  LawUnknowns(std::vector<Joint> joints, std::vector<Unknown> unknowns);

  const std::vector<Joint>& joints() const { return joints_; }
  Eigen::Index size() const { return at(unknowns_.size()); }
  const Unknown& unknown(Eigen::Index i) const { return unknowns_[static_cast<std::size_t>(i)]; }

  /// Parameters that move, those that are tied included, and the unknown that each follows.
  const std::vector<JointParameter>& moved() const { return moved_; }
  const std::vector<Eigen::Index>& moved_by() const { return moved_by_; }
  /// How many unknowns have a prior.
  Eigen::Index priors() const;

  /// The unknown parameter with its name, unit and bounds.
  const friction::Parameter& parameter(Eigen::Index i) const { return parameters_[static_cast<std::size_t>(i)]; }

  Eigen::VectorXd start() const;
  /// The joints of these numbers; nothing when a law does not make sense there.
  std::optional<std::vector<Joint>> at_numbers(const Eigen::VectorXd& numbers) const;
  Eigen::VectorXd values(const Eigen::VectorXd& numbers) const;
  /// d value/d number of each.
  Eigen::VectorXd slopes(const Eigen::VectorXd& numbers) const;

 private:
  void require_new(const JointParameter& member) const;

  std::vector<Joint> joints_;
  std::vector<Unknown> unknowns_;
  std::vector<friction::Parameter> parameters_;
  std::vector<JointParameter> moved_;
  std::vector<Eigen::Index> moved_by_;
};

}  // namespace jointid::response
