#pragma once

#include "ident/likelihood/model/explicit_line.hpp"
#include "minimise/blocks.hpp"

namespace jointid::ident {

/// The joint's unknowns as the search has them: theta = centre + scale · t, with scale about their standard errors.
struct JointScale {
  std::vector<double> centre, scale;

  std::vector<double> theta(const double* t) const;
};

/// Residuals of a line by t and u.
class LineCost final : public minimise::ResidualBlock {
 public:
  LineCost(const ExplicitLine& line, const JointScale& joint) : line_(line), joint_(joint) {}
  std::size_t residuals() const override { return line_.residuals(); }
  std::vector<std::size_t> sizes() const override { return {joint_.centre.size(), line_.own()}; }
  bool evaluate(double const* const* parameters, double* residuals, double** jacobians) const override;

 private:
  const ExplicitLine& line_;
  const JointScale& joint_;
};

/// ρ(s) = s up to a limit l, beyond it l(2 − l/s). With l = 1.5² · redundancy the loss of LikelihoodEstimator.
class LineLoss final : public minimise::Loss {
 public:
  explicit LineLoss(double limit) : limit_(limit) {}
  void evaluate(double s, double rho[3]) const override;

 private:
  double limit_;
};

}  // namespace jointid::ident
