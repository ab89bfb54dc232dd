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

/// Without blank ones at the end: names may be blank.
std::vector<std::string> lines_of(ByteFile& file, const Dataset& dataset) {
  std::vector<std::string> lines;
  std::string_view line;
  file.seek(dataset.payload_begin);
  while (file.position() < dataset.payload_end && file.next_line(line)) lines.emplace_back(line);
  while (!lines.empty() && trim(lines.back()).empty()) lines.pop_back();
  return lines;
}

std::array<double, 3> numbers_of(const Dataset& dataset, const std::string& line) {
  std::array<double, 3> out{};
  const auto texts = three_fields(line, 0, 25);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto value = parse_real(texts[i]);
    if (!value || !std::isfinite(*value)) {
      fail(dataset, "'" + to_utf8(one_byte_per_column(trim(line))) + "' is not three numbers of 25 columns");
    }
    out[i] = *value;
  }
  return out;
}

Vector difference(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
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

/// X towards the second point, Z towards the side of the third; empty where they do not define a plane.
std::optional<Axes> axes_through(const std::array<Vector, 3>& points) {
  Vector x = difference(points[1], points[0]), y = cross(difference(points[2], points[0]), x);
  const double along = std::sqrt(dot(x, x)), across = std::sqrt(dot(y, y));
  if (!(along > 0.0) || !(across > 1e-6 * along * along)) return std::nullopt;
  for (std::size_t k = 0; k < 3; ++k) {
    x[k] /= along;
    y[k] /= across;
  }
  return Axes{x, y, cross(x, y)};
}

}  // namespace

CoordinateSystems::CoordinateSystems(ByteFile& file, const std::vector<Dataset>& datasets, const UnitTable& units) {
  for (const Dataset& dataset : datasets) {
    if (dataset.number == 2420 && !dataset.binary) read(file, dataset, units.at(dataset).length);
  }
  std::vector<Points> waiting;
  for (const Dataset& dataset : datasets) {
    if (dataset.number == 18 && !dataset.binary) read_points(file, dataset, units.at(dataset).length, waiting);
  }
  place_all(std::move(waiting));
}

/// A reference may come behind the systems that are defined in it. Where no system has label 1, it is the global one.
void CoordinateSystems::place_all(std::vector<Points> waiting) {
  const bool own_1 = !is_global(1) || std::ranges::find(waiting, 1, &Points::label) != waiting.end();
  for (Points& points : waiting) {
    if (points.reference == points.label || (points.reference == 1 && !own_1)) points.reference = 0;
  }
  for (bool placed = true; placed && !waiting.empty();)
    placed = std::erase_if(waiting, [&](const Points& points) { return place(points); }) > 0;
  for (const Points& points : waiting) not_described_.insert(points.label);
}

void CoordinateSystems::read_points(ByteFile& file, const Dataset& dataset, double length, std::vector<Points>& waiting) {
  constexpr std::size_t of_system = 4, width = 13;  // lines: numbers, name, six coordinates, three
  const std::vector<std::string> lines = lines_of(file, dataset);
  if (lines.size() % of_system != 0) fail(dataset, std::to_string(lines.size()) + " lines are not four of each system");
  for (std::size_t at = 0; at < lines.size(); at += of_system) {
    std::array<std::int64_t, 5> fields{};
    for (std::size_t i = 0; i < fields.size(); ++i) {
      const auto value = parse_integer(column(lines[at], 10 * i, 10));
      if (!value || (i == 1 && (*value < 0 || *value > 2)))
        fail(dataset, "'" + to_utf8(one_byte_per_column(trim(lines[at]))) +
                          "' is not a label, a kind (0, 1 or 2), a reference, a colour and a method");
      fields[i] = *value;
    }
    Points points{&dataset, fields[0], fields[2], static_cast<Kind>(fields[1]), {}};
    for (std::size_t i = 0; i < 9; ++i) {
      const auto value = parse_real(column(lines[at + 2 + i / 6], width * (i % 6), width));
      if (!value || !std::isfinite(*value))
        fail(dataset, "the points of coordinate system " + std::to_string(points.label) + " are not nine numbers of 13 columns");
      points.points[i / 3][i % 3] = *value / length;
    }
    const bool known = systems_.contains(points.label);
    if (!known && fields[4] <= 1) waiting.push_back(points);
    if (!known && fields[4] > 1) not_described_.insert(points.label);
  }
}

/// False while its reference is not there, and for one in a reference that is curved.
bool CoordinateSystems::place(const Points& points) {
  const auto axes = axes_through(points.points);
  if (!axes)
    fail(*points.dataset, "the three points of coordinate system " + std::to_string(points.label) + " do not define a plane");
  System system{points.kind, *axes, points.points[0]};
  const System* reference = points.reference == 0 ? nullptr : find(points.reference);
  if (points.reference != 0 && reference == nullptr) return false;
  if (reference != nullptr) {
    if (reference->kind != Kind::cartesian) return false;
    for (std::size_t i = 0; i < 3; ++i) system.axes[i] = combined(reference->axes, (*axes)[i]);
    system.origin = combined(reference->axes, points.points[0]);
    for (std::size_t k = 0; k < 3; ++k) system.origin[k] += reference->origin[k];
  }
  systems_.try_emplace(points.label, system);
  return true;
}

void CoordinateSystems::read(ByteFile& file, const Dataset& dataset, double length) {
  const std::vector<std::string> lines = lines_of(file, dataset);
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
