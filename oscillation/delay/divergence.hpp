#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "oscillation/delay/embedding.hpp"
#include "oscillation/delay/plateau.hpp"

namespace jointid::oscillation {

struct DivergenceOptions {
  Embedding embedding;
  std::size_t theiler = 1;   ///< neighbours are |i − j| > this
  std::size_t steps = 50;    ///< the curve has steps + 1 points
  double sample_time = 1.0;  ///< s, > 0
};

/// S(t): how the mean logarithm of the distance of neighbours grows. Its slope, where it has one, is the largest exponent in nats
/// per second.
struct DivergenceCurve {
  std::size_t dimension = 0;
  double radius = 0.0;       ///< of Kantz; 0 for Rosenstein
  std::vector<double> time;  ///< s
  std::vector<double> mean_log;
};

/// Rosenstein, Collins & De Luca 1993: of every point's nearest neighbour, Euclidean in d coordinates.
DivergenceCurve rosenstein_curve(std::span<const double> x, const DivergenceOptions& options);

/// Kantz 1994: of the mean distance, in the last coordinate, of all neighbours within `radius`; points with fewer than 5 do not
/// count.
DivergenceCurve kantz_curve(std::span<const double> x, const DivergenceOptions& options, double radius);

/// The largest exponent as a record tells it: slopes of the curves of d, d + 1 and d + 2 on plateaus that agree within
/// `agreement` of their mean. Otherwise there is no number: a curve without a plateau has any slope one likes
/// (docs/oscillations.md).
struct RecordExponent {
  std::optional<double> nats_per_second;  ///< empty: not determined
  double spread = 0.0;                    ///< half the range of the slopes
  std::string reason;                     ///< why it is not determined
  std::vector<DivergenceCurve> curves;
  std::vector<std::optional<Plateau>> plateaus;  ///< one a curve
};
RecordExponent largest_exponent_rosenstein(std::span<const double> x, const DivergenceOptions& options,
                                           const PlateauOptions& plateau = {}, double agreement = 0.15);

/// The same of Kantz curves, for d, d + 1, d + 2 and the radii σ/10 and σ/5.
RecordExponent largest_exponent_kantz(std::span<const double> x, const DivergenceOptions& options,
                                      const PlateauOptions& plateau = {}, double agreement = 0.15);

}  // namespace jointid::oscillation
