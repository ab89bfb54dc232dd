#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "ident/likelihood/line/line_layout.hpp"
#include "ident/likelihood/line/symmetric.hpp"
#include "minimise/linear/correlation.hpp"

namespace jointid::ident {

/// `factor` times the error of a member of a group whose errors have a covariance.
struct ErrorTerm {
  /// The group of errors that are independent of each other and have a variance of 1.
  static constexpr std::size_t independent = static_cast<std::size_t>(-1);

  std::size_t group, member;
  Complex factor;
  double relation = 0.0;  ///< of an independent error: E[ε²], see frf::ErrorSums
};

/// What makes the error of a measured FRF; none where it is independent of all others.
using ErrorTerms = std::vector<ErrorTerm>;

/// What the errors of the FRFs of a line of one system have in common. Different groups are independent.
struct LineErrors {
  std::vector<Eigen::MatrixXcd> covariance;  ///< of a group
  Symmetric<ErrorTerms> terms;               ///< of an FRF, over the coordinates of a LineLayout
};

/// The variances of real and imaginary part of each element, 0 for one without a weight, to the correlation of the elements of a line from
/// the errors of both systems, of which either may be empty; empty where nothing depends on anything. H_sub(n,n) and H_asm(n,n) stand
/// alone in their rows: D has the error of both.
std::shared_ptr<const minimise::Correlation> correlation_of(const LineLayout& layout, const LineErrors* substructures,
                                                            const LineErrors* assembly, const std::vector<Complex>& variance);

}  // namespace jointid::ident
