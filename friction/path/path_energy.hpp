#pragma once

#include "friction/path/masing_path.hpp"

namespace jointid::friction {

/// Energies along a Masing path, from closed forms on every branch: exact for any history and any step size.
/// With x = |u − u_c|/2 from a corner (u_c, F_c): work F_c(u − u_c) + 4∫₀^x T, loss half of the energy of a cycle of
/// amplitude x; on the initial curve ∫₀^u T and a quarter.
class PathEnergy {
 public:
  explicit PathEnergy(const Element& element) : path_(element) {}

  /// Moves the path to u without turning on the way.
  Response advance(double u);

  const MasingPath& path() const { return path_; }
  double work() const { return work_; }               ///< ∫ F du
  double loss() const { return loss_; }               ///< turned into heat
  double stored() const { return work_ - loss_; }     ///< elastic

 private:
  void add(const Branch& branch, double u, double sign);

  MasingPath path_;
  double work_ = 0.0, loss_ = 0.0;
};

}  // namespace jointid::friction
