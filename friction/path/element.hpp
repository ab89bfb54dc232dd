#pragma once

#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace jointid::friction {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

struct Response {
  double force = 0.0;    ///< T(u)
  double tangent = 0.0;  ///< dT/du
};

/// A parameter of a law and the interval where it makes sense. Bounds themselves are outside, unless lower_included.
struct Parameter {
  std::string name;
  std::string unit;
  double value = 0.0;
  double lower = 0.0;
  double upper = infinity;
  bool lower_included = false;
};

/// The initial loading law T(u) of a joint in the tangential direction, u ≥ 0 (docs/formulas.md §10): T(0) = 0, T increasing,
/// dT/du decreasing. Its odd continuation and Masing's rule give every other path (masing_path.hpp). Units are SI; they
/// are N and m for a translational joint, N·m and rad for a rotary one, N/m² and m for a law per area.
/// No argument is checked but by constructors; u must be ≥ 0.
class Element {
 public:
  virtual ~Element() = default;

  /// T(u) and dT/du; where dT/du jumps, its right limit.
  virtual Response response(double u) const = 0;

  /// ∫₀^u T du.
  virtual double energy(double u) const = 0;

  /// Smallest u with T(u) = force ≥ 0; +infinity when no u reaches it.
  virtual double displacement(double force) const;

  /// Force at macroslip, lim T(u); +infinity when there is none.
  virtual double limit() const = 0;

  /// Displacements u > 0 where T is not analytic (begin of slip, macroslip), increasing. Quadratures split there.
  virtual std::vector<double> kinks() const { return {}; }

  virtual std::vector<Parameter> parameters() const = 0;

  /// ∂T(u)/∂p, one for each parameter.
  virtual void derivative(double u, std::span<double> out) const = 0;

  /// True where `with` has a law of these values: one for each parameter, finite and inside its bounds.
  virtual bool admits(std::span<const double> values) const;

  /// The same law with other parameter values. Throws InputError where it does not admit them.
  virtual std::unique_ptr<Element> with(std::span<const double> values) const = 0;

  /// Energy lost in one cycle between −u and u, E = 8∫₀^u T du − 4uT(u) (2.10).
  virtual double cycle_energy(double u) const;

  /// First harmonic in phase under x = u cos ωt over u: k_e = (2/π)∫₀^π T′(u(1−cos θ)/2) sin²θ dθ, which is (B.4) integrated
  /// by parts. u > 0.
  virtual double equivalent_stiffness(double u) const;

  /// ∫₀^u v²T(v) dv, what a rotary joint sums over its radius (2.65).
  virtual double second_moment(double u) const;

  /// ∂/∂p of second_moment, one for each parameter.
  virtual void second_moment_derivative(double u, std::span<double> out) const;

  std::vector<double> values() const;
  std::unique_ptr<Element> clone() const { return with(values()); }
};

}  // namespace jointid::friction
