#include "report/phase_branch.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace jointid::report {
namespace {

constexpr double full_circle = 360.0;

/// Best first where several are crossed equally often.
constexpr std::array branch_ends = {180.0, 90.0,   -90.0, 135.0, -135.0, 45.0,   -45.0, 0.0,   105.0, -105.0, 75.0, -75.0,
                                    120.0, -120.0, 60.0,  -60.0, 150.0,  -150.0, 30.0,  -30.0, 165.0, -165.0, 15.0, -15.0};

}  // namespace

double within_branch(double phase_deg, double end_deg) {
  return phase_deg - full_circle * std::ceil((phase_deg - end_deg) / full_circle);
}

std::size_t crossings(const std::vector<double>& phase_deg, double end_deg) {
  std::size_t count = 0;
  double before = std::numeric_limits<double>::quiet_NaN();
  for (const double phase : phase_deg) {
    const double here = within_branch(phase, end_deg);
    if (std::abs(here - before) > 0.5 * full_circle) ++count;  // false for NaN
    before = here;
  }
  return count;
}

double branch_end_deg(std::span<const std::vector<double>> phases_deg) {
  std::size_t least = std::numeric_limits<std::size_t>::max();
  double best = branch_ends.front();
  for (const double end : branch_ends) {
    std::size_t count = 0;
    for (const std::vector<double>& phases : phases_deg) count += crossings(phases, end);
    if (count >= least) continue;
    least = count;
    best = end;
  }
  return best;
}

}  // namespace jointid::report
