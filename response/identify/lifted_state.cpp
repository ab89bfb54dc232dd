#include "response/identify/lifted_state.hpp"

namespace jointid::response {

Eigen::MatrixXcd LiftedState::motion(const StateModel& model, const Eigen::MatrixXcd& force) {
  Eigen::MatrixXcd motion(force.rows(), force.cols());
  for (Eigen::Index n = 0; n < force.rows(); ++n) {
    const HarmonicLine::One& one = model.line().harmonics[static_cast<std::size_t>(n)];
    motion.row(n) = (one.driven - one.joints * force.row(n).transpose()).transpose();
  }
  return motion;
}

LiftedState::LiftedState(const StateModel& model, const std::vector<JointForce>& joints, const Eigen::MatrixXcd& force,
                         const Eigen::VectorXd& tolerance, bool with_derivatives)
    : model_(model), equations_(joints, model.harmonics()), force_(force), tolerance_(tolerance) {
  const Harmonics& harmonics = model.harmonics();
  const Eigen::Index size = harmonics.unknowns();
  const Eigen::MatrixXcd own = motion(model, force);
  weight_.resize(equations_.unknowns());
  if (with_derivatives) stiffness_.setZero(weight_.size(), weight_.size());
  for (Eigen::Index j = 0; j < force.cols(); ++j) {
    const JointForce& joint = equations_.joints()[static_cast<std::size_t>(j)];
    law_.push_back(joint.evaluate(Motion(harmonics, own.col(j)), model.line().omega, harmonics, with_derivatives));
    weight_.segment(j * size, size).setConstant(1.0 / tolerance(j));
    if (!with_derivatives) continue;
    for (Eigen::Index u = 0; u < size; ++u)
      stiffness_.col(j * size + u).segment(j * size, size) = harmonics.pack(law_.back().by_motion.col(u));
  }
}

Eigen::VectorXd LiftedState::residual() const {
  const Eigen::Index measured = measured_numbers(model_.state());
  Eigen::MatrixXcd missing = force_, response(force_.rows(), model_.state().response.cols());
  for (std::size_t j = 0; j < law_.size(); ++j) missing.col(at(j)) -= law_[j].force;
  for (Eigen::Index n = 0; n < force_.rows(); ++n) {
    const HarmonicLine::One& one = model_.line().harmonics[static_cast<std::size_t>(n)];
    response.row(n) = (one.free - one.to_joints * force_.row(n).transpose()).transpose();
  }
  Eigen::VectorXd rows(measured + weight_.size());
  rows << in_deviations(model_.state(), model_.measured(response) - model_.state().response),
      equations_.pack(missing).cwiseProduct(weight_);
  return rows;
}

void LiftedState::add_moved(Eigen::Index harmonic, const Eigen::MatrixXd& moved, Eigen::Ref<Eigen::MatrixXd> columns) const {
  const Harmonics& harmonics = model_.harmonics();
  const Eigen::Index joints = force_.cols(), size = harmonics.unknowns(), parts = harmonics[harmonic] > 0 ? 2 : 1;
  const Eigen::Index measured = columns.rows() - weight_.size();
  for (Eigen::Index j = 0; j < joints; ++j) {
    const auto own = stiffness_.block(j * size, j * size + harmonics.offset(harmonic), size, parts);
    columns.middleRows(measured + j * size, size) -= own * moved.middleRows(2 * j, parts) / tolerance_(j);
  }
  add_in_deviations(model_.state(), harmonics[harmonic], moved.bottomRows(moved.rows() - 2 * joints), columns.topRows(measured));
}

LiftedRows LiftedState::rows(const LawUnknowns& unknowns, const Eigen::VectorXd& slopes) const {
  const Harmonics& harmonics = model_.harmonics();
  const Eigen::Index joints = force_.cols(), measured = measured_numbers(model_.state()), size = harmonics.unknowns();
  LiftedRows out = {residual(), {}, Eigen::MatrixXd::Zero(measured + weight_.size(), weight_.size())};
  out.by_parameter.setZero(out.residual.size(), slopes.size());
  for (std::size_t i = 0; i < unknowns.moved().size(); ++i) {
    const auto [joint, parameter] = unknowns.moved()[i];
    const Eigen::Index row = measured + at(joint) * size, unknown = unknowns.moved_by()[i];
    const Eigen::VectorXd change = harmonics.pack(law_[joint].by_parameters.col(at(parameter)));
    out.by_parameter.col(unknown).segment(row, size) -= slopes(unknown) / tolerance_(at(joint)) * change;
  }
  for (Eigen::Index n = 0; n < harmonics.size(); ++n) {
    const HarmonicLine::One& one = model_.line().harmonics[static_cast<std::size_t>(n)];
    Eigen::MatrixXcd moved(joints + one.to_joints.rows(), joints);
    moved << -one.joints, -one.to_joints;
    Eigen::MatrixXd shares(2 * moved.rows(), 2 * joints);
    for (Eigen::Index i = 0; i < moved.rows(); ++i) {
      for (Eigen::Index j = 0; j < joints; ++j) {
        const Complex g = moved(i, j);
        shares.block<2, 2>(2 * i, 2 * j) << g.real(), -g.imag(), g.imag(), g.real();
      }
    }
    const Eigen::Index parts = harmonics[n] > 0 ? 2 : 1;
    for (Eigen::Index j = 0; j < joints; ++j)
      add_moved(n, shares.middleCols(2 * j, parts), out.by_force.middleCols(j * size + harmonics.offset(n), parts));
  }
  out.by_force.bottomRows(weight_.size()).diagonal() += weight_;
  return out;
}

Eigen::MatrixXd LiftedState::by_errors(int harmonic) const {
  const Eigen::Index n = model_.harmonics().find(harmonic);
  return moved_rows(n, model_.error_shares(harmonic, force_.row(n).transpose()));
}

Eigen::MatrixXd LiftedState::by_forces(int harmonic) const {
  return moved_rows(model_.harmonics().find(harmonic), model_.force_shares(harmonic));
}

Eigen::MatrixXd LiftedState::moved_rows(Eigen::Index harmonic, const Eigen::MatrixXd& shares) const {
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(measured_numbers(model_.state()) + weight_.size(), shares.cols());
  add_moved(harmonic, shares, columns);
  return columns;
}

}  // namespace jointid::response
