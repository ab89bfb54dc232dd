#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "response/identify/measured_state.hpp"

namespace jointid::response {

/// One mistake of a measurement that would make states agree with the structure: phasors times `gain`, or two responses or the
/// forces of two levels exchanged.
struct DataFault {
  enum class Kind { response, force, exchanged, levels };
  Kind kind = Kind::response;
  Eigen::Index first = 0, second = 0;   ///< responses of the receptance
  std::optional<std::size_t> level{};   ///< of a force; empty: of all
  std::size_t other_level = 0;          ///< whose forces are those of `level`, and the other way round
  Complex gain = 1.0;                   ///< by which what was measured is to be multiplied
  double chi_square = 0.0;              ///< of the consistency with it mended
};

/// Whether states agree with the structure whatever the laws of its joints are.
struct Consistency {
  double chi_square = 0.0;
  Eigen::Index freedom = 0;       ///< 2 (responses − joints) of each harmonic; 0: no more responses than joints, nothing is tested
  double limit = 0.0;             ///< χ² above which they contradict each other, at 4 deviations
  std::vector<DataFault> faults;  ///< when they do: single mistakes that mend most of it, best first

  bool contradicts() const { return freedom > 0 && chi_square > limit; }
};

/// Of each harmonic n ≥ 1 of each state, the least χ² over any forces F of the joints,
///
///   min_F rᴴ C⁻¹ r,  r = Y_n − H_mP_n + H_mW F,  C = diag(σ²) + Σ_e var_e m_e m_eᴴ,
///
/// m_e what an error of the structure's FRFs moves the responses by under F and P_n, or one of P_n, to first order; their sum is
/// χ² of `freedom` degrees of freedom. States of one line share the errors of the structure, so that the limit is that of a sum
/// of as many equal numbers as there are levels. `level` of each state. A fault is told when it takes away 9 tenths of what is
/// above the freedom, and its χ² is at most twice that of the best.
Consistency test_consistency(const Receptance& structure, const std::vector<MeasuredState>& states, const std::vector<std::size_t>& level);

}  // namespace jointid::response
