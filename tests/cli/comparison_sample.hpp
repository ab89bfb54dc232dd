#pragma once

#include <cmath>

#include "report/result/comparison_text.hpp"

namespace jointid::cli {

inline study::Combination sample_combination(double delta, double error, bool front) {
  study::Combination out;
  out.way = {ident::Method::one, {ident::Equation::nn}, weighting::Weighting::wbs, delta, ident::Solver::qr};
  out.matrices.push_back({.kind = restrictions::Kind::stiffness,
                          .rjcf = {0.1, 0.9876, 1.0},
                          .arvf = {0.5, 1.0123, 1.5},
                          .rms_relative_error = {error, error, NAN},
                          .bias = 0.25,
                          .on_front = front});
  out.statuses[ident::Status::ok] = 7;
  out.solve_s = 0.002;
  out.accumulator_bytes = 4000;
  return out;
}

/// Two values of Δ, the second better, and a way that was left out.
inline tasks::ComparisonResult sample_comparison() {
  tasks::ComparisonResult report{"title", 7, 3, {}};
  report.comparison.combinations = {sample_combination(0.0, 0.5, false), sample_combination(0.05, 0.3, true)};
  report.comparison.left_out.push_back({{ident::Method::two, {}, weighting::Weighting::wb, 0.0, ident::Solver::qr}, "no such block"});
  return report;
}

}  // namespace jointid::cli
