#pragma once

#include "ident/decibel_error.hpp"
#include "ident/plan.hpp"
#include "ident/rectangle.hpp"
#include "ident/solution.hpp"

namespace jointid::ident {

/// Predicts the assembly's FRFs of some lines from those of the substructures and the joint,
/// H_asm = H_sub − H_:b (I + Z_j H_bb)⁻¹ Z_j H_b: (formulas §2, thesis eq. 6.12–6.15), and compares them with the measured.
class Predictor {
 public:
  explicit Predictor(Plan& plan);

  /// Adds lines [first, last) of the plan, with the matrices of the band that each lies in.
  void add(std::size_t first, std::size_t last, const std::vector<BandMatrices>& bands, DecibelError& error);

 private:
  Plan& plan_;
  Rectangle substructures_, assembly_;
};

}  // namespace jointid::ident
