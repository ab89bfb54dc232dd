#include "ident/likelihood/findings/joint_part.hpp"

#include "base/eigen.hpp"
#include "dense/cholesky.hpp"

namespace jointid::ident {

Eigen::MatrixXd joint_information(const Eigen::MatrixXd& information, std::size_t joint) {
  const Eigen::Index p = at(joint), others = information.rows() - p;
  if (others == 0) return information;
  const Eigen::MatrixXd cross = information.bottomLeftCorner(others, p);
  const Eigen::MatrixXd left = information.topLeftCorner(p, p) -
                               cross.transpose() * dense::solve_positive(information.bottomRightCorner(others, others), cross);
  return 0.5 * (left + left.transpose());
}

LikelihoodFit joint_part(LikelihoodFit fit, std::size_t joint) {
  if (fit.theta.size() == joint) return fit;
  fit.theta.resize(joint);
  if (fit.information.size() > 0) fit.information = joint_information(fit.information, joint);
  for (LikelihoodFit::End& end : fit.ends) end.theta.resize(joint);
  return fit;
}

}  // namespace jointid::ident
