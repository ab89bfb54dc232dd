#include "ident/likelihood/data/systematic_lines.hpp"

#include <algorithm>
#include <cmath>

#include "base/statistics.hpp"

namespace jointid::ident {
namespace {

std::vector<FrfOrigin> origins_of(const frf::FrfSystem& system, const Dofs& coordinates) {
  std::vector<FrfOrigin> out(coordinates.size() * coordinates.size());
  for (const frf::BlockPiece& piece : system.pieces(coordinates, coordinates)) {
    for (std::size_t r = 0; r < piece.responses.size(); ++r) {
      for (std::size_t c = 0; c < piece.references.size(); ++c) {
        FrfOrigin& of = out[piece.place(r, c, coordinates.size())];
        if (of.file == frf::npos) of = {piece.source, piece.transposed};
      }
    }
  }
  return out;
}

double total(Complex variance) { return variance.real() + variance.imag(); }

bool has_factors(const std::vector<SystematicWay>& ways) {
  return std::ranges::any_of(ways, [](const SystematicWay& way) { return !way.factors.empty(); });
}

}  // namespace

SystematicLines::SystematicLines(SystematicPlan plan, frf::FrfSystem& substructures, frf::FrfSystem& assembly,
                                 const Dofs& coordinates)
    : plan_(std::move(plan)),
      unknowns_(plan_.unknowns()),
      coordinates_(coordinates),
      origins_{origins_of(substructures, coordinates), origins_of(assembly, coordinates)} {
  plan_errors(substructures, false);
  plan_errors(assembly, true);
  plan_driving_points(substructures, false);
  plan_driving_points(assembly, true);
  plan_other_axes(substructures, false);
  plan_other_axes(assembly, true);
}

void SystematicLines::plan_errors(const frf::FrfSystem& system, bool of_assembly) {
  for (std::size_t file = 0; file < system.source_count(); ++file) {
    for (const bool is_reference : {false, true}) {
      for (const frf::Dof& coordinate : coordinates_) {
        errors_[of_assembly ? 1 : 0].push_back(plan_.of({of_assembly, file, is_reference, coordinate}));
      }
    }
  }
}

void SystematicLines::plan_other_axes(frf::FrfSystem& system, bool of_assembly) {
  for (const frf::Dof& coordinate : coordinates_) {
    for (std::size_t file = 0; file < system.source_count(); ++file) {
      for (const bool is_reference : {false, true}) {
        for (const std::size_t u : plan_.of({of_assembly, file, is_reference, coordinate})) {
          if (unknowns_[u].kind != Systematic::angle) continue;
          const Dofs other = {{coordinate.node, plan_.all()[u].towards}};
          const bool is_there = std::ranges::any_of(axes_, [&](const OtherAxis& axis) {
            return axis.of_assembly == of_assembly && axis.is_reference == is_reference && axis.dof == other.front();
          });
          if (is_there) continue;
          auto reader = is_reference ? std::make_unique<frf::BlockReader>(system, coordinates_, other)
                                     : std::make_unique<frf::BlockReader>(system, other, coordinates_);
          axes_.push_back({of_assembly, is_reference, other.front(), std::move(reader)});
        }
      }
    }
  }
}

void SystematicLines::read_other_axes(std::span<const std::size_t> substructure_lines, std::span<const std::size_t> assembly_lines) {
  const std::size_t before = other_axes_.size(), count = substructure_lines.size(), size = coordinates_.size();
  other_axes_.resize(before + count, std::vector<Complex>(axes_.size() * size));
  std::vector<Complex> values(count * size);
  for (std::size_t a = 0; a < axes_.size(); ++a) {
    axes_[a].reader->read(axes_[a].of_assembly ? assembly_lines : substructure_lines, values);
    for (std::size_t i = 0; i < count; ++i) std::copy_n(&values[i * size], size, &other_axes_[before + i][a * size]);
  }
}

/// Towards the positive axis, of the positive axis of the sensor.
Complex SystematicLines::along_other_axis(std::size_t i, const SensorRole& sensor, std::size_t unknown, std::size_t coordinate) const {
  const frf::Dof other{sensor.dof.node, plan_.all()[unknown].towards};
  const auto axis = std::ranges::find_if(axes_, [&](const OtherAxis& each) {
    return each.of_assembly == sensor.of_assembly && each.is_reference == sensor.is_reference && each.dof == other;
  });
  if (axis == axes_.end()) return 0.0;
  const auto a = static_cast<std::size_t>(axis - axes_.begin());
  return static_cast<double>(sensor.dof.sign) * other_axes_[i][a * coordinates_.size() + coordinate];
}

void SystematicLines::plan_driving_points(frf::FrfSystem& system, bool of_assembly) {
  for (std::size_t c = 0; c < coordinates_.size(); ++c) {
    const std::vector<std::size_t>& errors = plan_.of({of_assembly, origin(of_assembly, c, c).file, false, coordinates_[c]});
    if (std::ranges::none_of(errors, [&](std::size_t u) { return unknowns_[u].kind == Systematic::mass; })) continue;
    const Dofs point = {coordinates_[c]};
    driving_points_.push_back({of_assembly, c, std::make_unique<frf::BlockReader>(system, point, point)});
  }
}

void SystematicLines::read(std::span<const std::size_t> substructure_lines, std::span<const std::size_t> assembly_lines) {
  const std::size_t before = driving_.size(), count = substructure_lines.size();
  driving_.resize(before + count, std::vector<Complex>(driving_points_.size()));
  std::vector<Complex> values(count);
  for (std::size_t d = 0; d < driving_points_.size(); ++d) {
    driving_points_[d].reader->read(driving_points_[d].of_assembly ? assembly_lines : substructure_lines, values);
    for (std::size_t i = 0; i < count; ++i) driving_[before + i][d] = values[i];
  }
  read_other_axes(substructure_lines, assembly_lines);
}

SystematicFactor SystematicLines::mass_factor(std::size_t i, std::size_t unknown, const SensorRole& sensor,
                                              const MeasuredFrfs& measured) const {
  SystematicFactor out{unknown, nan};
  for (std::size_t d = 0; d < driving_points_.size(); ++d) {
    const std::size_t coordinate = driving_points_[d].coordinate;
    if (driving_points_[d].of_assembly != sensor.of_assembly || !coordinates_[coordinate].same_coordinate(sensor.dof)) continue;
    out.point = d;
    out.driving = driving_[i][d];
    const Measured& driving = measured.at(coordinate, coordinate);
    if (driving.known()) out.driving_variance = total(driving.variance);
  }
  return out;
}

/// Of a sensor at a coordinate that measured an FRF `value` with the coordinate `other`.
void SystematicLines::add_factors(std::size_t i, const SensorRole& sensor, std::size_t coordinate, std::size_t other,
                                  const MeasuredFrfs& measured, Complex value, const SlopeOf& slope, SystematicWay& out) const {
  for (const std::size_t u : errors_of(sensor, coordinate)) {
    SystematicFactor factor{u, {}};
    if (unknowns_[u].kind == Systematic::mass) factor = mass_factor(i, u, sensor, measured);
    if (unknowns_[u].kind == Systematic::angle) factor.driving = along_other_axis(i, sensor, u, other) / value;
    if (unknowns_[u].kind == Systematic::stretch) {
      const StretchFactor stretch = slope ? slope(sensor.of_assembly, {coordinate, other}) : StretchFactor{nan, nan};
      factor.driving = stretch.all;
      factor.own = stretch.own;
    }
    if (!std::isfinite(factor.driving.real())) continue;
    out.factors.push_back(factor);
    if (unknowns_[u].kind == Systematic::mass && coordinates_[other].same_coordinate(sensor.dof)) out.measures = factor.point;
  }
}

void SystematicLines::write_way(std::size_t i, bool of_assembly, const MeasuredFrfs& measured, Element at, const SlopeOf& slope,
                                SystematicWay& out) const {
  const auto [file, transposed] = origin(of_assembly, at.row, at.column);
  const std::size_t response = transposed ? at.column : at.row, reference = transposed ? at.row : at.column;
  const Complex value = measured.at(at.row, at.column).value;
  out.share = 1.0;
  out.factors.clear();
  out.measures = SystematicWay::none;
  add_factors(i, {of_assembly, file, false, coordinates_[response]}, response, reference, measured, value, slope, out);
  add_factors(i, {of_assembly, file, true, coordinates_[reference]}, reference, response, measured, value, slope, out);
}

/// As SymmetricFrfs averages: an average has both ways, and of copies the FRF back is taken.
void SystematicLines::write_ways(std::size_t i, bool of_assembly, const MeasuredFrfs& measured, Element at, const SlopeOf& slope,
                                 std::vector<SystematicWay>& out) const {
  const Element mirrored{at.column, at.row};
  const bool there = origin(of_assembly, at.row, at.column).file != frf::npos;
  const bool back = origin(of_assembly, at.column, at.row).file != frf::npos;
  const Measured& own = measured.at(at.row, at.column);
  const bool none = !own.known() || (!there && !back);
  out.resize(none ? 0 : own.averaged ? 2 : 1);
  if (none) return;
  write_way(i, of_assembly, measured, back && !own.averaged ? mirrored : at, slope, out.front());
  if (!own.averaged) return;
  write_way(i, of_assembly, measured, mirrored, slope, out.back());
  for (SystematicWay& each : out) each.share = 0.5;
}

void SystematicLines::write(std::size_t i, const LineLayout& layout, const BothMeasured& measured, const SlopeOf& slope,
                            SystematicFrfs& out) const {
  std::size_t element = 0, count = 0;
  const auto add = [&](bool of_assembly, Element at, double sign, double share) {
    const MeasuredFrfs& frfs = of_assembly ? measured.assembly : measured.substructures;
    if (count == out.size()) out.emplace_back();
    SystematicFrf& frf = out[count];
    write_ways(i, of_assembly, frfs, at, slope, frf.ways);
    if (!has_factors(frf.ways)) return;
    frf.element = element;
    frf.sign = sign;
    frf.value = frfs.at(at.row, at.column).value;
    frf.share = share;
    ++count;
  };
  for_each_element(layout, [&](ElementOf of, Element at) {
    if (of != ElementOf::difference) {
      add(of == ElementOf::assembly, at, 1.0, 1.0);
    } else {
      const Measured &sub = measured.substructures.at(at.row, at.column), &whole = measured.assembly.at(at.row, at.column);
      if (sub.known() && whole.known()) {
        const double own = sub.is_zero() ? 0.0 : total(sub.variance), both = own + total(whole.variance);
        const double share = both > 0.0 ? own / both : 0.5;
        add(false, at, 1.0, share);
        add(true, at, -1.0, 1.0 - share);
      }
    }
    ++element;
  });
  out.resize(count);
}

std::shared_ptr<const SystematicFrfs> SystematicLines::of(std::size_t i, const LineLayout& layout, const BothMeasured& measured,
                                                          const SlopeOf& slope) const {
  auto out = std::make_shared<SystematicFrfs>();
  write(i, layout, measured, slope, *out);
  return out;
}

}  // namespace jointid::ident
