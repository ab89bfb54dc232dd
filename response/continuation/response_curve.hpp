#pragma once

#include <optional>
#include <vector>

#include "response/continuation/arc_length.hpp"
#include "response/harmonic/harmonic_balance.hpp"

namespace jointid::response {

/// Parameter of a curve of periodic responses. The others stay as given.
enum class Along { frequency, level, joint_parameter };

struct CurveRequest {
  Along along = Along::frequency;
  double from = 0.0, to = 0.0;      ///< ω (rad/s), factor of the forces, or value of the parameter
  double omega = 0.0, level = 1.0;  ///< of the constant ones
  JointParameter parameter{};       ///< for Along::joint_parameter
  Eigen::Index response = 0;        ///< whose peaks of |X_n| are found
  int harmonic = 1;
  double longest_step = 0.05;  ///< of the arc length, in widths of the interval
};

struct ResponseCurve {
  std::vector<HarmonicSolution> points;
  std::vector<double> parameters;                ///< ω, level or parameter of each point
  std::vector<HarmonicSolution> turning_points;  ///< where the curve turns back, refined
  std::vector<double> turning_parameters;
  std::vector<HarmonicSolution> peaks;  ///< extremes of |X_n| of the response along the curve, maxima, refined
  std::vector<double> peak_parameters;
  CurveEnd end = CurveEnd::reached;
};

/// Follows periodic responses by arc length around their turning points, with the harmonics of the start (fixed, or added there).
/// Throws InputError if the structure is known at single lines only and the curve is along frequency.
ResponseCurve follow_response(const HarmonicBalance& balance, const CurveRequest& request);

/// The maximum of |X_n| nearest to a solution, over frequency. The curve is followed from there up or down by at most `width`
/// (share of its frequency) each way. Empty if there is no maximum. `level` may differ a little from that of the solution: peaks
/// are followed over force levels.
std::optional<HarmonicSolution> peak_near(const HarmonicBalance& balance, const HarmonicSolution& solution, double level,
                                          Eigen::Index response, int harmonic = 1, double width = 0.2);

/// Peaks over force levels (backbone), each followed from the one before; it ends at the first level without one.
std::vector<HarmonicSolution> follow_peak(const HarmonicBalance& balance, const HarmonicSolution& first,
                                          const std::vector<double>& levels, Eigen::Index response, int harmonic = 1);

}  // namespace jointid::response
