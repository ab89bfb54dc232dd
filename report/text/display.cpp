#include "report/text/display.hpp"

#include <array>
#include <cmath>

#include "frf/set/line_scale.hpp"
#include "restrictions/unit.hpp"

namespace jointid::report {
namespace {

constexpr double mm_per_m = 1e3;

struct UnitPair {
  const char *si, *shown;
  double factor;  ///< shown = factor · SI
};

constexpr std::array unit_pairs = {UnitPair{"m", "mm", mm_per_m},
                                   UnitPair{"N/m", "N/mm", 1.0 / mm_per_m},
                                   UnitPair{"N*s/m", "N*s/mm", 1.0 / mm_per_m},
                                   UnitPair{"N*m/rad", "N*mm/rad", mm_per_m},
                                   UnitPair{"N*m*s/rad", "N*mm*s/rad", mm_per_m},
                                   UnitPair{"kg*m", "kg*mm", mm_per_m},
                                   UnitPair{"kg*m^2", "kg*mm^2", mm_per_m* mm_per_m}};

void scale(std::optional<double>& value, double factor) {
  if (value) *value *= factor;
}

/// The factor by which the estimate was multiplied.
double convert(const Display& display, ident::Estimate& estimate) {
  const auto [unit, factor] = shown_unit(display, estimate.unit);
  if (factor == 1.0) return factor;
  estimate.unit = unit;
  estimate.value *= factor;
  for (auto* error : {&estimate.std_error, &estimate.rounding, &estimate.error_estimate, &estimate.bias}) scale(*error, factor);
  if (estimate.ci95) estimate.ci95 = {(*estimate.ci95)[0] * factor, (*estimate.ci95)[1] * factor};
  return factor;
}

double element_factor(restrictions::Kind kind, const frf::Dof& row, const frf::Dof& column) {
  const int power = restrictions::length_power(row, column) + (kind == restrictions::Kind::mass ? 1 : 0);
  return std::pow(mm_per_m, power);
}

}  // namespace

ident::Matrices in_units_of(const Display& display, ident::Matrices matrices, const ident::Dofs& dofs) {
  if (!display.millimetres) return matrices;
  for (auto& [kind, rows] : matrices) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      for (std::size_t j = 0; j < rows[i].size(); ++j) rows[i][j] *= element_factor(kind, dofs[i], dofs[j]);
    }
  }
  return matrices;
}

ident::Solution in_units_of(const Display& display, ident::Solution solution) {
  if (!display.millimetres) return solution;
  for (std::size_t i = 0; i < solution.unknowns.size(); ++i) {
    const double factor = convert(display, solution.unknowns[i]);
    if (!solution.search) continue;
    for (auto& minimum : solution.search->minima) minimum.values[i] *= factor;
  }
  for (ident::BandMatrices& band : solution.bands) {
    band.matrices = in_units_of(display, std::move(band.matrices), solution.dofs);
    band.errors = in_units_of(display, std::move(band.errors), solution.dofs);
  }
  return solution;
}

tasks::Regenerated in_units_of(const Display& display, tasks::Regenerated frfs) {
  for (tasks::RegeneratedFrf& frf : frfs.frfs) {
    const double factor = frf_factor(display, frf.entry.response, frf.entry.reference);
    for (std::size_t line = 0; line < frfs.frequency_hz.size(); ++line) {
      const auto of_line = frf::LineScale::from_receptance(display.quantity, frfs.frequency_hz[line]);
      frf.measured[line] = factor * of_line.value(frf.measured[line]);
      frf.predicted[line] = factor * of_line.value(frf.predicted[line]);
    }
  }
  return frfs;
}

double frf_factor(const Display& display, const frf::Dof& response, const frf::Dof& reference) {
  if (!display.millimetres) return 1.0;
  return (response.is_rotation() ? 1.0 : mm_per_m) / (reference.is_rotation() ? mm_per_m : 1.0);
}

ShownUnit shown_unit(const Display& display, const std::string& si) {
  for (const UnitPair& pair : unit_pairs) {
    if (display.millimetres && si == pair.si) return {pair.shown, pair.factor};
  }
  return {si, 1.0};
}

std::string units_text(const Display& display) { return display.millimetres ? "N, mm, s" : "SI units"; }

std::string frf_label(const Display& display, const frf::Dof& response, const frf::Dof& reference) {
  const std::string length = display.millimetres ? "mm" : "m";
  const std::string rate = display.quantity == frf::Quantity::receptance ? "" : display.quantity == frf::Quantity::mobility ? "/s" : "/s²";
  return frf::name(display.quantity) + " (" + (response.is_rotation() ? "rad" : length) + rate +
         (reference.is_rotation() ? "/(N·" + length + "))" : "/N)");
}

}  // namespace jointid::report
