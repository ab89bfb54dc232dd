#include "problems/case/modal_set.hpp"

#include <cmath>
#include <numbers>

#include "base/random.hpp"
#include "problems/case/case.hpp"

namespace jointid::problems {
namespace {

const std::vector<ProblemInfo> infos = {
    {"modes-pair", "modal fit: two modes 1 % apart with 0.1 % of critical damping, 4 × 2 FRFs"},
    {"modes-30", "modal fit: 30 modes with 0.4 to 1 % of critical damping, 12 × 3 FRFs"},
};

/// Modes over +Z coordinates of nodes 1, 2, … on a line.
Modes on_a_line(std::size_t points) {
  Modes modes;
  for (std::size_t i = 0; i < points; ++i) {
    const auto id = static_cast<std::int64_t>(i + 1);
    modes.nodes.push_back({id, {static_cast<double>(i) / static_cast<double>(points), 0.0, 0.0}});
    modes.dofs.push_back({id, frf::Direction::z, 1});
  }
  return modes;
}

ModalSet with_frfs(ModalSet set, std::size_t references, const Axis& axis) {
  ResponseRequest request;
  request.response = set.modes.dofs;
  request.reference.assign(set.modes.dofs.begin(), set.modes.dofs.begin() + static_cast<std::ptrdiff_t>(references));
  request.frequency_hz = frequencies(axis);
  set.clean = modal_response(set.modes, request);
  set.clean.header.file = set.name + ".h5";
  set.noise = {.kind = frf::NoiseKind::circular, .level = 0.01, .record_variance = true};
  return set;
}

ModalSet pair(const ProblemInfo& info) {
  ModalSet set{info.name, info.description, on_a_line(4), {}, {}};
  set.modes.frequency_hz = {100.0, 101.0};
  set.modes.loss_factor = {0.002, 0.002};
  set.modes.shapes = {1.0, 0.6, 0.8, -1.0, -0.5, 0.7, 0.3, 0.9};
  return with_frfs(std::move(set), 2, {.start_hz = 90.0, .step_hz = 0.02, .lines = 1051});
}

/// Shapes sin(rπx) at places without symmetry, one mode in each 30 Hz.
ModalSet thirty(const ProblemInfo& info) {
  ModalSet set{info.name, info.description, on_a_line(12), {}, {}};
  constexpr std::size_t count = 30;
  for (std::size_t r = 0; r < count; ++r) {
    const auto u = uniform_numbers({.seed = 30}, r);
    set.modes.frequency_hz.push_back(100.0 + 30.0 * (static_cast<double>(r) + 0.7 * (u[0] - 0.5)));
    set.modes.loss_factor.push_back(0.008 + 0.012 * u[1]);
  }
  for (std::size_t i = 0; i < set.modes.dofs.size(); ++i) {
    const double x = std::fmod(0.17 + 0.618033988749895 * static_cast<double>(i), 1.0);
    for (std::size_t r = 0; r < count; ++r) set.modes.shapes.push_back(std::sin(static_cast<double>(r + 1) * std::numbers::pi * x));
  }
  return with_frfs(std::move(set), 3, {.start_hz = 60.0, .step_hz = 1.0, .lines = 1000});
}

}  // namespace

std::vector<ProblemInfo> list_modal_sets() { return infos; }

ModalSet make_modal_set(const std::string& name) {
  if (name == infos[0].name) return pair(infos[0]);
  if (name == infos[1].name) return thirty(infos[1]);
  refuse_problem("there is no modal set '" + name + "'", name, {infos[0].name, infos[1].name});
}

frf::FrfSet polluted(const ModalSet& set, std::uint64_t seed, std::uint64_t trial) {
  return frf::polluted(set.clean, set.noise, seed, trial);
}

}  // namespace jointid::problems
