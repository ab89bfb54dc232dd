#include "ident/likelihood/errors/chi_square_law.hpp"

#include <algorithm>
#include <cmath>

#include "base/statistics.hpp"
#include "ident/scene/variance_origin.hpp"
#include "ident/variance/variance_smoothing.hpp"

namespace jointid::ident {
namespace {

constexpr double deviations = 5.0;
constexpr double law_misfit = 0.02;                      ///< of a smooth law of the variances
constexpr double most_of_mirror = 1.3, unchecked = 1.2;  ///< times what scatter makes
constexpr double from_scatter = 2.0;
constexpr double enough_differences = 200.0;

/// What is known of the estimated variances of a scene.
struct Estimated {
  bool any = false, from_data = false;
  double expected = 1.0;               ///< largest of all files
  double freedom = 1e9;                ///< least ν
};

void look_at(const Scene& scene, const frf::FrfHeader& header, Estimated& out) {
  const VarianceOrigin origin = variance_origin(scene, header);
  if (origin == VarianceOrigin::scatter) out.any = out.from_data = true;
  const double freedom = (header.repeats > 1 ? static_cast<double>(header.repeats) : header.averages) - 1.0;
  const bool recorded = origin == VarianceOrigin::coherence || origin == VarianceOrigin::repeats || origin == VarianceOrigin::variance;
  if (!recorded || !(freedom > 0.0)) return;
  const bool smooth = scene.identify.smooth_variance.value_or(worth_smoothing(origin, header));
  out.any = true;
  out.freedom = std::min(out.freedom, freedom);
  if (!smooth) out.expected = std::max(out.expected, freedom > 1.0 ? freedom / (freedom - 1.0) : from_scatter);
}

}  // namespace

double likely_chi_square(const Plan& plan, double freedom, const MirrorDifferences& differences) {
  const double f = std::max(1.0, freedom), known = chi_square_quantile(f, deviations) / f;
  Estimated estimated;
  for (const frf::FrfSystem* system : {plan.substructures.get(), plan.assembly.get()}) {
    for (std::size_t s = 0; s < system->source_count(); ++s) look_at(plan.scene, system->source(s).header(), estimated);
  }
  if (!estimated.any) return known;
  const double mirror = differences.count > enough_differences
                            ? std::clamp(differences.squares / differences.count, estimated.expected, most_of_mirror * estimated.expected)
                            : unchecked * estimated.expected;
  const double likely = mirror * (1.0 + law_misfit) + deviations * std::sqrt(2.0 / f * (1.0 + 2.0 / estimated.freedom));
  return std::max({likely, known, estimated.from_data ? from_scatter : 0.0});
}

}  // namespace jointid::ident
