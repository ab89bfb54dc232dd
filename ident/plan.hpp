#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ident/equation_builder.hpp"
#include "ident/line.hpp"
#include "ident/line_assembler.hpp"
#include "ident/regeneration_note.hpp"
#include "ident/scene.hpp"
#include "ident/unknown_columns.hpp"
#include "restrictions/restriction.hpp"

namespace jointid::ident {

struct AdmissibleSet;
struct LikelihoodPlan;
struct NewtonPlan;

/// What the stages will cost, counted before anything is done.
struct Cost {
  std::size_t lines = 0;
  std::size_t equations_per_line = 0;       ///< complex, before Δ and missing data
  std::size_t compressed_rows_per_line = 0; ///< real rows that reach the least-squares problem
  std::size_t columns = 0;
  std::size_t bytes_read = 0;               ///< FRF values, without file overhead
  double assemble_flops = 0.0;
  double stacked_flops = 0.0;               ///< of the plain way: all equations stacked, one dense QR
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
  std::unique_ptr<EquationBuilder> builder;    ///< of linear methods
  std::shared_ptr<LikelihoodPlan> likelihood;  ///< of that method
  std::shared_ptr<NewtonPlan> newton;          ///< of that method
  std::shared_ptr<const AdmissibleSet> admissible;  ///< empty where the scene has no constraints
  std::size_t entries_per_line = 0;            ///< FRFs read
  AssemblySpec assembly_spec;
  std::string solver;                 ///< by name as in [identify] solver, never "auto"
  /// Assembly FRFs that are predicted from the result for asm_frf_error; empty when the equations do not read what it needs.
  Dofs predicted_responses, predicted_references;
  Cost cost;
  /// Unknown of a column in SI units = scaled unknown of x = {k, ω₀²m, ω₀c, d} · this.
  double unscale(std::size_t column) const;
  std::vector<ModalRegeneration> regenerated;  ///< structures whose FRFs are those of modal models
  std::vector<std::string> left_out;  ///< what the scene does not need, one phrase each
  std::vector<std::string> notes;     ///< what the user should know, one sentence each
  std::vector<std::string> warnings;  ///< what may be wrong with the data or the scene, one sentence each
};

/// Opens the scene's files (headers only) and plans. Throws InputError for DOFs that no file has, equations that the data do
/// not allow, ranges without lines, and methods or solvers that cannot do what the scene asks.
/// FRFs are read here only when the scene asks for resonances to be found, or for FRFs to be regenerated.
std::unique_ptr<Plan> make_plan(const Scene& scene);

/// The same on sources that are open already, for sets in memory.
std::unique_ptr<Plan> make_plan(const Scene& scene, std::shared_ptr<frf::FrfSystem> substructures,
                                std::shared_ptr<frf::FrfSystem> assembly);

/// Reads what the plan reads of its first line, for callers who want to know which FRFs that is.
void read_first_line(Plan& plan);

/// A further builder for the plan's equations, for a thread of its own. Reading stays one at a time: the systems are shared.
std::unique_ptr<EquationBuilder> make_builder(Plan& plan);

}  // namespace jointid::ident
