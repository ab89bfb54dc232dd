#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "ident/plan/plan.hpp"
#include "ident/result/control.hpp"
#include "minimise/linear/accumulator.hpp"

namespace jointid::ident {

/// A linear estimate (scaled unknowns) with one of up to twelve groups of lines after the other left out.
struct LineJackknife {
  std::vector<std::vector<Line>> groups;
  std::vector<minimise::Accumulator> systems;  ///< of the groups, each alone
  Eigen::VectorXd all;                         ///< by all groups
  Eigen::MatrixXd without;                     ///< [unknowns × groups]: by all but one
  double residual = 0.0;                       ///< ‖r‖² of the weighted rows of all groups
  std::vector<double> residual_without;        ///< of all but one
  /// The scatter of `without` (delete-a-group jackknife), (G−1)/G Σ_g (y_g − ȳ)(y_g − ȳ)ᵀ, scaled to all lines of the plan. It
  /// has no part of the bias, which all groups share.
  Eigen::MatrixXd covariance;
};

/// Groups are neighbouring lines, so that errors which neighbours share count as one; every twelfth line where a joint has bands.
/// At most `most_lines` lines spread over all are taken. Empty with fewer than four lines, and where a group cannot be left out
/// without the rank becoming less.
std::optional<LineJackknife> line_jackknife(const Plan& plan, std::size_t most_lines, const Control& control);

/// The variances alone, of the scaled unknowns: for many of them, whose covariances would fill the memory.
std::optional<Eigen::VectorXd> line_scatter(const Plan& plan, std::size_t most_lines, const Control& control);

/// Groups of at most `most_lines` lines spread over all, as LineJackknife has them. Empty with fewer than four lines, and for a method
/// that is not linear.
std::vector<std::vector<Line>> jackknife_groups(const Plan& plan, std::size_t most_lines);

/// The share that the lines of groups have of all.
double share_of_all(const Plan& plan, const std::vector<std::vector<Line>>& groups);

/// The systems of groups of lines, each alone.
std::vector<minimise::Accumulator> systems_of(const Plan& plan, const std::vector<std::vector<Line>>& groups, const Control& control);

/// All systems but those that are named, together.
minimise::Accumulator system_without(const Plan& plan, std::vector<minimise::Accumulator>& systems,
                                     const std::vector<std::size_t>& left_out);

/// An estimate (scaled unknowns) and ‖r‖² of its weighted rows.
struct PartialEstimate {
  Eigen::VectorXd theta;
  double residual = 0.0;
};

/// The estimate by all systems but those that are named; empty where the rank is not full.
std::optional<PartialEstimate> estimate_without(const Plan& plan, std::vector<minimise::Accumulator>& systems,
                                                const std::vector<std::size_t>& left_out);

/// √((G−1)/G) (y_g − ȳ) of the columns of `estimates`.
Eigen::MatrixXd jackknife_deviations(const Eigen::MatrixXd& estimates);

/// (G−1)/G Σ_g (y_g − ȳ)(y_g − ȳ)ᵀ of them.
Eigen::MatrixXd jackknife_scatter(const Eigen::MatrixXd& estimates);

}  // namespace jointid::ident
