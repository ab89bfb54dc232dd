#include "ident/likelihood/parts/likelihood_by_parts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <mutex>
#include <tuple>

#include "base/eigen.hpp"
#include "base/parallel.hpp"
#include "base/statistics.hpp"
#include "base/stopwatch.hpp"
#include "base/text.hpp"
#include "ident/equations/linear_plan.hpp"
#include "ident/equations/part_rows.hpp"
#include "ident/judgement/judge.hpp"
#include "ident/judgement/relative_motion.hpp"
#include "ident/likelihood/data/systematic_plan.hpp"
#include "ident/likelihood/errors/chi_square_law.hpp"
#include "ident/likelihood/parts/parts_covariance.hpp"
#include "ident/likelihood/parts/whole_information.hpp"
#include "ident/plan/expected_time.hpp"
#include "ident/plan/interpret.hpp"
#include "ident/plan/joint_guess.hpp"
#include "ident/plan/prediction.hpp"
#include "ident/scene/scene_failure.hpp"
#include "minimise/linear/covariance.hpp"
#include "minimise/linear/null_space.hpp"

namespace jointid::ident {
namespace {

constexpr std::size_t most_small_parts = 8;
constexpr double longest = 60.0;              ///< s, of the whole likelihood
constexpr std::size_t expected_steps = 40;  ///< linearisations of all groups, an experience

/// What of the scene does not go with it, or nothing.
std::string why_not(const Plan& plan) {
  const Scene& scene = plan.scene;
  if (!scene.identify.priors.empty()) return "priors";
  if (scene.identify.bootstrap > 0) return "a bootstrap";
  if (scene.identify.starts > 0) return "several starts";
  if (are_errors_unknown(scene.data)) return "gains, masses and errors of models as unknowns";
  if (plan.admissible) return "definite, bounds, ties and other constraints";
  if (!scene.couple_first.pairs.empty()) return "couple_first";
  return scene.data.regenerate.any() ? "synthesised FRFs" : "";
}

std::vector<Equation> equations_of(const Plan& plan) {
  return equations_by_parts(plan.scene, plan.coordinates, *plan.substructures, *plan.assembly);
}

/// Where the scene leaves the solver open.
bool may_go_by_parts(const Plan& plan) {
  if (plan.scene.identify.solver != Solver::automatic || !why_not(plan).empty()) return false;
  return plan.substructures->source_count() > most_small_parts && !equations_of(plan).empty();
}

class PartsMethod final : public MethodPlan {
 public:
  PartGroups groups;
  std::unique_ptr<PartsData> data;
  std::unique_ptr<Plan> start;  ///< linear; empty where the scene gives it

  void read_first_line(const Plan&) override {}
  void solve(const Plan& plan, const Control& control, Solution& out) override;
  std::string not_shared(const Plan&) const override { return "solver \"by-parts\" works on all lines at once"; }

