#include "response/time/from_joints.hpp"

#include "base/eigen.hpp"
#include "response/joint/cubic_spring.hpp"

namespace jointid::response {

std::vector<std::size_t> friction_joints(const std::vector<Joint>& joints) {
  std::vector<std::size_t> found;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    if (joints[j].friction) found.push_back(j);
  }
  return found;
}

std::vector<std::size_t> cubic_joints(const std::vector<Joint>& joints) {
  std::vector<std::size_t> found;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    if (joints[j].cubic != 0.0) found.push_back(j);
  }
  return found;
}

JointedStructure from_joints(const MatrixStructure& structure, const Eigen::MatrixXd& w, const std::vector<Joint>& joints) {
  JointedStructure all;
  all.matrices = structure;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const Joint& joint = joints[j];
    const Eigen::VectorXd column = w.col(at(j));
    all.matrices.stiffness += joint.stiffness * column * column.transpose();
    all.matrices.damping += joint.damping * column * column.transpose();
  }
  const std::vector<std::size_t> friction = friction_joints(joints), springs = cubic_joints(joints);
  all.incidence.resize(w.rows(), at(friction.size() + springs.size()));
  for (const std::size_t j : friction) {
    all.incidence.col(at(all.laws.size())) = w.col(at(j));
    all.laws.push_back(joints[j].friction);
  }
  for (const std::size_t j : springs) {
    all.incidence.col(at(all.laws.size())) = w.col(at(j));
    all.laws.push_back(std::make_shared<CubicSpring>(joints[j].cubic));
  }
  return all;
}

}  // namespace jointid::response
