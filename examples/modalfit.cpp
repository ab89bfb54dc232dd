// Finds the modes behind FRFs in memory: two modes seen by three sensors, with noise of 0.1 % of the largest FRF.
#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>

#include "frf/noise/noise.hpp"
#include "tasks/modalfit/modal_run.hpp"

using namespace jointid;

struct TrueMode {
  double frequency_hz, damping;
  std::array<double, 3> shape;  // mass-normalised
};

int main() {
  const std::array<TrueMode, 2> modes = {{{40.0, 0.01, {0.5, 0.8, 0.3}}, {55.0, 0.02, {0.6, -0.2, -0.7}}}};
  frf::FrfSet set;
  set.header.file = "simulated";
  for (const int node : {1, 2, 3}) set.header.response.push_back({.node = node, .direction = frf::Direction::z});
  set.header.reference = {set.header.response.front()};
  for (double hz = 20.0; hz <= 80.0; hz += 0.1) {
    set.header.frequency_hz.push_back(hz);
    for (std::size_t r = 0; r < 3; ++r) {
      Complex h = 0.0;
      for (const TrueMode& mode : modes) {
        const double natural = angular(mode.frequency_hz), omega = angular(hz);
        h += mode.shape[r] * mode.shape[0] / Complex(natural * natural - omega * omega, 2.0 * mode.damping * natural * omega);
      }
      set.values.push_back(h);
    }
  }
  set = frf::polluted(set, {.kind = frf::NoiseKind::gaussian, .level = 0.001}, 1, 1);

  modalfit::FitOptions options;  // kind of modes, range, poles to refine; progress and a way to stop
  options.interrupted = [] { return false; };
  const tasks::ModalRun run = tasks::run_modal("simulated", set, options);

  std::cout << "status " << name(run.fit.status) << '\n';
  for (const modalfit::Mode& mode : run.fit.modes) {
    std::cout << mode.pole.frequency_hz << " Hz ± " << mode.frequency_deviation_hz << ", damping ratio " << mode.pole.damping
              << " ± " << mode.damping_deviation << '\n';
  }
  bool found = run.fit.modes.size() == modes.size();
  for (std::size_t i = 0; found && i < modes.size(); ++i) {
    const modalfit::Pole& pole = run.fit.modes[i].pole;
    found = std::abs(pole.frequency_hz - modes[i].frequency_hz) < 0.01 && std::abs(pole.damping - modes[i].damping) < 0.0005;
  }
  return is_usable(run.fit.status) && found ? EXIT_SUCCESS : EXIT_FAILURE;
}
