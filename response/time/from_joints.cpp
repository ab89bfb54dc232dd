#include "response/time/from_joints.hpp"

#include "base/eigen.hpp"
#include "base/error.hpp"

namespace jointid::response {

std::vector<std::size_t> friction_joints(const std::vector<Joint>& joints) {
  std::vector<std::size_t> found;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    if (joints[j].friction) found.push_back(j);
  }
  return found;
}

JointedStructure from_joints(const MatrixStructure& structure, const Eigen::MatrixXd& w, const std::vector<Joint>& joints) {
  JointedStructure all;
  all.matrices = structure;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const Joint& joint = joints[j];
    if (joint.cubic != 0.0) {
      throw InputError({.kind = ErrorKind::usage,
                        .file = "",
                        .place = "joint " + joint.name,
                        .problem = "has a cubic spring, which time marching does not know",
                        .remedy = "leave cubic out, or do not ask for stability, transients or a comparison"});
    }
    const Eigen::VectorXd column = w.col(at(j));
    all.matrices.stiffness += joint.stiffness * column * column.transpose();
    all.matrices.damping += joint.damping * column * column.transpose();
  }
  const std::vector<std::size_t> friction = friction_joints(joints);
  all.incidence.resize(w.rows(), at(friction.size()));
  for (std::size_t i = 0; i < friction.size(); ++i) {
    all.incidence.col(at(i)) = w.col(at(friction[i]));
    all.laws.push_back(joints[friction[i]].friction);
  }
  return all;
}

}  // namespace jointid::response
