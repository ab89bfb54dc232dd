#include "ident/judgement/measured_rectangle.hpp"

#include <algorithm>
#include <cmath>

#include "ident/variance/variances.hpp"

namespace jointid::ident {
namespace {

bool has_scatter(const frf::FrfSystem& system, const Scene& scene) {
  for (std::size_t s = 0; s < system.source_count(); ++s) {
    if (variance_origin(scene, system.source(s).header()) == VarianceOrigin::scatter) return true;
  }
  return false;
}

/// Some of the DOFs, spread over all.
Dofs sample_of(const Dofs& dofs, std::size_t most) {
  Dofs out;
  const std::size_t count = std::min(most, dofs.size());
  for (std::size_t i = 0; i < count; ++i) out.push_back(dofs[i * dofs.size() / count]);
  return out;
}

/// The relative noise that some FRFs of a system show between neighbouring lines, E|δ|²/|H|²: exceeded by a quarter of them.
/// Empty where most of them are not resolved.
std::optional<double> scattered_level(frf::FrfSystem& system, const Excerpt& of, const Scene& scene) {
  constexpr std::size_t most = 5;
  const std::vector<std::size_t>& lines = of.lines;
  const Dofs few_rows = sample_of(of.rows, most), few_columns = sample_of(of.columns, most);
  std::vector<Complex> values(lines.size() * few_rows.size() * few_columns.size()), noise(values.size());
  frf::BlockReader(system, few_rows, few_columns).read(lines, values);
  Variances variances(system, few_rows, few_columns, scene);
  variances.prepare(lines);
  std::size_t unresolved = 0;
  for (const FileVariances& file : variances.origins()) unresolved += file.unresolved;
  if (2 * unresolved > few_rows.size() * few_columns.size()) return std::nullopt;
  variances.read(lines, values, noise);
  std::vector<double> shares;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double share = (noise[i].real() + noise[i].imag()) / std::norm(values[i]);
    if (std::isfinite(share)) shares.push_back(share);
  }
  if (shares.empty()) return std::nullopt;
  const auto high = shares.begin() + static_cast<std::ptrdiff_t>(3 * shares.size() / 4);
  std::ranges::nth_element(shares, high);
  return *high;
}

}  // namespace

MeasuredRectangle read_rectangle(frf::FrfSystem& system, const Dofs& rows, const Dofs& columns, const Scene& scene,
                                 const std::vector<std::size_t>& lines) {
  MeasuredRectangle out{.values = std::vector<Complex>(lines.size() * rows.size() * columns.size()),
                        .variances = {},
                        .rows = rows.size(),
                        .columns = columns.size()};
  out.variances.resize(out.values.size());
  frf::BlockReader(system, rows, columns).read(lines, out.values);
  Variances variances(system, rows, columns, scene);
  if (variances.needs_prepare()) variances.prepare(lines);
  variances.read(lines, out.values, out.variances);
  return out;
}

std::vector<Line> spread_lines(const std::vector<Line>& all, std::size_t most) {
  std::vector<Line> out;
  const std::size_t count = std::min(most, all.size());
  for (std::size_t i = 0; i < count; ++i) out.push_back(all[(2 * i + 1) * all.size() / (2 * count)]);
  return out;
}

std::vector<std::size_t> lines_of(const std::vector<Line>& lines, std::size_t Line::*which) {
  std::vector<std::size_t> out;
  for (const Line& line : lines) out.push_back(line.*which);
  return out;
}

bool knows_noise(const Plan& plan) {
  return !has_scatter(*plan.substructures, plan.scene) && !has_scatter(*plan.assembly, plan.scene);
}

std::optional<Scene> scene_with_noise(const Plan& plan, const Excerpt& substructures, const Excerpt& assembly) {
  Scene scene = plan.scene;
  if (knows_noise(plan)) return scene;
  const auto parts = scattered_level(*plan.substructures, substructures, scene);
  const auto whole = scattered_level(*plan.assembly, assembly, scene);
  if (!parts || !whole) return std::nullopt;
  frf::NoiseModel model;
  model.kind = frf::NoiseKind::circular;
  model.level = std::min(0.9, std::sqrt(std::max(*parts, *whole)));
  scene.noise = NoiseSection{.model = frf::name(model.kind), .level = model.level, .frf_model = model};
  scene.identify.variance = VarianceChoice::automatic;
  return scene;
}

}  // namespace jointid::ident
