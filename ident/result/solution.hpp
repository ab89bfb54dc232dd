#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/status.hpp"
#include "ident/result/admissibility.hpp"
#include "ident/result/identifiability.hpp"
#include "ident/result/loose_joint.hpp"
#include "ident/result/suspect.hpp"
#include "ident/result/used_model.hpp"
#include "ident/scene/scene.hpp"

namespace jointid::ident {

using jointid::Status, jointid::name, jointid::is_usable;

/// How the intervals of a solution were found.
enum class IntervalKind { none, cramer_rao, bootstrap, sandwich };

std::string name(IntervalKind kind);

struct Estimate {
  std::string name;
  std::string unit;
  double value = 0.0;
  bool determined = true;           ///< false: the data do not determine it, see Solution::message
  std::optional<double> std_error;  ///< empty if the method states none
  std::optional<std::array<double, 2>> ci95;
  /// First-order bound of the effect of rounding on the value, that of the FRFs and that of the arithmetic, in its unit. Linear
  /// methods with Detail::full.
  std::optional<double> rounding;
  /// Effect of the noise of the FRFs on the value, √(scatter² + bias²), in its unit. Linear methods with Detail::full. It is not
  /// a standard error: it is not the width of a distribution about the truth.
  std::optional<double> error_estimate{};
  std::optional<double> bias{};  ///< its part from noise in the coefficients, to first order; empty if unknown
  std::string limit{};  ///< the active constraint: "tied", "at its lower bound", "K is singular"; empty: none

