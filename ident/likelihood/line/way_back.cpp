#include "ident/likelihood/line/way_back.hpp"

#include "base/eigen.hpp"

namespace jointid::ident {

LineStep WayBack::times(const Eigen::VectorXd& step) const {
  if (columns_.rows() == 0) return all_ * step;
  Eigen::VectorXcd by_column = Eigen::VectorXcd::Zero(columns_.cols());
  for (std::size_t i = 0; i < unknowns_.size(); ++i) by_column[unknowns_[i].column] += unknowns_[i].factor * step[at(i)];
  LineStep out(2 * columns_.rows());
  Eigen::Map<Eigen::VectorXcd>(reinterpret_cast<Complex*>(out.data()), columns_.rows()).noalias() = columns_ * by_column;
  return out;
}

Eigen::VectorXd WayBack::transpose_times(const LineStep& own) const {
  if (columns_.rows() == 0) return all_.transpose() * own;
  const Eigen::Map<const Eigen::VectorXcd> given(reinterpret_cast<const Complex*>(own.data()), columns_.rows());
  const Eigen::VectorXcd by_column = columns_.adjoint() * given;
  Eigen::VectorXd out(at(unknowns_.size()));
  for (std::size_t i = 0; i < unknowns_.size(); ++i) out[at(i)] = (std::conj(unknowns_[i].factor) * by_column[unknowns_[i].column]).real();
  return out;
}

Eigen::MatrixXd WayBack::matrix() const {
  if (columns_.rows() == 0) return all_;
  const auto p = at(unknowns_.size());
  Eigen::MatrixXd out(2 * columns_.rows(), p);
  for (Eigen::Index i = 0; i < p; ++i) out.col(i) = times(Eigen::VectorXd::Unit(p, i));
  return out;
}

}  // namespace jointid::ident
