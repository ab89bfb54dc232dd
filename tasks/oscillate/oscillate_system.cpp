#include "tasks/oscillate/oscillate_system.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/complex.hpp"
#include "dense/eigen.hpp"
#include "response/structure/modal_damping.hpp"

namespace jointid::tasks {
namespace {

using oscillation::Mechanics;

constexpr double degree = std::numbers::pi / 180.0;

/// A number that a sweep may vary.
struct Swept {
  const char* name;
  const char* unit;
  void (*set)(SystemSpec&, double);
};

constexpr std::array all_swept = {
    Swept{"velocity", "m/s", [](SystemSpec& s, double x) { s.velocity = x; }},
    Swept{"amplitude", "m", [](SystemSpec& s, double x) { s.amplitude = x; }},
    Swept{"frequency", "Hz", [](SystemSpec& s, double x) { s.frequency_hz = x; }},
    Swept{"damping", "", [](SystemSpec& s, double x) { s.damping = x; }},
    Swept{"normal", "N", [](SystemSpec& s, double x) { s.friction.normal = x; }},
    Swept{"kinetic", "", [](SystemSpec& s, double x) { s.friction.kinetic = x; }},
    Swept{"static", "", [](SystemSpec& s, double x) { s.friction.statical = x; }},
    Swept{"decay", "s/m", [](SystemSpec& s, double x) { s.friction.decay = x; }},
    Swept{"tilt", "deg", [](SystemSpec& s, double x) { s.friction.tilt = x * degree; }},
};

const Swept& swept(std::string_view name) {
  return *std::ranges::find_if(all_swept, [&](const Swept& each) { return name == each.name; });
}

Mechanics undamped(const SystemSpec& spec) {
  switch (spec.kind) {
    case SystemKind::belt_chain:
      return oscillation::mechanics(spec.chain);
    case SystemKind::cantilever:
      return oscillation::mechanics(spec.beam);
    case SystemKind::matrices:
      break;
  }
  return {spec.mass, {}, spec.stiffness, spec.contact, {}, {}};
}

Eigen::MatrixXd damping_of(const SystemSpec& spec, const Mechanics& m) {
  switch (spec.damping_kind) {
    case DampingKind::stiffness:
      break;
    case DampingKind::first_mode: {
      const double square = dense::symmetric_eigen(m.stiffness, m.mass).values(0);
      return (square > 0.0 ? 2.0 * spec.damping / std::sqrt(square) : 0.0) * m.stiffness;
    }
    case DampingKind::modal:
      return response::modal_damping(m.mass, m.stiffness, spec.damping);
  }
  return spec.damping * m.stiffness;
}

Eigen::RowVectorXd unit_row(Eigen::Index size, Eigen::Index place) { return Eigen::VectorXd::Unit(size, place).transpose(); }

}  // namespace

double SystemSpec::drive_amplitude() const {
  if (amplitudes.empty()) return amplitude;
  const auto above = std::ranges::lower_bound(amplitudes, frequency_hz, {}, [](const auto& row) { return row[0]; });
  if (above == amplitudes.begin()) return amplitudes.front()[1];
  if (above == amplitudes.end()) return amplitudes.back()[1];
  const auto& below = *(above - 1);
  return std::lerp(below[1], (*above)[1], (frequency_hz - below[0]) / ((*above)[0] - below[0]));
}

oscillation::ThickBeam thick_beam(const SystemSpec& spec) {
  const oscillation::Cantilever& beam = spec.beam;
  return {.length = beam.length,
          .width = beam.width,
          .thickness = beam.thickness,
          .youngs_modulus = beam.youngs_modulus,
          .density = beam.density,
          .poisson_ratio = *spec.poisson_ratio,
          .tip_mass = beam.tip_mass()};
}

std::vector<std::string> swept_names() {
  std::vector<std::string> out;
  for (const Swept& each : all_swept) out.emplace_back(each.name);
  return out;
}

std::string swept_unit(std::string_view name) { return swept(name).unit; }

void set_swept(SystemSpec& spec, std::string_view name, double value) { swept(name).set(spec, value); }

oscillation::Model model_of(const SystemSpec& spec) {
  Mechanics m = undamped(spec);
  m.damping = damping_of(spec, m);
  return {std::move(m), {spec.velocity, spec.drive_amplitude(), angular(spec.frequency_hz)}, spec.friction};
}

std::vector<SeenForm> seen_forms(const SystemSpec& spec) {
  std::vector<SeenForm> out;
  if (spec.kind == SystemKind::cantilever) {
    for (const double x : spec.points)
      out.push_back({fmt::format("y({:g})", x), "m", oscillation::displacement_row(spec.beam, x)});
    return out;
  }
  const Eigen::Index n = undamped(spec).contact.size();
  for (Eigen::Index i = 0; i < n; ++i) out.push_back({fmt::format("q{}", i + 1), "m", unit_row(n, i)});
  return out;
}

SeenForm judged_form(const SystemSpec& spec) {
  if (spec.kind == SystemKind::cantilever)
    return {fmt::format("strain({:g})", spec.strain_at), "m/m", oscillation::strain_row(spec.beam, spec.strain_at)};
  return {"contact", "m", undamped(spec).contact.transpose()};
}

}  // namespace jointid::tasks
