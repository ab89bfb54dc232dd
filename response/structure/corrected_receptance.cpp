#include "response/structure/corrected_receptance.hpp"

#include <cmath>

#include "base/eigen.hpp"
#include "base/error.hpp"

namespace jointid::response {

void CorrectedReceptance::correct(double omega, const Eigen::VectorXd& deviations) {
  const std::vector<ReceptanceError> all = errors(omega);
  if (deviations.size() != 2 * jointid::at(all.size()))
    refuse("two deviations for each error of a receptance");
  Eigen::MatrixXcd sum = Eigen::MatrixXcd::Zero(joints() + responses(), joints() + forces());
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Eigen::Index place = 2 * jointid::at(k);
    sum += Complex(std::sqrt(all[k].variance.real()) * deviations(place),
                   std::sqrt(all[k].variance.imag()) * deviations(place + 1)) *
           all[k].shape;
  }
  corrections_.emplace_back(omega, std::move(sum));
}

Eigen::MatrixXcd CorrectedReceptance::at(double omega) const {
  Eigen::MatrixXcd found = of_->at(omega);
  for (const auto& [frequency, added] : corrections_) {
    if (frequency == omega) found += added;
  }
  return found;
}

}  // namespace jointid::response
