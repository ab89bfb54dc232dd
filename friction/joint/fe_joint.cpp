#include "friction/joint/fe_joint.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <optional>

#include "base/eigen.hpp"
#include "base/error.hpp"
#include "friction/joint/fe_matrices.hpp"
#include "friction/path/masing_path.hpp"
#include "friction/path/scaled.hpp"

namespace jointid::friction {
namespace {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::SparseMatrix<double>;

void check(bool valid, const std::string& text) {
  if (!valid) refuse("finite-element joint: " + text);
}

void check(const JointMesh& mesh) {
  check(!mesh.members.empty(), "no members");
  check(mesh.interface.size() == mesh.members.size() + 1, "one interface law for each node is needed");
  for (const Member& member : mesh.members) {
    check(member.length > 0.0 && member.stiffness > 0.0, "lengths and stiffnesses must be > 0");
  }
  check(mesh.end_spring >= 0.0 && std::isfinite(mesh.end_spring), "the end spring must be finite and >= 0");
  const auto contacts = std::ranges::count_if(mesh.interface, [](const auto& law) { return law != nullptr; });
  check(contacts >= (mesh.kind == MemberKind::bar ? 1 : 2) || mesh.end_spring > 0.0, "nothing holds it");
}

}  // namespace

class FiniteElementJoint::Solver {
 public:
  Solver(const JointMesh& mesh, const EquilibriumControl& control)
      : control_(control), stride_(mesh.kind == MemberKind::bar ? 1 : 2), members_(member_matrix(mesh)), magnitudes_(members_.cwiseAbs()) {
    for (std::size_t node = 0; node < mesh.interface.size(); ++node) {
      if (!mesh.interface[node]) continue;
      laws_.push_back(std::make_unique<Scaled>(mesh.interface[node], tributary_length(mesh, node)));
      paths_.emplace_back(*laws_.back());
      contact_.push_back(at(node) * stride_);
    }
    loaded_ = members_.rows() - stride_;
    state_ = Vector::Zero(members_.rows());
    factor_.analyzePattern(members_);
  }

  EquilibriumStep go(double target, bool moves) {
    EquilibriumStep done;
    const double start = moves ? state_[loaded_] : force_;
    double reached = 0.0, step = 1.0;
    while (reached < 1.0) {
      const double next = std::min(reached + step, 1.0);
      const double goal = next == 1.0 ? target : start + next * (target - start);
      const auto found = equilibrium(goal, moves, done.iterations);
      if (found) {
        commit(*found, goal, moves);
        reached = next;
        step *= 2.0;
        ++done.steps;
        continue;
      }
      step *= 0.5;
      if (step < control_.smallest_step) {
        done.found = false;
        break;
      }
    }
    done.force = force_;
    done.displacement = state_[loaded_];
    return done;
  }

  std::vector<double> displacements() const {
    std::vector<double> result;
    for (Eigen::Index i = 0; i < state_.size(); i += stride_) result.push_back(state_[i]);
    return result;
  }

  std::vector<double> interface_forces() const {
    std::vector<double> result(static_cast<std::size_t>(state_.size() / stride_), 0.0);
    for (std::size_t i = 0; i < paths_.size(); ++i) {
      result[static_cast<std::size_t>(contact_[i] / stride_)] = paths_[i].force();
    }
    return result;
  }

 private:
  struct Forces {
    Vector total;          ///< of members and interface
    Vector stiffness;      ///< of the interface, on the diagonal
    double largest = 0.0;  ///< force of a node of the interface
  };

  Forces forces(const Vector& u) const {
    Forces result = {members_ * u, Vector::Zero(u.size())};
    for (std::size_t i = 0; i < paths_.size(); ++i) {
      const Response at = paths_[i].response(u[contact_[i]]);
      // Where a node has not moved it may go either way: the stiffer one keeps the matrix regular.
      const bool rests = u[contact_[i]] == paths_[i].displacement();
      result.stiffness[contact_[i]] = rests ? laws_[i]->response(0.0).tangent : at.tangent;
      result.total[contact_[i]] += at.force;
      result.largest = std::max(result.largest, std::abs(at.force));
    }
    return result;
  }

  /// Residual of an equilibrium: the tolerance, and rounding of member forces that cancel, as long as that is small.
  double allowed(const Forces& at, const Vector& u, double load) const {
    const double scale = std::max(at.largest, load);
    const double rounding = 1e-15 * (magnitudes_ * u.cwiseAbs()).maxCoeff();
    return control_.tolerance * scale + std::min(rounding, 1e-6 * scale);
  }

