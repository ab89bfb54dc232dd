#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "response/structure/receptance.hpp"

namespace jointid::response {

/// Receptances of another structure with errors taken off: Lᵀ(H + Σ_k (σ_re u_2k + iσ_im u_2k+1)·shape_k)E at the frequencies
/// that are given, u in standard deviations of Receptance::errors() in their order; at all others as they are.
class CorrectedReceptance final : public Receptance {
 public:
  explicit CorrectedReceptance(std::shared_ptr<const Receptance> of) : of_(std::move(of)) {}

  /// Throws InputError unless there are two numbers for each error there.
  void correct(double omega, const Eigen::VectorXd& deviations);

  Eigen::Index joints() const override { return of_->joints(); }
  Eigen::Index responses() const override { return of_->responses(); }
  Eigen::Index forces() const override { return of_->forces(); }
  bool covers(double omega) const override { return of_->covers(omega); }
  Eigen::MatrixXcd at(double omega) const override;
  std::optional<Eigen::MatrixXcd> derivative(double omega) const override { return of_->derivative(omega); }
  double nearest(double omega) const override { return of_->nearest(omega); }
  std::vector<ReceptanceError> errors(double omega) const override { return of_->errors(omega); }

 private:
  std::shared_ptr<const Receptance> of_;
  std::vector<std::pair<double, Eigen::MatrixXcd>> corrections_;  ///< frequency, what is added
};

}  // namespace jointid::response
