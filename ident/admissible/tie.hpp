#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace jointid::ident {

/// A tie as a row: coefficients·θ = value, θ in SI.
struct Tie {
  Eigen::VectorXd coefficients;
  double value = 0.0;
};

/// Parses "K(1,1) = 2*K(2,2) + 1e4": linear expressions of the unknowns `names` on both sides. Throws InputError (usage) that
/// quotes the tie.
Tie parse_tie(const std::string& text, const std::vector<std::string>& names);

/// coefficients·θ + constant ≥ 0, θ in SI.
struct LinearInequality {
  Eigen::VectorXd coefficients;
  double constant = 0.0;
  std::string text;  ///< "D(1,1) <= 0.1*K(1,1)"
};

/// Parses "K(1,1) >= 2*K(2,2)", or "0.01*K(1,1) <= D(1,1) <= 0.1*K(1,1)", which is two. Throws as parse_tie().
std::vector<LinearInequality> parse_inequality(const std::string& text, const std::vector<std::string>& names);

/// All θ that meet ties: offset + directions·w. One unknown of each tie is expressed by the others, the rest are the w.
struct TiedUnknowns {
  Eigen::VectorXd offset;      ///< [unknowns]
  Eigen::MatrixXd directions;  ///< [unknowns × free]
};

/// Gauss–Jordan elimination with full pivoting. Throws InputError (usage) for ties that contradict each other and for ties
/// that leave no unknown free.
TiedUnknowns eliminate(std::vector<Tie> ties, Eigen::Index unknowns);

}  // namespace jointid::ident
