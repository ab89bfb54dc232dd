#include "ident/plan/data_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "base/text.hpp"
#include "ident/scene/scene_failure.hpp"

namespace jointid::ident {
namespace {

bool has_any(const frf::FrfHeader& header, const Dofs& dofs) {
  return std::ranges::any_of(dofs, [&](const frf::Dof& dof) { return frf::has(header.response, dof) || frf::has(header.reference, dof); });
}

/// "1:+Y, 2:+Y and 3 more"
std::string listed(const Dofs& dofs) {
  constexpr std::size_t most = 8;
  std::string text = comma_list(std::span(dofs).first(std::min(most, dofs.size())), &frf::Dof::name);
  if (dofs.size() > most) text += fmt::format(" and {} more", dofs.size() - most);
  return text;
}

/// Coordinates of a system in either role.
Dofs all_coordinates(const frf::FrfSystem& system) {
  Dofs dofs = system.responses();
  for (const frf::Dof& dof : system.references()) {
    if (!frf::has(dofs, dof)) dofs.push_back(dof);
  }
  return dofs;
}

/// Those of `dofs` that are not in `others`, nor coupled beforehand.
Dofs without_counterpart(const Dofs& dofs, const Dofs& others, const CoupleFirst& coupled) {
  Dofs alone;
  for (const frf::Dof& dof : dofs) {
    const bool is_coupled = frf::has(coupled.hidden, dof) || std::ranges::any_of(coupled.pairs, [&](const auto& pair) {
                              return pair[0].same_coordinate(dof) || pair[1].same_coordinate(dof);
                            });
    if (!is_coupled && !frf::has(others, dof)) alone.push_back(dof);
  }
  return alone;
}

/// Labels are where mistakes are: every coordinate of the assembly is one of a part.
void warn_of_counterparts(const Plan& plan, DataDoubts& out) {
  const Dofs parts = all_coordinates(*plan.substructures), assembly = all_coordinates(*plan.assembly);
  const Dofs strange = without_counterpart(assembly, parts, plan.scene.couple_first);
  if (!strange.empty()) {
    out.warnings.push_back("No substructure has " + listed(strange) + " of the assembly: not used. Look at the labels.");
  }
  const Dofs further = without_counterpart(without_counterpart(parts, assembly, plan.scene.couple_first), plan.coordinates.joint, {});
  if (!further.empty()) out.notes.push_back("The assembly does not have " + listed(further) + " of the substructures: not used.");
  Dofs other_role;
  for (const frf::Dof& dof : plan.assembly->responses()) {
    if (frf::has(parts, dof) && !frf::has(plan.substructures->responses(), dof)) other_role.push_back(dof);
  }
  for (const frf::Dof& dof : plan.assembly->references()) {
    if (frf::has(parts, dof) && !frf::has(plan.substructures->references(), dof) && !frf::has(other_role, dof)) other_role.push_back(dof);
  }
  if (!other_role.empty()) {
    out.notes.push_back(listed(other_role) + " of the assembly are in the substructures in the other role only, response or reference; " +
                         "reciprocity = true of [data] would use them.");
  }
}

/// Universal files keep five digits of the spacing of their lines.
constexpr double rounded_axis = 6e-5;

/// Two frequencies of lines that are taken for the same, and whose they are.
struct AxisDifference {
  double share = 0.0, one = 0.0, other = 0.0;  ///< Hz
  std::string file, other_file;

  void add(double first, double second, const std::string& of_first, const std::string& of_second) {
    const double difference = std::abs(first - second) / std::max(first, second);
    if (difference > share) *this = {difference, first, second, of_first, of_second};
  }
};

void compare_sources(const frf::FrfSystem& system, AxisDifference& worst) {
  const frf::FrfHeader& first = system.source(0).header();
  for (std::size_t s = 1; s < system.source_count(); ++s) {
    const frf::FrfHeader& header = system.source(s).header();
    for (std::size_t line = 0; line < system.frequency_hz().size(); ++line) {
      worst.add(first.frequency_hz[system.source_line(0, line)], header.frequency_hz[system.source_line(s, line)], first.file, header.file);
    }
  }
}

void warn_of_axes(const Plan& plan, DataDoubts& out) {
  AxisDifference worst;
  compare_sources(*plan.substructures, worst);
  compare_sources(*plan.assembly, worst);
  const std::string& part = plan.substructures->source(0).header().file;
  const std::string& whole = plan.assembly->source(0).header().file;
  for (const Line& line : plan.lines) {
    worst.add(plan.assembly->frequency_hz()[line.assembly], plan.substructures->frequency_hz()[line.substructures], whole, part);
  }
  if (worst.share <= rounded_axis) return;
  out.warnings.push_back(
      fmt::format("{:.9g} Hz of {} and {:.9g} Hz of {} are taken for the same line, {:.2g} % apart: measure on one axis, or give "
                  "frequency_scale under [data.files.\"NAME\"] where a clock is wrong.",
                  worst.one, worst.file, worst.other, worst.other_file, 100.0 * worst.share));
}

void warn_of_lines(const Plan& plan, DataDoubts& out) {
  if (plan.lines.size() > 1 || plan.columns->size() < 2) return;
  out.warnings.push_back(fmt::format("All {} unknowns come from one frequency line, {:.9g} Hz: no other line tests them.",
                                     plan.columns->size(), plan.lines.front().frequency_hz));
}

void warn_of_doubts(const frf::FrfSystem& system, std::vector<std::string>& warnings) {
  for (std::size_t s = 0; s < system.source_count(); ++s) {
    const frf::FrfHeader& header = system.source(s).header();
    for (const std::string& doubt : header.doubts) warnings.push_back(header.file + ": " + doubt + ".");
  }
}

}  // namespace

void require_both_sides(const Plan& plan) {
  const frf::FrfSystem& parts = *plan.substructures;
  if (parts.source_count() < 2) return;
  for (std::size_t s = 0; s < parts.source_count(); ++s) {
    const frf::FrfHeader& header = parts.source(s).header();
    if (has_any(header, plan.coordinates.joint) || !has_any(header, all_coordinates(*plan.assembly))) continue;
    fail(plan.scene, "[joint] dofs", "none of them is in " + header.file + ": the joint would not hold that part, but the others to ground",
         "name the DOFs on both sides of the joint, or leave out that file");
  }
}

DataDoubts doubts_of_data(const Plan& plan) {
  DataDoubts out;
  warn_of_counterparts(plan, out);
  warn_of_axes(plan, out);
  warn_of_lines(plan, out);
  warn_of_doubts(*plan.substructures, out.warnings);
  warn_of_doubts(*plan.assembly, out.warnings);
  return out;
}

}  // namespace jointid::ident
