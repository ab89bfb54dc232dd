// Fits of friction laws to a loading curve of 200 points with 1 % noise (Table 2.1, row 1): median time of 101 fits, beside the
// error of the parameters against the truth and the distance of the minimum from that of the thesis's pattern search. Returns 1
// when a closed-form law needs 5 ms or more, or ends more than 1e-6 above the minimum of the pattern search.
//   bench_loading_curve
#include <fmt/format.h>

#include <chrono>
#include <string>
#include <vector>

#include "friction/fit/fit.hpp"
#include "measure.hpp"
#include "problems/thesis/loading_curves.hpp"

namespace {

using namespace jointid;

struct Timed {
  friction::Fit fit;
  double milliseconds = 0.0;
};

Timed timed(const friction::Curve& curve, const friction::Family& family, const friction::FitOptions& options, int repetitions) {
  Timed out;
  std::vector<double> times;
  for (int i = 0; i < repetitions; ++i) {
    const auto start = std::chrono::steady_clock::now();
    out.fit = friction::fit(std::span(&curve, 1), family, options);
    times.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
  }
  out.milliseconds = bench::median(times);
  return out;
}

/// Whether the law keeps to the time and to the minimum.
bool row(const friction::Curve& curve, const std::string& law) {
  const Timed fast = timed(curve, friction::family(law), {}, 101);
  const Timed thesis = timed(curve, friction::family(law), {.minimiser = friction::Minimiser::pattern}, 5);
  const double above = fast.fit.weighted_sum / thesis.fit.weighted_sum - 1.0;
  fmt::print("{:10} {:8.3f} {:10} {:10.3f} {:12.1e} {:12.2e} {:10.1f}\n", law, fast.milliseconds, fast.fit.iterations,
             thesis.milliseconds, above, fast.fit.objective, fast.fit.aic);
  return fast.milliseconds < 5.0 && above < 1e-6;
}

}  // namespace

int main() {
  const auto* steel = problems::find_loading_curve("table2.1-1");
  const friction::Curve curve = problems::make_curve(*steel, 200, 0.01, 1);
  fmt::print("{}, 200 points, 1 % noise\n", steel->description);
  fmt::print("law          fit ms iterations pattern ms  above its sum   ΔE (2.58b)        AIC\n");
  bool good = true;
  for (const std::string& law : friction::fitted_laws()) good = row(curve, law) && good;
  const auto* ring = problems::find_loading_curve("table2.4-2");
  const friction::Curve torque = problems::make_curve(*ring, 200, 0.01, 1);
  const Timed rotary = timed(torque, friction::ring_family("ren", ring->ring->inner, ring->ring->outer), {}, 11);
  fmt::print("rotary ren {:8.3f} {:10}\n", rotary.milliseconds, rotary.fit.iterations);
  return good ? 0 : 1;
}
