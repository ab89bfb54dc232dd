#pragma once

#include <functional>
#include <vector>

#include "response/time/algorithm_two.hpp"
#include "response/time/force_history.hpp"
#include "response/time/jointed_structure.hpp"

namespace jointid::response {

enum class TransientMethod {
  exact,
  algorithm_one,
  algorithm_two,
  newmark  ///< Algorithm One's equations by direct iteration (3.21)
};

/// Motion from rest at t = 0, told every `step` s.
struct TransientRequest {
  double duration = 0.0, step = 0.0;  ///< s
  TransientMethod method = TransientMethod::exact;
  double delta = 0.0;                          ///< time step of the algorithms, a whole part of `step`
  Eigen::MatrixXd responses{};                 ///< N × R: Rᵀx is told
  std::vector<NormalLoad> loads{};             ///< of the algorithms: one for each joint, or none
  AlgorithmTwoOptions two{};                   ///< of Algorithm Two; its loads are those above
  std::function<void(double time)> advance{};  ///< called before each step; what it throws ends the march
};

struct Transient {
  bool complete = true;  ///< false: event-exact marching stalled, or an algorithm grew beyond numbers or its iteration diverged;
                         ///< the motion is that until then
  std::vector<double> times;
  Eigen::MatrixXd x;                     ///< [time, response], m
  Eigen::MatrixXd q, f;                  ///< [time, joint], m and N
  std::size_t events = 0;                ///< event-exact marching
  std::vector<Eigen::Index> too_soft{};  ///< joints with which Algorithm Two may be boundedly unstable
  double growth = 0.0;                   ///< of Algorithm Two with every joint sticking: above 1 is unstable
};

/// Throws InputError for input that does not fit (check()).
Transient march_transient(const JointedStructure& structure, const ForceHistory& force, const TransientRequest& request);

}  // namespace jointid::response
