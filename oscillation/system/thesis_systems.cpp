#include "oscillation/system/thesis_systems.hpp"

#include <cmath>
#include <numbers>

#include "base/complex.hpp"
#include "base/error.hpp"
#include "dense/eigen.hpp"
#include "oscillation/measurement/beam_shapes.hpp"

namespace jointid::oscillation {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using oscillation::Deflection;

Deflection mode_at(const Cantilever& beam, Index j, double x) {
  return oscillation::deflection({oscillation::ShapeKind::mode, static_cast<std::size_t>(j) + 1}, beam.length, x);
}

/// The characteristic function of a clamped beam with a tip mass, over cosh z.
double tip_mass_function(double z, double mu) {
  const double t = std::tanh(z);
  return 1.0 / std::cosh(z) + std::cos(z) + mu * z * (std::cos(z) * t - std::sin(z));
}

}  // namespace

Mechanics mechanics(const BeltChain& chain) {
  if (chain.masses == 0) throw InputError({ErrorKind::usage, "", "masses", "are none", ""});
  const Index n = at(chain.masses);
  Mechanics out;
  out.mass = chain.mass * MatrixXd::Identity(n, n);
  out.stiffness = 2.0 * chain.stiffness * MatrixXd::Identity(n, n);
  out.stiffness(n - 1, n - 1) = chain.stiffness;
  for (Index i = 0; i + 1 < n; ++i) out.stiffness(i, i + 1) = out.stiffness(i + 1, i) = -chain.stiffness;
  out.damping = chain.damping * out.stiffness;
  out.contact = VectorXd::Unit(n, n - 1);
  return out;
}

ContactSystem contact_system(const BeltChain& chain) { return {mechanics(chain), {chain.velocity, 0.0, 0.0}, chain.friction}; }

double Cantilever::bending_stiffness() const { return youngs_modulus * width * std::pow(thickness, 3) / 12.0; }
double Cantilever::mass_per_length() const { return density * width * thickness; }
double Cantilever::tip_mass() const {
  return fixture_mass + extension_density * extension_free * extension_width * extension_thickness;
}

Mechanics mechanics(const Cantilever& beam) {
  if (beam.modes == 0) throw InputError({ErrorKind::usage, "", "modes", "are none", ""});
  const Index n = at(beam.modes);
  const std::vector<double> roots = oscillation::clamped_free_roots(beam.modes);
  VectorXd tip(n), slope(n), fourth(n);
  for (Index j = 0; j < n; ++j) {
    const Deflection end = mode_at(beam, j, beam.length);
    tip(j) = end.value, slope(j) = end.slope;
    fourth(j) = std::pow(roots[static_cast<std::size_t>(j)] / beam.length, 4);
  }
  Mechanics out;
  out.mass = beam.mass_per_length() * beam.length * MatrixXd::Identity(n, n) + beam.tip_mass() * tip * tip.transpose();
  out.stiffness = (beam.bending_stiffness() * beam.length * fourth).asDiagonal();
  out.damping = beam.damping * out.stiffness;
  out.contact = tip + beam.extension * slope;
  return out;
}

ContactSystem contact_system(const Cantilever& beam) {
  return {mechanics(beam), {0.0, beam.amplitude, angular(beam.frequency_hz)}, beam.friction};
}

VectorXd natural_frequencies(const Cantilever& beam) {
  const Mechanics m = mechanics(beam);
  return dense::symmetric_eigen(m.stiffness, m.mass).values.cwiseMax(0.0).cwiseSqrt() / (2.0 * std::numbers::pi);
}

double one_per_cent(const Cantilever& beam) { return 2.0 * 0.01 / angular(natural_frequencies(beam)(0)); }

VectorXd tip_mass_frequencies(const Cantilever& beam) {
  const double mu = beam.tip_mass() / (beam.mass_per_length() * beam.length);
  const std::vector<double> bare = oscillation::clamped_free_roots(beam.modes);
  VectorXd out(at(beam.modes));
  for (std::size_t j = 0; j < beam.modes;
       ++j) {  // one root between bare ones: mass lowers a frequency, but not below the one before
    double low = j == 0 ? 1e-3 : bare[j - 1], high = bare[j];
    const bool up = tip_mass_function(high, mu) > 0.0;
    for (int k = 0; k < 200 && low < high; ++k) {
      const double middle = 0.5 * (low + high);
      ((tip_mass_function(middle, mu) > 0.0) == up ? high : low) = middle;
    }
    const double z = 0.5 * (low + high) / beam.length;
    out(at(j)) = z * z * std::sqrt(beam.bending_stiffness() / beam.mass_per_length()) / (2.0 * std::numbers::pi);
  }
  return out;
}

Eigen::RowVectorXd displacement_row(const Cantilever& beam, double x) {
  Eigen::RowVectorXd row(at(beam.modes));
  for (Index j = 0; j < row.size(); ++j) row(j) = mode_at(beam, j, x).value;
  return row;
}

Eigen::RowVectorXd strain_row(const Cantilever& beam, double x) {
  Eigen::RowVectorXd row(at(beam.modes));
  for (Index j = 0; j < row.size(); ++j) row(j) = 0.5 * beam.thickness * mode_at(beam, j, x).curvature;
  return row;
}

}  // namespace jointid::oscillation
