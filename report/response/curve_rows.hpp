#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tasks/response/response_result.hpp"

namespace jointid::report {

/// What a row is of: a point of a curve, one where it turns back, one where |X| is largest.
enum class CurvePlace { point, turning_point, peak };
inline constexpr std::array<std::string_view, 3> curve_places = {"point", "turning point", "peak"};

/// A harmonic of a response on a curve.
struct CurveRow {
  std::size_t curve = 0;  ///< 0: the peaks of the levels over the force (backbone); from 1: [[curves]]
  CurvePlace place = CurvePlace::point;
  double parameter = 0.0;  ///< what the curve is along: N, or the unit of the joint's parameter
  double force = 0.0, frequency_hz = 0.0;
  int harmonic = 1;
  std::size_t dof = 0;
  Complex x;
  double loss = 0.0;                ///< J a period
  std::optional<double> damping{};  ///< of peaks over the force, share of critical damping
};

/// Names of the curves, by number.
std::vector<std::string> curve_names(const tasks::ResponseResult& run);

std::vector<CurveRow> curve_rows(const tasks::ResponseResult& run);

/// Curve by name, place in words, parameter, force, frequency, harmonic, response, re, im, loss, damping.
std::string curves_csv(const tasks::ResponseResult& run);

}  // namespace jointid::report
