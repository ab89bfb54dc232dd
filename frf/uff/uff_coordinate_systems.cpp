#include "frf/uff/uff_coordinate_systems.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "base/statistics.hpp"
#include "frf/uff/uff_text.hpp"

namespace jointid::frf::uff {
namespace {

using Vector = CoordinateSystems::Vector;

constexpr std::size_t records = 6;  ///< of a system: label and kind, name, three axes, origin

[[noreturn]] void fail(const Dataset& dataset, const std::string& what) {
  dataset.place.fail("coordinate systems", what, "correct the dataset or leave it out");
}

std::array<double, 3> numbers_of(const Dataset& dataset, const std::string& line) {
  std::array<double, 3> out{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto value = parse_real(column(line, 25 * i, 25));
    if (!value || !std::isfinite(*value)) {
      fail(dataset, "'" + to_utf8(one_byte_per_column(trim(line))) + "' is not three numbers of 25 columns");
    }
    out[i] = *value;
  }
  return out;
}

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

bool are_orthonormal(const Axes& axes) {
  constexpr double tolerance = 1e-3;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k <= i; ++k) {
      if (std::abs(dot(axes[i], axes[k]) - (i == k ? 1.0 : 0.0)) > tolerance) return false;
    }
  }
  return true;
}

/// Σ local_i · axes_i
Vector combined(const Axes& axes, const Vector& local) {
  Vector out{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) out[k] += local[i] * axes[i][k];
  }
  return out;
}

}  // namespace

CoordinateSystems::CoordinateSystems(ByteFile& file, const std::vector<Dataset>& datasets, const UnitTable& units) {
  for (const Dataset& dataset : datasets) {
    if (dataset.number == 2420 && !dataset.binary) read(file, dataset, units.at(dataset).length);
  }
}

void CoordinateSystems::read(ByteFile& file, const Dataset& dataset, double length) {
  std::vector<std::string> lines;
  std::string_view line;
  file.seek(dataset.payload_begin);
  while (file.position() < dataset.payload_end && file.next_line(line)) lines.emplace_back(line);
  while (!lines.empty() && trim(lines.back()).empty()) lines.pop_back();
  constexpr std::size_t of_part = 2;
  if (lines.size() < of_part || (lines.size() - of_part) % records != 0) {
    fail(dataset, std::to_string(lines.size()) + " lines are not two of the part and six of each system");
  }
  for (std::size_t at = of_part; at < lines.size(); at += records) {
    const auto label = parse_integer(column(lines[at], 0, 10)), kind = parse_integer(column(lines[at], 10, 10));
    if (!label || !kind || *kind < 0 || *kind > 2) {
      fail(dataset, "'" + to_utf8(one_byte_per_column(trim(lines[at]))) + "' is not a label and a kind (0, 1 or 2)");
    }
    System system{static_cast<Kind>(*kind), {}, {}};
    for (std::size_t i = 0; i < 3; ++i) system.axes[i] = numbers_of(dataset, lines[at + 2 + i]);
    system.origin = numbers_of(dataset, lines[at + 5]);
    for (double& coordinate : system.origin) coordinate /= length;
    if (!are_orthonormal(system.axes)) {
      fail(dataset, "the axes of coordinate system " + std::to_string(*label) + " are not three unit vectors at right angles");
    }
    systems_.try_emplace(*label, system);
  }
}

const CoordinateSystems::System* CoordinateSystems::find(std::int64_t label) const {
  const auto found = systems_.find(label);
  return found == systems_.end() ? nullptr : &found->second;
}

std::optional<Vector> CoordinateSystems::global(std::int64_t label, const Vector& local, double length) const {
  if (is_global(label)) return Vector{local[0] / length, local[1] / length, local[2] / length};
  const System* system = find(label);
  if (system == nullptr) return std::nullopt;
  Vector straight = local;
  const double second = local[1] * std::numbers::pi / 180.0, third = local[2] * std::numbers::pi / 180.0;
  if (system->kind == Kind::cylindrical) straight = {local[0] * std::cos(second), local[0] * std::sin(second), local[2]};
  if (system->kind == Kind::spherical) {
    straight = {local[0] * std::sin(second) * std::cos(third), local[0] * std::sin(second) * std::sin(third),
                local[0] * std::cos(second)};
  }
  Vector out = combined(system->axes, straight);
  for (std::size_t k = 0; k < 3; ++k) out[k] = out[k] / length + system->origin[k];
  return out;
}

/// In the axes of the system itself, of a point in these.
Axes CoordinateSystems::local_axes(Kind kind, const Vector& local) {
  const double radius = std::hypot(local[0], local[1]);
  const double c = radius > 0.0 ? local[0] / radius : 1.0, s = radius > 0.0 ? local[1] / radius : 0.0;
  if (kind == Kind::cylindrical) return {{{c, s, 0.0}, {-s, c, 0.0}, {0.0, 0.0, 1.0}}};
  if (kind == Kind::cartesian) return global_axes;
  const double distance = std::hypot(radius, local[2]);
  const double st = distance > 0.0 ? radius / distance : 0.0, ct = distance > 0.0 ? local[2] / distance : 1.0;
  return {{{st * c, st * s, ct}, {ct * c, ct * s, -st}, {-s, c, 0.0}}};
}

std::optional<Axes> CoordinateSystems::axes(std::int64_t label, const Vector& position) const {
  if (is_global(label)) return std::nullopt;
  const System* system = find(label);
  if (system == nullptr) return Axes{{{nan, nan, nan}, {nan, nan, nan}, {nan, nan, nan}}};
  Vector off = position, local{};
  for (std::size_t k = 0; k < 3; ++k) off[k] -= system->origin[k];
  for (std::size_t i = 0; i < 3; ++i) local[i] = dot(system->axes[i], off);
  const Axes own = local_axes(system->kind, local);
  Axes out{};
  for (std::size_t i = 0; i < 3; ++i) out[i] = combined(system->axes, own[i]);
  return out == global_axes ? std::nullopt : std::optional(out);
}

}  // namespace jointid::frf::uff
