#include "response/fourier/stretch_integrals.hpp"

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <complex>

namespace jointid::response {
namespace {

constexpr double longest_angle = 3.0;  ///< of the largest harmonic in a piece, rad
constexpr double corner_angle = 0.5;   ///< in the piece at a corner
constexpr int grading = 4;

struct Node {
  double place = 0.0, weight = 0.0;  ///< in [0, 1]
};

const std::array<Node, 20>& nodes() {
  static const std::array<Node, 20> all = [] {
    using Rule = boost::math::quadrature::gauss<double, 20>;
    std::array<Node, 20> found;
    for (std::size_t i = 0; i < 10; ++i) {
      const double x = 0.5 * Rule::abscissa()[i], weight = 0.5 * Rule::weights()[i];
      found[2 * i] = {0.5 - x, weight};
      found[2 * i + 1] = {0.5 + x, weight};
    }
    return found;
  }();
  return all;
}

}  // namespace

/// One stretch with the displacements v = s(q − q_c)/2 along it.
struct StretchIntegrator::Travel {
  const Motion& motion;
  const PathCorner& corner;
  double sign;

  double of(double q) const { return std::max(0.0, 0.5 * sign * (q - corner.displacement)); }
  double at(double theta) const { return of(motion.value(theta)); }
  double displacement(double v) const { return corner.displacement + 2.0 * sign * v; }
};

StretchIntegrator::StretchIntegrator(const friction::Element& element, const LoadingLevels& levels, const Motion& motion,
                                     const Harmonics& force, bool with_parameters)
    : element_(element),
      levels_(levels),
      motion_(motion),
      force_(force),
      longest_(longest_angle / std::max(motion.harmonics().largest(), force.largest())) {
  powers_.resize(static_cast<std::size_t>(motion.harmonics().largest() + force.largest() + 1));
  ends_.resize(powers_.size());
  if (with_parameters) by_parameter_.resize(element.parameters().size());
  parameters_ = jointid::at(by_parameter_.size());
}

StretchIntegrals StretchIntegrator::integrate(const PathStretch& stretch, const PathCorner& corner) {
  sum_.force.setZero(force_.size());
  sum_.tangent.setZero(jointid::at(powers_.size()));
  sum_.parameters.setZero(force_.size(), parameters_);
  sum_.rotation.resize(force_.size());
  fill_powers(stretch.from, powers_);
  fill_powers(stretch.to, ends_);
  for (Eigen::Index i = 0; i < force_.size(); ++i) {
    const std::size_t n = static_cast<std::size_t>(force_[i]);
    const Complex change = std::conj(ends_[n] - powers_[n]);
    sum_.rotation(i) =
        n == 0 ? Complex(stretch.to - stretch.from) : Complex(-change.imag(), change.real()) / static_cast<double>(n);
  }
  const Travel travel = {motion_, corner, static_cast<double>(stretch.direction)};
  double from = stretch.from;
  const bool at_corner = stretch.from == corner.theta;
  for (const double level : levels_.between(at_corner ? 0.0 : travel.at(stretch.from), travel.at(stretch.to))) {
    const double to = motion_.crossing(from, stretch.to, travel.displacement(level));
    piece(travel, from, to, at_corner && from == stretch.from);
    from = to;
  }
  piece(travel, from, stretch.to, at_corner && from == stretch.from);
  return sum_;
}

/// T is analytic between `from` and `to`, and T′ falls: where it is the same near both ends, T is linear.
void StretchIntegrator::piece(const Travel& travel, double from, double to, bool at_corner) {
  if (!(to > from)) return;
  const double low = travel.at(from), high = travel.at(to), margin = 0.01 * (high - low);
  const double tangent = element_.response(low + margin).tangent;
  if (tangent == element_.response(high - margin).tangent) return linear_piece(travel, from, to, tangent);
  if (at_corner) {
    const double first = std::min(to, from + corner_angle / 3.0 * longest_);
    gauss(travel, from, first, true);
    for (double begin = first; begin < to;) {
      const double end = std::min({to, begin + longest_, begin + (begin - from)});
      gauss(travel, begin, end, false);
      begin = end;
    }
    return;
  }
  const int pieces = static_cast<int>(std::ceil((to - from) / longest_));
  const double width = (to - from) / pieces;
  for (int i = 0; i < pieces; ++i) gauss(travel, from + i * width, i + 1 == pieces ? to : from + (i + 1) * width, false);
}

/// 2sT(v) = 2s(T(v₀) − T′v₀) − T′q_c + T′q, so that every integral is one of e^{−ikθ}.
void StretchIntegrator::linear_piece(const Travel& travel, double from, double to, double tangent) {
  fill_powers(from, powers_);
  fill_powers(to, ends_);
  const auto rotation = [&](int k) -> Complex {
    if (k == 0) return to - from;
    const std::size_t size = static_cast<std::size_t>(std::abs(k));
    const Complex change = ends_[size] - powers_[size];
    const Complex integral = Complex(change.imag(), change.real()) / static_cast<double>(size);  // of e^{−i|k|θ}
    return k > 0 ? integral : std::conj(integral);
  };
  const double v = travel.at(0.5 * (from + to)), force = element_.response(v).force;
  const double constant = 2.0 * travel.sign * (force - tangent * v) - tangent * travel.corner.displacement;
  for (Eigen::Index i = 0; i < force_.size(); ++i) sum_.force(i) += constant * rotation(force_[i]);
  if (tangent == 0.0 && parameters_ == 0) return;
  const Harmonics& motion = motion_.harmonics();
  Eigen::VectorXcd moved = Eigen::VectorXcd::Zero(force_.size()), turned(force_.size());  // of q and 1
  for (Eigen::Index i = 0; i < force_.size(); ++i) {
    turned(i) = rotation(force_[i]);
    for (Eigen::Index m = 0; m < motion.size(); ++m) {
      const Complex amplitude = motion_.amplitudes()(m);
      moved(i) += 0.5 * (amplitude * rotation(force_[i] - motion[m]) + std::conj(amplitude) * rotation(force_[i] + motion[m]));
    }
  }
  sum_.force += tangent * moved;
  if (parameters_ > 0) linear_parameters(travel, travel.at(from), travel.at(to), moved, turned);
  if (tangent == 0.0) return;
  for (Eigen::Index k = 0; k < sum_.tangent.size(); ++k) sum_.tangent(k) += tangent * rotation(static_cast<int>(k));
}

/// Where T is linear, ∂T/∂p = c + dv is as well: 2s∂T/∂p = 2sc − dq_c + dq.
void StretchIntegrator::linear_parameters(const Travel& travel, double low, double high, const Eigen::VectorXcd& moved,
                                          const Eigen::VectorXcd& turned) {
  const double margin = 0.01 * (high - low), first = low + margin, last = high - margin;
  std::vector<double> at_first(by_parameter_.size());
  element_.derivative(first, at_first);
  element_.derivative(last, by_parameter_);
  for (Eigen::Index p = 0; p < parameters_; ++p) {
    const std::size_t at_p = static_cast<std::size_t>(p);
    const double slope = last > first ? (by_parameter_[at_p] - at_first[at_p]) / (last - first) : 0.0;
    const double value = at_first[at_p] - slope * first;
    sum_.parameters.col(p) +=
        (2.0 * travel.sign * value - slope * travel.corner.displacement) * turned + slope * moved;
  }
}

void StretchIntegrator::gauss(const Travel& travel, double from, double to, bool graded) {
  const double width = to - from;
  for (const Node& node : nodes()) {
    if (graded) {
      const double before = std::pow(node.place, grading - 1);
      add_point(travel, from + width * before * node.place, width * grading * before * node.weight);
    } else {
      add_point(travel, from + width * node.place, width * node.weight);
    }
  }
}

/// q at the angle whose powers e^{ikθ} are in powers_.
double StretchIntegrator::displacement_now() const {
  double q = 0.0;
  for (Eigen::Index m = 0; m < motion_.harmonics().size(); ++m) {
    const Complex amplitude = motion_.amplitudes()(m), power = powers_[static_cast<std::size_t>(motion_.harmonics()[m])];
    q += amplitude.real() * power.real() - amplitude.imag() * power.imag();
  }
  return q;
}

void StretchIntegrator::add_point(const Travel& travel, double theta, double weight) {
  fill_powers(theta, powers_);
  const double v = travel.of(displacement_now());
  const friction::Response at = element_.response(v);
  const double force = 2.0 * travel.sign * weight * at.force, tangent = weight * at.tangent;
  for (Eigen::Index i = 0; i < force_.size(); ++i)
    sum_.force(i) += force * std::conj(powers_[static_cast<std::size_t>(force_[i])]);
  if (tangent != 0.0) {
    for (Eigen::Index k = 0; k < sum_.tangent.size(); ++k)
      sum_.tangent(k) += tangent * std::conj(powers_[static_cast<std::size_t>(k)]);
  }
  if (parameters_ == 0) return;
  element_.derivative(v, by_parameter_);
  for (Eigen::Index i = 0; i < force_.size(); ++i) {
    const Complex factor = 2.0 * travel.sign * weight * std::conj(powers_[static_cast<std::size_t>(force_[i])]);
    for (Eigen::Index p = 0; p < parameters_; ++p) sum_.parameters(i, p) += factor * by_parameter_[static_cast<std::size_t>(p)];
  }
}

}  // namespace jointid::response
