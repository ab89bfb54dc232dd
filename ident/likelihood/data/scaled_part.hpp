#pragma once

#include <Eigen/Core>
#include <memory>
#include <mutex>

#include "base/complex.hpp"
#include "frf/set/frf_system.hpp"
#include "ident/plan/scene_source.hpp"

namespace jointid::ident {

/// FRFs of a part that is a model, with other stiffness and mass: K, D and residual flexibility go with e^s, M with e^m, and C
/// with the root of both, so that loss factors and damping ratios stay. Then H(ω; s, m) = e^−s H(ω e^((m − s)/2)), exactly.
class ScaledPart {
 public:
  struct Range {
    double low_hz, high_hz;
  };

  /// Between coordinates of the part. The lines of `expected` are prepared for at once.
  ScaledPart(const DataFile& file, const std::vector<frf::Dof>& coordinates, Range expected);

  struct Values {
    Eigen::MatrixXcd h, by_stiffness, by_mass;  ///< derivatives by s and m
  };
  /// By any thread.
  Values at(double frequency_hz, double stiffness, double mass);

 private:
  /// [line, row, column]
  std::vector<Complex> read(const std::vector<double>& frequency_hz) const;

  ModelFrfs frfs_;
  std::vector<frf::Dof> coordinates_;
  std::mutex one_at_a_time_;  ///< models are not for several threads
};

}  // namespace jointid::ident
