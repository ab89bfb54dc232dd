#include "ident/likelihood/fit/starts.hpp"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include "ident/equations/linear_plan.hpp"
#include "ident/likelihood/data/likelihood_plan.hpp"
#include "ident/likelihood/fit/predicted_start.hpp"
#include "ident/likelihood/fit/spring_starts.hpp"
#include "ident/plan/joint_guess.hpp"
#include "minimise/linear/start_points.hpp"

namespace jointid::ident {
namespace {

using enum weighting::Weighting;

constexpr std::array<std::pair<weighting::Weighting, double>, 4> linear_ways = {{{wb, 0.0}, {wbg, 0.0}, {wbs, 0.1}, {wa, 0.0}}};

/// Linear estimates with one weighting after the other; one estimate where the start is the likelihood by parts.
std::optional<std::vector<double>> linear_start(const Plan& plan, std::size_t k, const Control& control) {
  const Plan& start = *likelihood_plan(plan)->start;
  LinearPlan* const linear = linear_plan(start);
  if (k >= (linear != nullptr ? linear_ways.size() : 1)) return std::nullopt;
  if (linear != nullptr) {
    std::tie(linear->spec.weighting, linear->spec.delta) = linear_ways[k];
    for (AssemblySpec& each : linear->part_specs) std::tie(each.weighting, each.delta) = linear_ways[k];
  }
  return started(plan, start, control);
}

/// Joints that were given or guessed, in sizes that fit.
minimise::StartPoints in_sizes(const std::vector<std::vector<double>>& joints, LikelihoodEstimator& estimator) {
  return {joints, [&](const std::vector<double>& theta) { return estimator.misfit_at(theta); }};
}

/// Where H_jn of the assembly is not measured: the first as it is, then along method "newton" from those in sizes that fit. What
/// the data say of the joint then is far from linear, and its steps come nearer from farther away.
Starts predicted_starts(const Plan& plan, std::optional<std::vector<double>> first, const minimise::StartPoints& points,
                        std::size_t most) {
  return [first = std::move(first), points, most, &plan](std::size_t k) -> std::optional<std::vector<double>> {
    if (k >= most) return std::nullopt;
    if (k == 0 && first) return first;
    return predicted_start(plan, *likelihood_plan(plan)->observations, points(first ? k - 1 : k));
  };
}

/// From the scene's start.
Starts given_starts(const Plan& plan, LikelihoodEstimator& estimator, std::size_t most) {
  const auto points = in_sizes({scaled(plan, joint_values(plan, plan.scene.identify.start, "[identify] start"))}, estimator);
  if (!joint_is_reached(plan)) return predicted_starts(plan, points(0), points, most);
  return [points, most](std::size_t k) { return k < most ? std::optional(points(k)) : std::nullopt; };
}

/// Where H_jn is not measured: from springs, and first from the direct solution when that fits better, as it does without noise.
Starts guessed_starts(const Plan& plan, LikelihoodEstimator& estimator, const std::vector<std::vector<double>>& springs,
                      const Control& control, std::size_t most) {
  const auto points = in_sizes(springs, estimator);
  std::optional direct = linear_start(plan, 0, control);
  if (!(estimator.misfit_at(*direct) < estimator.misfit_at(points(0)))) direct.reset();
  return predicted_starts(plan, std::move(direct), points, most);
}

/// Linear estimates, that which fits best first, then random changes of that one. Where the first nearly fits no other is worked
/// out to compare it with.
Starts linear_starts(const Plan& plan, LikelihoodEstimator& estimator, const Control& control, std::size_t most) {
  constexpr double near = 1.0;
  std::vector<std::vector<double>> found;
  std::ptrdiff_t best = 0;
  double least = 0.0;
  while (found.empty() || least > near) {
    auto next = linear_start(plan, found.size(), control);
    if (!next) break;
    found.push_back(std::move(*next));
    const double misfit = estimator.misfit_at(found.back());
    if (found.size() == 1 || misfit < least) std::tie(best, least) = std::pair(std::ssize(found) - 1, misfit);
  }
  std::rotate(found.begin(), found.begin() + best, found.begin() + best + 1);
  return [&plan, &control, found = std::move(found), most](std::size_t k) -> std::optional<std::vector<double>> {
    if (k >= most) return std::nullopt;
    if (k < found.size()) return found[k];
    if (auto start = linear_start(plan, k, control)) return start;
    const minimise::StartPoints points({found.front()}, [](const std::vector<double>&) { return 0.0; });
    return points(minimise::StartPoints::sizes + k);
  };
}

/// In deviations of the scales.
constexpr std::array<double, 4> other_scales = {1.0, -1.0, 2.0, -2.0};

const SystematicPlan* with_scales(const Plan& plan) {
  const SystematicPlan* systematic = likelihood_plan(plan)->observations->systematic_plan();
  for (std::size_t part = 0; systematic != nullptr && part < plan.scene.data.substructures.size(); ++part) {
    if (!systematic->scales(part).empty()) return systematic;
  }
  return nullptr;
}

/// All models as much off: in stiffness, where an error of it is stated, else in mass.
void move_scales(const Plan& plan, const SystematicPlan& systematic, double deviations, std::vector<double>& theta) {
  const std::size_t joint = plan.columns->size();
  theta.resize(joint + systematic.all().size(), 0.0);
  for (std::size_t part = 0; part < plan.scene.data.substructures.size(); ++part) {
    const std::vector<ScaleUnknown>& scales = systematic.scales(part);
    const bool of_mass = std::ranges::all_of(scales, &ScaleUnknown::is_mass);
    for (const ScaleUnknown& scale : scales) {
      if (scale.is_mass == of_mass) theta[joint + scale.unknown] = (of_mass ? -deviations : deviations) * scale.band.deviation;
    }
  }
}

/// The first with other scales after it, then the others.
Starts in_scales(const Plan& plan, Starts starts) {
  const SystematicPlan* systematic = with_scales(plan);
  if (systematic == nullptr) return starts;
  return [&plan, systematic, starts = std::move(starts)](std::size_t k) -> std::optional<std::vector<double>> {
    if (k == 0 || k > other_scales.size()) return starts(k == 0 ? 0 : k - other_scales.size());
    auto start = starts(0);
    if (start) move_scales(plan, *systematic, other_scales[k - 1], *start);
    return start;
  };
}

Starts starts_of_joint(const Plan& plan, LikelihoodEstimator& estimator, const Control& control) {
  const LikelihoodPlan& own = *likelihood_plan(plan);
  const std::size_t wanted = plan.scene.identify.starts;
  const std::size_t of_sizes = wanted > 0 ? wanted : 2 * minimise::StartPoints::sizes;
  if (!own.start) return given_starts(plan, estimator, of_sizes);
  if (!joint_is_reached(plan)) {
    const auto springs = spring_starts(plan, *own.observations);
    if (!springs.empty()) return guessed_starts(plan, estimator, springs, control, of_sizes);
  }
  return linear_starts(plan, estimator, control, wanted > 0 ? wanted : linear_ways.size());
}

}  // namespace

bool joint_is_reached(const Plan& plan) { return likelihood_plan(plan)->observations->layout().reaches_joint(); }

bool has_scales(const Plan& plan) { return with_scales(plan) != nullptr; }

Starts starts_of(const Plan& plan, LikelihoodEstimator& estimator, const Control& control) {
  return in_scales(plan, starts_of_joint(plan, estimator, control));
}

}  // namespace jointid::ident
