#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "friction/curve/equivalent.hpp"
#include "friction/law/laws.hpp"
#include "rig_two_table.hpp"

namespace jointid::problems {
namespace {

constexpr std::uint64_t seeds = 200;

const char* name(Form form) {
  if (!form.real) return form.rigid ? "(7.18) as measured" : "(7.11) as measured";
  if (!form.relative) return form.rigid ? "(7.18) real, not weighted" : "(7.11) real, not weighted";
  return form.rigid ? "(7.18) real" : "(7.11) real";
}

double quantile(std::vector<double> values, double share) {
  std::ranges::sort(values);
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
}

/// Friction limits over the truth; seeds without a fit count as 0.
std::vector<double> limits(const RigTwo& rig, Form form) {
  std::vector<double> out;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const double ratio = limit_ratio(polluted(rig, seed), form);
    out.push_back(std::isfinite(ratio) ? ratio : 0.0);
  }
  std::printf("%s %s: limit over truth, 5 %% %.3f median %.3f 95 %% %.3f, within 15 %%: %d of %d\n", rig.name.c_str(), name(form),
              quantile(out, 0.05), quantile(out, 0.5), quantile(out, 0.95),
              static_cast<int>(std::ranges::count_if(out, [](double x) { return std::abs(x - 1.0) < 0.15; })),
              static_cast<int>(seeds));
  return out;
}

/// Median over seeds and levels of |Δ(k + id)|/|k + id| at the four smallest displacements.
double small_error(const RigTwo& rig, Form form) {
  const auto element = friction::make_element("ren", rig.element);
  std::vector<double> errors;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const friction::Curve found = equivalents(polluted(rig, seed), form);
    for (std::size_t i = 0; i < 4; ++i) {
      const friction::Equivalent exact = friction::equivalent(*element, found.u[i]);
      errors.push_back(std::hypot(found.value[i] - exact.stiffness, found.damping[i] - exact.damping) /
                       std::hypot(exact.stiffness, exact.damping));
    }
  }
  const double median = quantile(std::move(errors), 0.5);
  std::printf("%s %s: median error of k + id at small displacements %.3f\n", rig.name.c_str(), name(form), median);
  return median;
}

TEST(RigTwoSeeds, TheLimitIsWithinFifteenPercentByTheRigidReference) {
  for (const ProblemInfo& info : list_rig_two()) {
    const RigTwo rig = make_rig_two(info.name);
    const std::vector<double> reference = limits(rig, {});
    EXPECT_GE(std::ranges::count_if(reference, [](double x) { return std::abs(x - 1.0) < 0.15; }), 195);
    limits(rig, {.rigid = true, .real = false});
    limits(rig, {.rigid = true, .real = true, .relative = false});
    EXPECT_LT(small_error(rig, {}), 0.5 * small_error(rig, {.rigid = false, .real = true}));
    small_error(rig, {.rigid = true, .real = true, .relative = false});
    small_error(rig, {.rigid = true, .real = false});
  }
}

}  // namespace
}  // namespace jointid::problems
