#pragma once

#include <optional>
#include <vector>

#include "frf/set/frf_set.hpp"

namespace jointid::correlation {

/// A response or reference of measured FRFs beside a model of the same structure.
struct ChannelBeside {
  frf::Dof dof;
  bool is_reference = false;
  double factor = 1.0;     ///< measured over model, its sign included; of a response relative to the others
  double agreement = 0.0;  ///< 0…1, of its part of the shapes; of a reference the part of the lines at which its sign is that of `factor`
  /// Of a response that agrees little: the coordinate of the model that it agrees with best, signed so that they are in phase.
  std::optional<frf::Dof> alike;
  double agreement_alike = 0.0;
};

/// Measured FRFs beside those of a model.
struct SetBeside {
  std::vector<ChannelBeside> channels;  ///< responses, then references, that the model has
  double agreement = 0.0;               ///< median of the responses
  double factor = 1.0;                  ///< measured over model, median over lines and references
  double slope = 0.0;                   ///< of log |factor| over log ω: −1 for a mobility taken for a receptance …
  double frequency_ratio = 1.0;         ///< model over measured, of the lines that are alike
};

/// Compares channel by channel. A model's resonances are off by some per cent, so that FRFs are not compared line by line: each measured
/// line is held against the line of the model within `shift` of its frequency whose column of FRFs is most alike (fdac()), and what is
/// left is the share of each response in that shape. `model` has all of its coordinates and lines beyond the measured band.
/// Throws InputError (data) where fewer than three responses or no reference are common.
SetBeside beside_model(const frf::FrfSet& measured, const frf::FrfSet& model, double shift = 0.1);

}  // namespace jointid::correlation