  /// What the value may be off by, in its unit: the standard error where the method states one, else the effect of the noise.
  std::optional<double> error() const { return std_error ? std_error : error_estimate; }
};

/// A gain, delay or mass that was estimated with the joint.
struct SystematicEstimate {
  std::string name, unit;  ///< "gain of 125:+Y"; empty unit of gains
  double value = 1.0;      ///< true FRF = gain · FRF of the file; delays in s, masses in kg
  std::optional<double> std_error;
  double prior = 1.0, prior_deviation = 0.0;
};

using Matrices = std::map<restrictions::Kind, Matrix>;

/// Joint matrices of one frequency band (one band without limits when the scene names none).
struct BandMatrices {
  std::optional<Range> band_hz;
  Matrices matrices;
  Matrices errors{};  ///< of the elements, from Estimate::error_estimate; empty if there is none
};

/// Residuals against their variances. `value` is about `degrees_of_freedom` ± √(2·degrees_of_freedom) if joint model and
/// variances are right. Both are over the lines that the verdict uses: without outlier lines, if these are a third at
/// most.
struct ChiSquare {
  double value = 0.0;
  double degrees_of_freedom = 0.0;
  std::size_t outlying_lines = 0;  ///< outlier lines, whose weight is less than half
  std::vector<double> by_line;     ///< χ² over its expectation, one per line; NaN for a line without redundancy
  double likely = 0.0;  ///< value over degrees of freedom that chance exceeds once in three million times; 0: not stated
};

/// χ² of the conditions of some substructures alone, of solver "by-parts".
struct PartMisfit {
  std::string files;
  double chi_square = 0.0, degrees_of_freedom = 0.0;
};

/// The same direction on two sides of a joint.
struct RelativeMotion {
  std::string joint;
  frf::Dof a, b;
  double over_error = 0.0;  ///< |x_a − x_b| over its standard error, median over lines and references of the assembly
};

struct Fit {
  std::size_t equations_used = 0;     ///< complex equations
  std::size_t equations_dropped = 0;  ///< by Δ, by missing data, or with zero coefficients only
  std::size_t lines = 0;
  std::size_t rank = 0;
  double condition = 0.0;                ///< of the column-scaled weighted system: 2-norm (qr), a lower bound of it (spqr), 1-norm (normal)
  /// Decimal digits that rounding leaves of the worst unknown, relative to the largest of its joint and unit; not below 0.
  std::optional<double> digits;
  std::size_t iterations = 0;            ///< of iterative methods
  /// What a step of an iterative method makes least, told by Control::so_far: Σ L over the lines (likelihood), χ² (by parts), the mean
  /// over the lines of log(1 + ‖F‖²/‖H_aa − H_nn‖²) (newton). None of a solution.
  std::optional<double> objective{};
  std::optional<ChiSquare> chi_square;   ///< of methods that weigh FRFs by their variances
  std::optional<double> asm_frf_error;   ///< dB; empty if the scene's equations do not read the FRFs for it
  /// Linear methods with Detail::full: squared residuals over those that the noise explains, WhitenedFit::misfit.
  std::optional<double> misfit{};
};

/// Figures of merit of docs/formulas.md §6 for one matrix against the truth.
struct Quality {
  double rjcf = 0.0;
  double arvf = 0.0;
  double rms_relative_error = 0.0;  ///< sqrt(mean((u_i − 1)²)) over the same elements
};

/// Run time by phase, s. Reading overlaps with the rest if several threads work: `assemble` is the time of that stage without
/// reading. Phases add up to the total, except for very short ones.
struct RunTime {
  double read = 0.0, assemble = 0.0;
  double start = 0.0;  ///< linear estimates that an iteration starts from, or a weighting is chosen by
  double solve = 0.0, intervals = 0.0, identifiability = 0.0;
  double regenerate = 0.0;  ///< synthesis of the assembly's FRFs, and their comparison
  double check = 0.0;       ///< of the data: figures of misfit, quick_check()
  double total = 0.0;
};

/// Its phases by name, in the order in which they are taken.
inline constexpr std::array<std::pair<const char*, double RunTime::*>, 8> run_time_phases = {
    {{"read", &RunTime::read},
     {"assemble", &RunTime::assemble},
     {"start", &RunTime::start},
     {"solve", &RunTime::solve},
     {"intervals", &RunTime::intervals},
     {"identifiability", &RunTime::identifiability},
     {"regenerate", &RunTime::regenerate},
     {"check", &RunTime::check}}};

/// Source of the variances of a file's FRFs, in words for the user.
struct VarianceSource {
  std::string file;
  std::string origin;  ///< phrase() of the VarianceOrigin
  std::string note;    ///< a sentence, or empty
};

/// The way of the solution as it was carried out. It shows any fall-back.
struct Used {
  Method method = Method::one;
  std::vector<Equation> equations;
  weighting::Weighting weighting = weighting::Weighting::none;
  double delta = 0.0;
  std::string solver;
  std::string chosen = {};  ///< "method …: why", if the scene names none; else empty
  std::size_t accumulator_bytes = 0;  ///< of the reduced system and its row buffers; of the likelihood, of its data and states
};

/// A minimum that starts of an iterative method reached.
struct FoundMinimum {
  double cost = 0.0;         ///< χ² of method likelihood; of newton the mean over the lines of log(1 + ‖F‖²/‖H_aa − H_nn‖²)
  std::size_t starts = 0;    ///< number of starts that ended there
  std::vector<double> values;  ///< of the unknowns, SI
};

/// Result of a search from several starts.
struct MinimumSearch {
  std::vector<FoundMinimum> minima;  ///< best first
  std::size_t equally_good = 0;      ///< minima as good as the best, itself included; 1: no other was found
};

struct Solution {
  Status status = Status::ok;
  std::string message;  ///< one or more sentences; empty if the status is ok
  std::vector<Estimate> unknowns;
  std::vector<frf::Dof> dofs;
  std::vector<BandMatrices> bands;  ///< at least one
  Fit fit;
  IntervalKind intervals = IntervalKind::none;
  std::optional<Admissibility> admissibility;      ///< if the scene has constraints
  std::optional<Identifiability> identifiability;  ///< for methods that know the covariance of their estimates
  std::optional<MinimumSearch> search;  ///< if the scene asks for several starts
  std::map<restrictions::Kind, Quality> quality;   ///< if the scene has the truth
  RunTime runtime_s;
  Used used;
  std::vector<std::string> warnings;      ///< reasons to doubt the numbers, one sentence each
  std::optional<CheckResult> check{};     ///< of the data, its short form (quick_check()); with Detail::full
  std::vector<SystematicEstimate> systematic{};  ///< of [[data.gains]] and [[data.masses]]
  std::vector<Suspect> suspects{};  ///< method likelihood: suspects from the fit itself; files as they were opened
  std::vector<PartMisfit> parts{};  ///< of solver "by-parts", in the order of the files
  std::vector<RelativeMotion> relative_motions{};  ///< of ways by parts, if the assembly's files state errors: all pairs of joint DOFs
  std::vector<LooseJoint> loose{};  ///< if the scene asks for loose joints: the most probable first
  std::vector<VarianceSource> variances;  ///< per file, of methods that weigh FRFs by their variances
  std::vector<UsedModel> models{};        ///< per file that describes a model: how its FRFs were computed
};

}  // namespace jointid::ident
