// Fits friction laws to a loading curve in memory: an elastic, perfectly plastic joint of 10 N/µm that slips at 200 N.
#include <cmath>
#include <cstdlib>
#include <iostream>

#include "friction/curve/curve.hpp"
#include "tasks/loading_curve/loading_curve_fit.hpp"

using namespace jointid;

int main() {
  friction::Record record;  // displacements in m, forces in N
  for (int i = 1; i <= 60; ++i) {
    const double u = 1e-6 * i;
    record.displacement.push_back(u);
    record.force.push_back(std::min(1e7 * u, 200.0) + 0.5 * std::sin(1.7 * i));  // what a sensor adds
  }
  tasks::LoadingCurveData data;
  data.curves = {friction::loading_curve("rig", record)};

  tasks::LoadingCurveTask task;
  task.laws = {"bilinear", "ren", "spring"};
  tasks::FittingWatch watch;
  watch.progress = [](const std::string& stage) { std::cout << stage << '\n'; };
  watch.interrupted = [] { return false; };
  const tasks::LoadingCurveResult result = tasks::fit_loading_curves(data, task, watch);

  for (const friction::Fit& fit : result.fits) std::cout << fit.law << ": AIC " << fit.aic << '\n';
  const friction::Fit& best = result.fits.front();
  const friction::CurveFit& curve = best.curves.front();
  std::cout << "best " << best.law << ": " << curve.stiffness.value << ' ' << curve.stiffness.unit << ", slips at "
            << curve.limit.value << ' ' << curve.limit.unit << '\n';
  const bool found =
      best.law == "bilinear" && std::abs(curve.stiffness.value - 1e7) < 1e5 && std::abs(curve.limit.value - 200.0) < 2.0;
  return tasks::some_usable(result) && found ? EXIT_SUCCESS : EXIT_FAILURE;
}