 private:
  PartsFit fitted(const Plan& plan, const Control& control, Solution& out);
};

constexpr std::array<std::pair<weighting::Weighting, double>, 4> start_weightings = {
    {{weighting::Weighting::wb, 0.0}, {weighting::Weighting::wbg, 0.0}, {weighting::Weighting::wbs, 0.1}, {weighting::Weighting::wa, 0.0}}};

std::size_t conditions_of(const std::vector<GroupLine>& lines) {
  std::size_t count = 0;
  for (const GroupLine& line : lines) count += line.conditions();
  return count;
}

/// From the linear estimate of one weighting after the other, until one fits.
PartsFit PartsMethod::fitted(const Plan& plan, const Control& control, Solution& out) {
  constexpr double fits = 4.0;
  PartsFitOptions options{.threads = threads_or_cores(control.threads)};
  options.step = [&](const PartsFit& step) {
    stop_if(control.interrupted);
    if (control.progress) control.progress("fitting by parts", step.iterations, 0);
    if (!control.so_far) return;
    Solution best = out;
    best.status = Status::not_converged;
    minimise::LinearSolution linear;
    linear.y = step.theta;
    linear.rank = linear.y.size();
    interpret(plan, linear, best);
    best.fit.iterations = step.iterations;
    best.fit.objective = 2.0 * step.cost;
    control.so_far(best);
  };
  double conditions = 0.0;
  for (const auto& lines : data->groups()) conditions += static_cast<double>(conditions_of(lines));
  PartsFit best;
  for (std::size_t k = 0; k < (start ? start_weightings.size() : 1); ++k) {
    std::vector<double> first;
    {
      const Stopwatch watch(out.runtime_s.start);
      if (start) {
        AssemblySpec& spec = linear_plan(*start)->spec;
        std::tie(spec.weighting, spec.delta) = start_weightings[k];
        for (AssemblySpec& each : linear_plan(*start)->part_specs) std::tie(each.weighting, each.delta) = start_weightings[k];
        first = started(plan, *start, control);
      } else {
        first = scaled(plan, joint_values(plan, plan.scene.identify.start, "[identify] start"));
      }
    }
    const Stopwatch watch(out.runtime_s.solve);
    if (k > 0) data->read(control);
    PartsFit fit = fit_by_parts(plan, groups, *data, std::move(first), options);
    const bool better = best.theta.empty() || fit.cost < best.cost;
    if (better) best = std::move(fit);
    if (best.converged && best.cost < fits * conditions) {
      if (better) return best;
      break;
    }
  }
  return best;
}

/// Which directions the information leaves open.
minimise::LinearSolution with_rank(const PartsFit& fit, const PartsCovariance& covariance) {
  constexpr double open = 1e11;
  minimise::LinearSolution linear;
  linear.y = fit.theta;
  linear.rank = fit.theta.size();
  const auto share = [&](std::size_t c) {
    return covariance.variance[at(c)] * 2.0 * fit.information.value[static_cast<std::size_t>(fit.information.start[c])];
  };
  bool suspicious = covariance.variance.size() == 0;
  for (std::size_t c = 0; !suspicious && c < fit.theta.size(); ++c) suspicious = !(share(c) < open);
  if (!suspicious) return linear;
  if (fit.theta.size() > most_of_dense) {
    linear.rank -= 1;
    return linear;
  }
  const Eigen::MatrixXd free = minimise::null_space_of(dense_information(fit.information));
  linear.rank -= static_cast<std::size_t>(free.cols());
  if (free.cols() > 0) minimise::tell_null_space(free, linear);
  return linear;
}

void state_errors(const Plan& plan, const PartsCovariance& covariance, Solution& out) {
  if (covariance.variance.size() == 0) return;
  out.intervals = IntervalKind::sandwich;
  for (std::size_t c = 0; c < out.unknowns.size(); ++c) {
    Estimate& estimate = out.unknowns[c];
    if (!estimate.determined || !(covariance.variance[at(c)] >= 0.0)) continue;
    const double error = std::sqrt(covariance.variance[at(c)]) * plan.unscale(c);
    estimate.std_error = error;
    estimate.ci95 = {estimate.value - normal_95 * error, estimate.value + normal_95 * error};
  }
}

std::string files_of(const Plan& plan, const PartGroup& group) {
  return comma_list(group.members,
                    [&](const GroupMember& member) { return plan.substructures->source(member.source).header().file; });
}

/// χ² of all conditions, of each line and of each group; unknowns count for each as many as they have conditions.
void state_chi_square(const Plan& plan, const PartGroups& all, PartsData& data, const PartsFit& fit, Solution& out) {
  std::vector<double> by_line(data.lines(), 0.0);
  double conditions = 0.0;
  for (const auto& lines : data.groups()) {
    for (std::size_t i = 0; i < lines.size(); ++i) by_line[i] += static_cast<double>(lines[i].conditions());
    conditions += static_cast<double>(conditions_of(lines));
  }
  const auto unknowns = static_cast<double>(fit.theta.size());
  const double left = 1.0 - unknowns / std::max(2.0 * conditions, 1.0);
  ChiSquare chi_square{.value = 2.0 * fit.cost, .degrees_of_freedom = 2.0 * conditions - unknowns, .by_line = {}};
  for (std::size_t i = 0; i < by_line.size(); ++i) chi_square.by_line.push_back(fit.line_cost[i] / (by_line[i] * left));
  chi_square.likely = likely_chi_square(plan, chi_square.degrees_of_freedom, {});
  double touched = 0.0;
  for (std::size_t g = 0; g < all.groups.size(); ++g) touched += static_cast<double>(data.columns(g).size());
  for (std::size_t g = 0; g < all.groups.size(); ++g) {
    const double own = 2.0 * static_cast<double>(conditions_of(data.groups()[g]));
    const double freedom = own - unknowns * static_cast<double>(data.columns(g).size()) / touched;
    if (freedom >= 1.0) out.parts.push_back({files_of(plan, all.groups[g]), 2.0 * fit.group_cost[g], freedom});
  }
  out.fit.chi_square = chi_square;
  out.fit.equations_used = static_cast<std::size_t>(conditions);
}

/// The substructure that fits worst, where chance does not make it so.
void tell_worst_part(const Plan& plan, const Solution& found, Solution& out) {
  const PartMisfit* worst = nullptr;
  double excess = 1.0;
  for (const PartMisfit& part : found.parts) {
    const double likely = likely_chi_square(plan, part.degrees_of_freedom, {}), ratio = part.chi_square / part.degrees_of_freedom;
    if (!(ratio / likely > excess)) continue;
    excess = ratio / likely;
    worst = &part;
  }
  if (worst == nullptr) return;
  tell(out, Status::doubtful,
       worst->files + " fits worst: χ² over degrees of freedom " + digits(worst->chi_square / worst->degrees_of_freedom, "%.3g") +
           ". Look at it and at what it is joined to with `jointid check`.");
}

void PartsMethod::solve(const Plan& plan, const Control& control, Solution& out) {
  {
    const Stopwatch watch(out.runtime_s.read);
    data->read(control);
  }
  for (const FileVariances& file : data->origins()) out.variances.push_back({file.file, phrase(file.origin), note(file)});
  const PartsFit fit = fitted(plan, control, out);
  out.fit.lines = data->lines();
  out.fit.iterations = fit.iterations;
  out.used.accumulator_bytes = data->bytes();
  PartsCovariance covariance;
  {
    const Stopwatch watch(out.runtime_s.intervals);
    covariance = covariance_by_parts(plan, groups, *data, fit, threads_or_cores(control.threads));
    interpret(plan, with_rank(fit, covariance), out);
    if (fit.converged) state_errors(plan, covariance, out);
  }
  state_chi_square(plan, groups, *data, fit, out);
  if (!fit.converged) {
    out.status = Status::not_converged;
    out.message = "The likelihood by parts did not converge.";
  }
  if (fit.converged && control.judgement != Judgement::none && covariance.whole.size() > 0) {
    const Stopwatch watch(out.runtime_s.check);
    const ChiSquare& chi_square = *out.fit.chi_square;
    judge_likelihood(plan,
                     {.theta = fit.theta,
                      .covariance = covariance.whole,
                      .likely = chi_square.likely,
                      .ratio = chi_square.value / std::max(1.0, chi_square.degrees_of_freedom)},
                     control, out);
    if (control.detail == Detail::full) tell_worst_part(plan, out, out);
  }
  if (control.detail == Detail::full && control.judgement != Judgement::none) tell_relative_motions(plan, out);
  tell_and_predict(plan, control, out);
}

/// Substructures in a group: as many as take about as long as can be waited for.
std::size_t group_size(const Plan& plan, const std::vector<Equation>& equations) {
  constexpr double affordable = 1.5e10;  // flops
  for (const std::size_t size : {std::size_t{4}, std::size_t{3}, std::size_t{2}}) {
    const double flops = linearisation_flops(part_groups(plan, equations, size));
    if (flops * static_cast<double>(plan.lines.size() * expected_steps) <= affordable) return size;
  }
  return 1;
}

void plan_prediction(const Plan& plan, const EquationSet& use, PlannedMethod& out) {
  constexpr std::size_t most = 400;  // joint coordinates: all at once
  const Dofs& joint = plan.coordinates.joint;
  const auto has_motion = [&](const frf::Dof& dof) { return frf::has(plan.substructures->responses(), dof); };
  if (joint.size() > most || !std::ranges::all_of(joint, has_motion)) {
    out.left_out.emplace_back("the assembly FRF error: it takes all joints at once");
    return;
  }
  out.predicted_responses = joined(only_if(use.nn || use.nj, plan.coordinates.responses), joint);
  out.predicted_references = part_columns(plan.coordinates, use, *plan.assembly);
}

void plan_cost(const Plan& plan, const PartsMethod& own, PlannedMethod& out) {
  const auto lines = static_cast<double>(plan.lines.size());
  out.entries_per_line = own.data->entries_per_line();
  out.cost.lines = plan.lines.size();
  out.cost.columns = plan.columns->size();
  for (const PartGroup& group : own.groups.groups) out.cost.equations_per_line += group.rows * own.groups.references.size();
  out.cost.bytes_read = out.entries_per_line * sizeof(Complex) * plan.lines.size();
  Iteration& iteration = out.cost.iteration;
  iteration.expected = expected_steps;
  iteration.flops = lines * linearisation_flops(own.groups);
  for (const PartGroup& group : own.groups.groups) iteration.matrix = std::max(iteration.matrix, group.frfs());
  iteration.complex = true;
  iteration.memory_bytes = out.entries_per_line * plan.lines.size() * 6 * sizeof(Complex);
}

std::size_t widest_of(const PartsMethod& own) {
  std::size_t widest = 0;
  for (const PartGroup& group : own.groups.groups) widest = std::max(widest, group.unknowns.size());
  return widest;
}

}  // namespace

bool goes_by_parts(const Plan& plan) {
  if (plan.scene.identify.solver == Solver::by_parts) return true;
  const bool many = plan.columns->size() >= least_unknowns_by_parts || plan.scene.identify.loose;
  return many && may_go_by_parts(plan);
}

bool is_better_by_parts(const Plan& plan, const Cost& whole) {
  return !are_expected_within(longest, whole) && may_go_by_parts(plan);
}

PlannedMethod plan_by_parts(const Plan& plan, const StartPlanner& plan_start) {
  const std::string why = why_not(plan);
  if (!why.empty()) fail(plan.scene, "[identify] solver", "solver \"by-parts\" does not go with " + why, "leave one of them out");
  PlannedMethod out = undecided(plan);
  out.equations = equations_of(plan);
  if (out.equations.empty()) {
    fail(plan.scene, "[identify] solver",
         "solver \"by-parts\" needs three substructures or more, motion at all joint coordinates of the assembly and forces at those of "
         "the substructures",
         "measure them, or use another solver");
  }
  out.solver = Solver::by_parts;
  auto own = std::make_unique<PartsMethod>();
  own->groups = part_groups(plan, out.equations, group_size(plan, out.equations));
  own->data = std::make_unique<PartsData>(plan, own->groups);
  if (plan.scene.identify.start.empty()) own->start = plan_start(plan, {{Method::one, plan.scene.identify.equations}, {Method::one, {}}});
  plan_cost(plan, *own, out);
  plan_prediction(plan, EquationSet(out.equations), out);
  std::size_t widest = 0;
  for (const PartGroup& group : own->groups.groups) widest = std::max(widest, group.members.size());
  out.notes.push_back("The likelihood goes by parts: each substructure" +
                      (widest > 1 ? ", or " + std::to_string(widest) + " that are joined," : std::string()) +
                      " has its own estimate of the motions at its joints. Standard errors hold what this costs (docs/many-joints.md).");
  out.method = std::move(own);
  return out;
}

bool may_be_quicker_whole(const Plan& plan, const PlannedMethod& parts) {
  if (plan.scene.identify.solver != Solver::automatic || are_expected_within(longest, parts.cost)) return false;
  return 2 * widest_of(dynamic_cast<const PartsMethod&>(*parts.method)) > plan.columns->size();
}

PlannedMethod quicker(const Plan& plan, PlannedMethod parts, PlannedMethod whole) {
  const double by_parts = expected_seconds(parts.cost, 2);
  if (by_parts < expected_seconds(whole.cost, 2)) return parts;
  whole.notes.push_back("The likelihood by parts would take about " + digits(by_parts) + " s: one substructure carries " +
                        std::to_string(widest_of(dynamic_cast<const PartsMethod&>(*parts.method))) + " of " +
                        std::to_string(plan.columns->size()) + " unknowns.");
  return whole;
}

std::optional<WholeInformation> information_by_parts(const Plan& plan, const std::vector<double>& theta, std::size_t pieces,
                                                     const Control& control) {
  if (dynamic_cast<const PartsMethod*>(plan.method.get()) == nullptr) return std::nullopt;
  if (theta.size() > most_of_dense) {
    fail(plan.scene, "[joint]",
         "the bound of " + std::to_string(theta.size()) + " unknowns is not computed, only of at most " + std::to_string(most_of_dense),
         "leave joints or elements out, or take the standard errors of `jointid solve`");
  }
  const PartGroups all = part_groups(plan, plan.equations, plan.substructures->source_count());
  PartsData data(plan, all);
  data.read(control);
  const std::size_t lines = data.lines();
  pieces = std::min(pieces, lines);
  WholeInformation out{.of_lines = std::vector<Eigen::MatrixXd>(pieces, Eigen::MatrixXd::Zero(at(theta.size()), at(theta.size()))),
                       .origins = data.origins()};
  std::size_t done = 0;
  std::mutex mutex;
  for_each_index(lines, threads_or_cores(control.threads), [&](std::size_t i) {
    stop_if(control.interrupted);
    for (std::size_t g = 0; g < all.groups.size(); ++g) {
      const GroupLine& line = data.groups()[g][i];
      std::vector<std::size_t> places;
      std::vector<double> own;
      for (const std::size_t place : line.columns) {
        places.push_back(data.columns(g)[place]);
        own.push_back(theta[places.back()]);
      }
      const GroupImpedance impedance = group_impedance(all.groups[g], own, line.omega, plan.omega0);
      const Eigen::MatrixXd found = whole_information(all.groups[g], all, line, impedance);
      const std::scoped_lock lock(mutex);
      out.of_lines[i * pieces / lines](places, places) += found;
    }
    const std::scoped_lock lock(mutex);
    if (control.progress) control.progress("predicting errors", ++done, lines);
  });
  return out;
}

std::optional<SystemPattern> pattern_by_parts(const Plan& plan, std::size_t least) {
  const auto* const own = dynamic_cast<const PartsMethod*>(plan.method.get());
  if (own == nullptr || plan.columns->size() < least) return std::nullopt;
  std::vector<RowGroup> groups;
  for (const PartGroup& group : own->groups.groups) groups.push_back({group.unknowns, files_of(plan, group)});
  return pattern_of(plan, groups);
}

}  // namespace jointid::ident
