// Fits of friction laws to a loading curve of 200 points with 1 % noise (Table 2.1, row 1): median time of 101 fits, beside the
// error of the parameters against the truth and the distance of the minimum from that of the thesis's pattern search. Promised:
// a closed-form law needs at most 5 ms and ends at most 1e-6 above the minimum of the pattern search.
#include <fmt/core.h>

#include <string>
#include <vector>

#include "bench/bench.hpp"
#include "friction/fit/fit.hpp"
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
    times.push_back(1e3 * bench::seconds([&] { out.fit = friction::fit(std::span(&curve, 1), family, options); }));
  }
  out.milliseconds = median(times);
  return out;
}

void row(const friction::Curve& curve, const std::string& law, bool quick, bench::Promises& promises) {
  const Timed fast = timed(curve, friction::family(law), {}, quick ? 3 : 101);
  const Timed thesis = timed(curve, friction::family(law), {.minimiser = friction::Minimiser::pattern}, quick ? 1 : 5);
  const double above = fast.fit.weighted_sum / thesis.fit.weighted_sum - 1.0;
  fmt::print("{:10} {:8.3f} {:10} {:10.3f} {:12.1e} {:12.2e} {:10.1f}\n", law, fast.milliseconds, fast.fit.iterations,
             thesis.milliseconds, above, fast.fit.objective, fast.fit.aic);
  promises.speed_at_most(law + ": ms", fast.milliseconds, 5.0);
  promises.at_most(law + ": sum above that of the pattern search", above, 1e-6);
}

void measure(const bench::CommandLine& line, bench::Promises& promises) {
  const auto* steel = problems::find_loading_curve("table2.1-1");
  const friction::Curve curve = problems::make_curve(*steel, 200, 0.01, 1);
  fmt::print("{}, 200 points, 1 % noise\n", steel->description);
  fmt::print("law          fit ms iterations pattern ms  above its sum   ΔE (2.58b)        AIC\n");
  for (const std::string& law : friction::fitted_laws()) row(curve, law, line.quick(), promises);
  const auto* ring = problems::find_loading_curve("table2.4-2");
  const friction::Curve torque = problems::make_curve(*ring, 200, 0.01, 1);
  const Timed rotary =
      timed(torque, friction::ring_family("ren", ring->ring->inner, ring->ring->outer), {}, line.quick() ? 1 : 11);
  fmt::print("rotary ren {:8.3f} {:10}\n", rotary.milliseconds, rotary.fit.iterations);
  promises.holds("rotary ren: the fit is usable", rotary.fit.status == Status::ok);
}

}  // namespace

int main(int argc, char** argv) { return bench::run(argc, argv, "", measure); }
