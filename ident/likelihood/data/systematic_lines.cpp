#include "ident/likelihood/data/systematic_lines.hpp"

#include <algorithm>
#include <cmath>

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
  plan_driving_points(substructures, false);
  plan_driving_points(assembly, true);
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
}

SystematicWay SystematicLines::way(std::size_t i, bool of_assembly, std::size_t row, std::size_t column) const {
  const auto [file, transposed] = origin(of_assembly, row, column);
  const std::size_t response = transposed ? column : row, reference = transposed ? row : column;
  SystematicWay out;
  for (const std::size_t u : plan_.of({of_assembly, file, false, coordinates_[response]})) {
    SystematicFactor factor{u, {}};
    if (unknowns_[u].kind == Systematic::mass) {
      const auto found = std::ranges::find_if(driving_points_, [&](const DrivingPoint& point) {
        return point.of_assembly == of_assembly && point.coordinate == response;
      });
      if (found == driving_points_.end()) continue;
      factor.driving = driving_[i][static_cast<std::size_t>(found - driving_points_.begin())];
      if (!std::isfinite(factor.driving.real())) continue;
    }
    out.factors.push_back(factor);
  }
  for (const std::size_t u : plan_.of({of_assembly, file, true, coordinates_[reference]})) out.factors.push_back({u, {}});
  return out;
}

/// As SymmetricFrfs averages: an average has both ways, and of copies the FRF back is taken.
std::vector<SystematicWay> SystematicLines::ways(std::size_t i, bool of_assembly, const Measured& measured, Element at) const {
  const bool there = origin(of_assembly, at.row, at.column).file != frf::npos;
  const bool back = origin(of_assembly, at.column, at.row).file != frf::npos;
  if (!measured.known() || (!there && !back)) return {};
  if (!measured.averaged) return {back ? way(i, of_assembly, at.column, at.row) : way(i, of_assembly, at.row, at.column)};
  std::vector<SystematicWay> both = {way(i, of_assembly, at.row, at.column), way(i, of_assembly, at.column, at.row)};
  for (SystematicWay& each : both) each.share = 0.5;
  return both;
}

std::shared_ptr<const SystematicFrfs> SystematicLines::of(std::size_t i, const LineLayout& layout,
                                                          const BothSystems<Measured>& measured) const {
  auto out = std::make_shared<SystematicFrfs>();
  std::size_t element = 0;
  const auto add = [&](bool of_assembly, Element at, double sign, double share) {
    const Measured& m = (of_assembly ? measured.assembly : measured.substructures).at(at.row, at.column);
    std::vector<SystematicWay> by = ways(i, of_assembly, m, at);
    if (has_factors(by)) out->push_back({element, sign, m.value, share, std::move(by)});
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
  return out;
}

}  // namespace jointid::ident
