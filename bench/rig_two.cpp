// Friction limits that Ren's law gets from the FRFs of rig two (problems rig2 and rig2-264), over seeds of the errors of its
// tests. Prints the table of docs/loading-curves.md. Promised of (7.18) with real FRFs of the parts and relative residuals:
// 97.5 % of the limits are within 15 %, and k + id at small displacements has at most half the error that (7.11) leaves.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "bench/bench.hpp"
#include "friction/curve/equivalent.hpp"
#include "friction/law/law.hpp"
#include "friction/law/laws.hpp"
#include "tests/problems/rig_two_table.hpp"

namespace {

using namespace jointid;
using problems::Form, problems::RigTwo;

constexpr Form reference = {}, not_weighted = {.rigid = true, .real = true, .relative = false},
               as_measured = {.rigid = true, .real = false}, difference = {.rigid = false, .real = true};

const char* name(Form form) {
  if (!form.rigid) return "(7.11), (7.19), relative";
  if (!form.real) return "(7.18), relative, parts' FRFs as measured";
  return form.relative ? "(7.18), (7.19), relative (the written scene)" : "(7.18), (7.19), as printed";
}

/// The share of the limits within 15 % of the truth; a seed without a fit is not.
double share_of_limits(const RigTwo& rig, Form form, std::size_t seeds) {
  std::vector<double> limits;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const double ratio = limit_ratio(polluted(rig, seed), form);
    limits.push_back(std::isfinite(ratio) ? ratio : 0.0);
  }
  const auto within = std::ranges::count_if(limits, [](double x) { return std::abs(x - 1.0) < 0.15; });
  std::ranges::sort(limits);
  fmt::print("| {} | {} | {:.3f}, {:.3f}, {:.3f} | {} of {} |\n", rig.name, name(form), quantile(limits, 0.05),
             quantile(limits, 0.5), quantile(limits, 0.95), within, seeds);
  return static_cast<double>(within) / static_cast<double>(seeds);
}

/// Median over seeds and levels of |Δ(k + id)|/|k + id| at the four smallest displacements.
double small_error(const RigTwo& rig, Form form, std::size_t seeds) {
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
  fmt::print("  {} {}: median error of k + id at small displacements {:.3f}\n", rig.name, name(form), median(errors));
  return median(std::move(errors));
}

void measure(const bench::CommandLine& line, bench::Promises& promises) {
  const std::size_t seeds = line.count(0, 200, 20);
  for (const problems::ProblemInfo& info : problems::list_rig_two()) {
    const RigTwo rig = problems::make_rig_two(info.name);
    promises.at_least(rig.name + ": share of limits within 15 %", share_of_limits(rig, reference, seeds),
                      line.quick() ? bench::least_share(0.975, seeds) : 0.975);
    const double rigid = small_error(rig, reference, seeds), without = small_error(rig, difference, seeds);
    promises.at_most(rig.name + ": error at small displacements over that by (7.11)", rigid / without, 0.5);
    if (line.quick()) continue;
    for (const Form form : {not_weighted, as_measured}) {
      share_of_limits(rig, form, seeds);
      small_error(rig, form, seeds);
    }
  }
}

}  // namespace

int main(int argc, char** argv) { return bench::run(argc, argv, "[SEEDS]", measure); }
