#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ident/plan/coordinates.hpp"
#include "ident/plan/line.hpp"
#include "ident/plan/method.hpp"
#include "ident/plan/regeneration_note.hpp"
#include "ident/plan/unknown_columns.hpp"
#include "ident/scene/scene.hpp"
#include "restrictions/restriction.hpp"

namespace jointid::ident {

struct AdmissibleSet;

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

/// The hinge: everything that is decided before FRFs are read, from the scene and the headers of its files.
/// What it does not name is not read, allocated or computed.
struct Plan {
  Scene scene;
  restrictions::Restriction restriction;
  std::shared_ptr<frf::FrfSystem> substructures, assembly;
  Coordinates coordinates;
  std::vector<Equation> equations;  ///< used, in the order nn nj jj jn
  std::vector<Line> lines;
  std::unique_ptr<UnknownColumns> columns;
  std::unique_ptr<MethodPlan> method;
  std::string chosen;  ///< "method …: why", where the scene left it open; else empty
  std::shared_ptr<const AdmissibleSet> admissible;  ///< empty where the scene has no constraints
  std::size_t entries_per_line = 0;            ///< FRFs read
  bool keeps_frfs = false;                     ///< what was read once is not read again
  double omega0 = 0.0;                ///< rad/s, of the scaled unknowns x = {k, ω₀²m, ω₀c, d}: the highest used frequency
  std::string solver;                 ///< by name as in [identify] solver, never "auto"
  /// Assembly FRFs that are predicted from the result for asm_frf_error; empty when the equations do not read what it needs.
  Dofs predicted_responses, predicted_references;
  Cost cost;
  /// Unknown of a column in SI units = scaled unknown · this.
  double unscale(std::size_t column) const;
  std::vector<ModalRegeneration> regenerated;  ///< structures whose FRFs are those of modal models
  std::vector<std::string> left_out;  ///< what the scene does not need, one phrase each
  std::vector<std::string> notes;     ///< what the user should know, one sentence each
  std::vector<std::string> warnings;  ///< what may be wrong with the data or the scene, one sentence each
};

}  // namespace jointid::ident
