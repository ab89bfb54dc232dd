#pragma once

#include <map>
#include <optional>

#include "ident/likelihood/errors/line_scores.hpp"

namespace jointid::ident {

/// Scores of the unknowns of a fit by blocks of neighbouring lines.
class BlockScores {
 public:
  /// Of `lines` lines; three lines a block at least, 20 blocks at most.
  BlockScores(std::size_t lines, std::size_t unknowns);
  void add(const ScoredLine& line);
  BlockScores& operator+=(const BlockScores& other);
  std::vector<double> numbers();
  void take(const std::vector<double>& numbers);

  std::size_t count() const { return blocks_.size(); }

  /// Delete-a-block jackknife, to first order: θ without a block is (I − I_b)⁻¹ g_b away, and (B − 1)/B Σ of its squares the covariance,
  /// whatever the errors of neighbouring lines have in common. `whole`: information I with priors. Empty where a block alone fixes an
  /// unknown, or there are fewer than six.
  std::optional<Eigen::MatrixXd> covariance(const Eigen::MatrixXd& whole) const;

 private:
  Scores& block(std::size_t b);

  std::size_t lines_, unknowns_;
  std::vector<Scores> blocks_;  ///< those without a line yet are empty
};

}  // namespace jointid::ident
