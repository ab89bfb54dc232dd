#pragma once

#include <map>
#include <optional>

#include "ident/likelihood/errors/line_scores.hpp"

namespace jointid::ident {

/// Delete-a-block jackknife, to first order: without block b θ moves by (I − I_b)⁻¹ (g − g_b) − I⁻¹ g. Its squares add up, over the
/// blocks, to Σ ((I − I_b)⁻¹ − I⁻¹) on average where errors of lines are independent and as large as assumed.
struct Jackknife {
  Eigen::VectorXd variance;  ///< (B − 1)/B Σ of the squares: rather too large where a block tells much of an unknown
  Eigen::VectorXd step;    ///< I⁻¹ g: what is left to the minimum
  double mean = 1.0;       ///< over the unknowns, of the ratio of the sum to that average
  double likely = 1.0;     ///< of the mean, five standard deviations up
  std::size_t blocks = 0;

  bool tells_more() const { return mean > likely; }
};

/// Scores of the unknowns of a fit by blocks of neighbouring lines.
class BlockScores {
 public:
  /// Of `lines` lines; three lines a block at least, 20 blocks at most. `more` unknowns from `first` on are others that may be taken off.
  BlockScores(std::size_t lines, std::size_t unknowns, std::size_t first = 0, std::size_t more = 0);
  void add(const ScoredLine& line);
  BlockScores& operator+=(const BlockScores& other);
  std::vector<double> numbers();
  void take(const std::vector<double>& numbers);

  /// `whole`: information I with priors and gradient of all lines, of the unknowns and the others; `taken`: what the others are, of which
  /// the moves are then free. Empty where a block alone fixes an unknown, or there are fewer than six.
  std::optional<Jackknife> jackknife(const Scores& whole, const Eigen::VectorXd& taken) const;

 private:
  Scores& block(std::size_t b);

  std::size_t lines_, unknowns_, first_, more_;
  std::vector<Scores> blocks_;  ///< those without a line yet are empty
};

}  // namespace jointid::ident
