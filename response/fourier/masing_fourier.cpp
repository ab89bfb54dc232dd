#include "response/fourier/masing_fourier.hpp"

#include <cmath>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "response/fourier/stretch_integrals.hpp"

namespace jointid::response {
namespace {

/// δq_c and δF_c of a corner for changes of the motion's unknowns, and ∂F_c for those of the parameters.
struct CornerChange {
  Eigen::VectorXd displacement, force, parameters;
};

Eigen::VectorXd by_parameters(const friction::Element& element, double v, Eigen::Index count) {
  Eigen::VectorXd change(count);
  if (count > 0) element.derivative(v, std::span(change.data(), static_cast<std::size_t>(count)));
  return change;
}

/// δF_c = δF_parent + T′(v)(δq_c − δq_parent), ∂F_c = ∂F_parent + 2s∂T(v); on the initial curve T′(|q|)δq and s∂T(|q|).
std::vector<CornerChange> corner_changes(const friction::Element& element, const Motion& motion, const PeriodicPath& path,
                                         Eigen::Index parameters) {
  std::vector<CornerChange> changes;
  changes.reserve(path.corners.size());
  for (const PathCorner& corner : path.corners) {
    CornerChange change = {motion.by_unknowns(corner.theta), {}, {}};
    if (corner.parent < 0) {
      const double u = std::abs(corner.displacement);
      change.force = element.response(u).tangent * change.displacement;
      change.parameters = corner.direction * by_parameters(element, u, parameters);
    } else {
      const std::size_t parent = static_cast<std::size_t>(corner.parent);
      const double v = std::max(0.0, 0.5 * corner.direction * (corner.displacement - path.corners[parent].displacement));
      change.force = changes[parent].force + element.response(v).tangent * (change.displacement - changes[parent].displacement);
      change.parameters = changes[parent].parameters + 2.0 * corner.direction * by_parameters(element, v, parameters);
    }
    changes.push_back(std::move(change));
  }
  return changes;
}

/// ∫ T′ δq e^{−inθ} for δq = cos mθ and −sin mθ, from τ_k = ∫ T′ e^{−ikθ}: (τ_{n−m} + τ_{n+m})/2 and i(τ_{n−m} − τ_{n+m})/2.
void add_tangent(const Eigen::VectorXcd& tangent, const Harmonics& force, const Harmonics& motion, Eigen::MatrixXcd& by_motion) {
  const auto moment = [&](int k) { return k >= 0 ? tangent(k) : std::conj(tangent(-k)); };
  for (Eigen::Index m = 0; m < motion.size(); ++m) {
    for (Eigen::Index n = 0; n < force.size(); ++n) {
      const Complex less = moment(force[n] - motion[m]), more = moment(force[n] + motion[m]);
      by_motion(n, motion.offset(m)) += 0.5 * (less + more);
      if (motion[m] > 0) by_motion(n, motion.offset(m) + 1) += Complex(0.0, 0.5) * (less - more);
    }
  }
}

/// 1/π, of n = 0 1/(2π); from half a period of odd motion twice that for odd n and nothing for even n.
Eigen::VectorXd normalisation(const Harmonics& force, bool half) {
  Eigen::VectorXd factors(force.size());
  for (Eigen::Index i = 0; i < force.size(); ++i) {
    const double whole = (force[i] == 0 ? 0.5 : 1.0) / std::numbers::pi;
    factors(i) = half ? (force[i] % 2 == 1 ? 2.0 * whole : 0.0) : whole;
  }
  return factors;
}

/// The force of a joint at rest in q₀ is ±T(|q₀|); a small motion about it turns at once and meets T′(0).
ForceHarmonics at_rest(const friction::Element& element, const Motion& motion, const Harmonics& force, Eigen::Index parameters) {
  const Harmonics& moved = motion.harmonics();
  ForceHarmonics result;
  result.force.setZero(force.size());
  result.by_motion.setZero(force.size(), moved.unknowns());
  result.by_parameters.setZero(force.size(), parameters);
  const double mean = motion.value(0.0), sign = mean < 0.0 ? -1.0 : 1.0;
  for (Eigen::Index i = 0; i < force.size(); ++i) {
    const Eigen::Index m = moved.find(force[i]);
    if (force[i] == 0) {
      const friction::Response at = element.response(std::abs(mean));
      result.force(i) = sign * at.force;
      result.by_parameters.row(i) = sign * by_parameters(element, std::abs(mean), parameters).transpose();
      if (m >= 0) result.by_motion(i, moved.offset(m)) = at.tangent;
    } else if (m >= 0) {
      const double tangent = element.response(0.0).tangent;
      result.by_motion(i, moved.offset(m)) = tangent;
      result.by_motion(i, moved.offset(m) + 1) = Complex(0.0, tangent);
    }
  }
  return result;
}

}  // namespace

MasingFourier::MasingFourier(std::shared_ptr<const friction::Element> element)
    : element_(std::move(element)), levels_(*element_) {}

ForceHarmonics MasingFourier::evaluate(const Motion& motion, const Harmonics& force, bool with_parameters) const {
  const Eigen::Index parameters = with_parameters ? at(element_->parameters().size()) : 0;
  const PeriodicPath path = periodic_path(*element_, motion);
  if (path.corners.empty()) return at_rest(*element_, motion, force, parameters);

  const std::vector<CornerChange> changes = corner_changes(*element_, motion, path, parameters);
  const Harmonics& moved = motion.harmonics();
  ForceHarmonics result;
  result.reversals = path.reversals;
  result.force.setZero(force.size());
  result.by_motion.setZero(force.size(), moved.unknowns());
  result.by_parameters.setZero(force.size(), parameters);
  StretchIntegrator integrator(*element_, levels_, motion, force, with_parameters);
  Eigen::VectorXcd tangent = Eigen::VectorXcd::Zero(force.largest() + moved.largest() + 1);
  Eigen::VectorXcd of_force(force.size());
  for (const PathStretch& stretch : path.stretches) {
    const std::size_t c = static_cast<std::size_t>(stretch.corner);
    const StretchIntegrals integrals = integrator.integrate(stretch, path.corners[c]);
    result.force += path.corners[c].force * integrals.rotation + integrals.force;
    tangent += integrals.tangent;
    for (Eigen::Index i = 0; i < force.size(); ++i) of_force(i) = integrals.tangent(force[i]);
    result.by_motion += integrals.rotation * changes[c].force.transpose() - of_force * changes[c].displacement.transpose();
    result.by_parameters += integrals.rotation * changes[c].parameters.transpose() + integrals.parameters;
  }
  add_tangent(tangent, force, moved, result.by_motion);
  const Eigen::VectorXd factors = normalisation(force, path.half);
  result.force.array() *= factors.array();
  result.by_motion.array().colwise() *= factors.array().cast<Complex>();
  result.by_parameters.array().colwise() *= factors.array().cast<Complex>();
  return result;
}

}  // namespace jointid::response
