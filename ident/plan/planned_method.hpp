#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ident/plan/coordinates.hpp"
#include "ident/plan/method.hpp"
#include "ident/scene/method_traits.hpp"

namespace jointid::ident {

struct Plan;

/// What an iterative method will cost; of linear ones all is 0.
struct Iteration {
  std::size_t expected = 0;      ///< iterations of one line, an experience (docs/cost.md)
  double flops = 0.0;            ///< of one, over all lines
  std::size_t matrix = 0;        ///< size of the dense matrices of a line that most of it goes into
  bool complex = false;          ///< what they hold
  std::size_t memory_bytes = 0;  ///< of data, states and one thread's matrices
};

/// What the stages will cost, counted before anything is done.
struct Cost {
  std::size_t lines = 0;
  std::size_t equations_per_line = 0;       ///< complex, before Δ and missing data
  std::size_t compressed_rows_per_line = 0; ///< real rows that reach the least-squares problem
  std::size_t columns = 0;
  std::size_t bytes_read = 0;               ///< FRF values, without file overhead
  double assemble_flops = 0.0;
  double stacked_flops = 0.0;               ///< of the plain way: all equations stacked, one dense QR
  Iteration iteration;
};

/// What a method decides of a prepared plan (MethodTraits::plan).
struct PlannedMethod {
  std::unique_ptr<MethodPlan> method;
  Coordinates coordinates;            ///< used
  Solver solver = Solver::automatic;  ///< as decided: not automatic
  std::vector<Equation> equations;    ///< used, in the order nn nj jj jn
  std::size_t entries_per_line = 0;   ///< FRFs read
  /// Assembly FRFs that are predicted from the result for asm_frf_error; empty when the equations do not read what it needs.
  Dofs predicted_responses, predicted_references;
  Cost cost;
  std::vector<std::string> left_out;  ///< what the scene does not need, one phrase each
  std::vector<std::string> notes;     ///< what the user should know, one sentence each
};

/// What there is before the method decides: the coordinates and, for methods that take equations as they are, these.
PlannedMethod undecided(const Plan& plan);

}  // namespace jointid::ident
