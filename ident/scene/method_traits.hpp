#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace jointid::ident {

struct Plan;
struct PlannedMethod;
enum class Equation;

/// A method of identification, by its place in all_methods(). Files of studies hold the number: new ones go to the end.
enum class Method { one, two, direct, newton, likelihood };

/// A numerical way that a method may take, by its word in [identify] solver; `automatic` leaves it to the method.
enum class Solver {
  automatic,
  qr,
  normal,
  spqr,
  cholmod,
  ldlt,
  levenberg_marquardt,
  newton,
  ceres,
  ipopt,
  pattern,
  gauss_helmert,
  iqml,
  by_parts
};

/// Linear estimates to start from: methods and equations, what needs most first.
using StartChoices = std::vector<std::pair<Method, std::vector<Equation>>>;

/// Plans the first of them that the data of a plan allow, on the same systems. Throws InputError where they allow none.
using StartPlanner = std::function<std::unique_ptr<Plan>(const Plan& plan, const StartChoices& choices)>;

/// What scenes may ask of a method and what it asks of the data. Whoever plans, checks or tells asks here, not for a method by
/// name.
struct MethodTraits {
  Method method;
  std::string name;                    ///< in [identify] method
  std::vector<Solver> solvers;         ///< without automatic
  std::string phrase;                  ///< as a subject: "the direct solution"
  PlannedMethod (*plan)(const Plan& plan, const StartPlanner& plan_start);  ///< what is the method's own of a prepared plan
  bool iterates = false;               ///< from a start; no weighting and Δ, which are those of linear equations
  bool uses_variances = false;         ///< of the FRFs, so that priors and a bootstrap have something to be weighed against
  bool joint_on_assembly = true;       ///< reads the joint coordinates of the assembly: equations nn nj jj jn, else nn alone
  bool inverts_substructures = false;  ///< over all coordinates: both roles there, equations jn and jj
  bool inverts_references = false;     ///< at least as many non-joint references as joint DOFs
};

/// The list of the methods, in the order of Method (ident/methods.cpp).
const std::vector<MethodTraits>& all_methods();

const MethodTraits& traits(Method method);

/// Whether the equations are those of the measured FRFs as they are, none of them inverted: H_nj Z_j H_ba = H_aa − H_nn.
bool takes_frfs_as_measured(Method method);

std::string name(Method method);

/// As in [identify] solver: "gauss-helmert", "auto".
std::string name(Solver solver);

/// The solver by name; throws InputError (usage) with the nearest valid word.
Solver parse_solver(const std::string& text);

/// The method by name; throws InputError (usage) with the nearest valid word.
Method parse_method(const std::string& text);

/// Whether weighting and Δ apply: the likelihood weighs FRFs by their variances instead, newton lines by their sensitivity.
bool weighs_equations(Method method);

/// The names of all methods; those and auto, as in [identify] method; of all solvers of [identify] beginning with auto.
std::vector<std::string> method_names();
std::vector<std::string> method_words();
std::vector<std::string> solver_names();

/// Their names.
std::vector<std::string> names(const std::vector<Solver>& solvers);

}  // namespace jointid::ident