  /// What is left of the load, zero at the loaded node when its displacement is given.
  Vector residual(const Forces& forces, double goal, bool moves) const {
    Vector left = -forces.total;
    if (moves) {
      left[loaded_] = 0.0;
    } else {
      left[loaded_] += goal;
    }
    return left;
  }

  Vector direction(const Forces& at, const Vector& left, bool moves) {
    Matrix tangent = members_;
    // Below rounding of the members: only there to keep the matrix regular when all nodes slip.
    tangent.diagonal() += at.stiffness + 1e-14 * members_.diagonal();
    if (moves) tangent.coeffRef(loaded_, loaded_) += 1e8 * tangent.diagonal().maxCoeff();
    factor_.factorize(tangent);
    Vector step = factor_.solve(left);
    if (moves) step[loaded_] = 0.0;
    return step;
  }

  /// Along the step the potential is convex, its slope −stepᵀ·residual rises: full step when the slope has become small, else
  /// where a regula falsi finds it small.
  double line_search(const Vector& u, const Vector& step, const Vector& left, double goal, bool moves) const {
    const double start = step.dot(left);
    double low = 0.0, at_low = start, high = 1.0;
    double at_high = step.dot(residual(forces(u + step), goal, moves));
    if (std::abs(at_high) <= 0.5 * std::abs(start)) return 1.0;
    if (at_high > 0.0) return 1.0;
    double alpha = 0.5;
    for (int i = 0; i < 20; ++i) {
      alpha = low + std::clamp(at_low / (at_low - at_high), 0.1, 0.9) * (high - low);
      const double slope = step.dot(residual(forces(u + alpha * step), goal, moves));
      if (std::abs(slope) <= 0.5 * std::abs(start)) break;
      (slope > 0.0 ? low : high) = alpha;
      (slope > 0.0 ? at_low : at_high) = slope;
    }
    return alpha;
  }

  std::optional<Vector> equilibrium(double goal, bool moves, int& iterations) {
    Vector u = state_;
    double first = 0.0;
    if (moves) u[loaded_] = goal;
    for (int i = 0; i < control_.iterations; ++i) {
      const Forces at = forces(u);
      const Vector left = residual(at, goal, moves);
      if (left.cwiseAbs().maxCoeff() <= allowed(at, u, moves ? 0.0 : std::abs(goal))) return u;
      ++iterations;
      const Vector step = direction(at, left, moves);
      const double size = step.cwiseAbs().maxCoeff();
      if (i == 0) first = size;
      if (!(size <= 1e8 * first)) return std::nullopt;  // everything slips: only the regularisation holds it
      u += line_search(u, step, left, goal, moves) * step;
    }
    return std::nullopt;
  }

  void commit(const Vector& u, double goal, bool moves) {
    force_ = moves ? forces(u).total[loaded_] : goal;
    for (std::size_t i = 0; i < paths_.size(); ++i) paths_[i].advance(u[contact_[i]]);
    state_ = u;
  }

  EquilibriumControl control_;
  Eigen::Index stride_;
  Matrix members_, magnitudes_;
  std::vector<std::unique_ptr<Element>> laws_;
  std::vector<MasingPath> paths_;
  std::vector<Eigen::Index> contact_;
  Eigen::Index loaded_ = 0;
  Vector state_;
  double force_ = 0.0;
  Eigen::SimplicialLDLT<Matrix> factor_;
};

FiniteElementJoint::FiniteElementJoint(JointMesh mesh, const EquilibriumControl& control) {
  check(mesh);
  solver_ = std::make_unique<Solver>(mesh, control);
}

FiniteElementJoint::~FiniteElementJoint() = default;
FiniteElementJoint::FiniteElementJoint(FiniteElementJoint&&) noexcept = default;
FiniteElementJoint& FiniteElementJoint::operator=(FiniteElementJoint&&) noexcept = default;

EquilibriumStep FiniteElementJoint::load_to(double force) { return solver_->go(force, false); }
EquilibriumStep FiniteElementJoint::move_to(double displacement) { return solver_->go(displacement, true); }
std::vector<double> FiniteElementJoint::displacements() const { return solver_->displacements(); }
std::vector<double> FiniteElementJoint::interface_forces() const { return solver_->interface_forces(); }

}  // namespace jointid::friction
