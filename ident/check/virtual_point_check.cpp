#include "ident/check/virtual_point_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/text.hpp"
#include "ident/check/test/checked_file.hpp"
#include "ident/plan/data_source.hpp"

namespace jointid::ident {
namespace {

constexpr std::size_t most_lines = 400;

/// The files as they were measured.
Scene without_virtual_points(Scene scene) {
  for (auto* files : {&scene.data.substructures, &scene.data.assembly}) {
    for (DataFile& file : *files) {
      file.virtual_points.clear();
      for (DataFile& run : file.repeats) run.virtual_points.clear();
    }
  }
  return scene;
}

/// Numbers of which those next to 0 and ±1 are these; of a direction near an axis.
virtualpoint::Vector rounded(const virtualpoint::Vector& direction) {
  constexpr double near = 0.03;
  virtualpoint::Vector out{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double whole = std::round(direction[i]);
    if (std::abs(direction[i] - whole) > near) return direction;
    out[i] = whole;
  }
  return out;
}

std::string vector_text(const virtualpoint::Vector& v) {
  const auto number = [](double x) {
    const double shown = std::round(x * 1e4) / 1e4;
    return shown == std::round(shown) ? fmt::format("{:.1f}", shown + 0.0) : fmt::format("{:g}", shown);
  };
  return "[" + number(v[0]) + ", " + number(v[1]) + ", " + number(v[2]) + "]";
}

bool is_opposite(const virtualpoint::WrongDirection& wrong) {
  constexpr double cosine = -0.996;  // 5 degrees
  return wrong.stated[0] * wrong.found[0] + wrong.stated[1] * wrong.found[1] + wrong.stated[2] * wrong.found[2] < cosine;
}

std::string file_name(const std::string& file) { return std::filesystem::path(file).filename().string(); }

Suspect suspect_of(const virtualpoint::Consistency& point, const virtualpoint::WrongDirection& wrong) {
  const bool sensor = wrong.side == virtualpoint::Side::sensors;
  const std::string dof = wrong.dof.name();
  const virtualpoint::Vector found = rounded(wrong.found);
  Suspect out{.kind = SuspectKind::direction,
              .file = point.file,
              .dofs = {wrong.dof},
              .evidence = {},
              .confidence = 1.0 - wrong.residual,
              .remedy = {}};
  out.evidence = fmt::format(
      "{}: without {} the other {} agree with the motion of {} {} times as well (residual); its FRFs are those of the "
      "direction {}, not of {}",
      point.point, dof, sensor ? "sensors" : "impacts", point.point, digits(1.0 / std::sqrt(wrong.residual)), vector_text(found),
      vector_text(wrong.stated));
  if (is_opposite(wrong)) {
    out.remedy =
        "[data.files.\"" + file_name(point.file) + "\"]\n" + (sensor ? "flip" : "flip_reference") + " = [\"" + dof + "\"]";
  } else {
    out.remedy = "[[virtual_points]]  # name = \"" + point.point + "\"\n" + (sensor ? "directions" : "impact_directions") +
                 " = { \"" + dof + "\" = " + vector_text(found) + " }";
  }
  return out;
}

}  // namespace

void check_virtual_points(const Scene& scene, const Control& control, CheckResult& result) {
  if (!has_virtual_points(scene)) return;
  std::vector<Suspect> found;
  const OpenedScene opened = open_scene(without_virtual_points(scene));
  for (const auto& [files, sources] : {std::pair(&scene.data.substructures, &opened.substructures),
                                       std::pair(&scene.data.assembly, &opened.assembly)}) {
    for (std::size_t i = 0; i < files->size(); ++i) {
      const DataFile& file = (*files)[i];
      if (file.virtual_points.empty()) continue;
      frf::FrfSource& source = *(*sources)[i];
      const std::vector<std::size_t> lines = lines_in_range(scene, source.header().frequency_hz, most_lines);
      for (const virtualpoint::VirtualPoint& point : file.virtual_points) {
        if (control.interrupted && control.interrupted()) return;
        virtualpoint::Consistency of = virtualpoint::consistency(source, point, lines);
        if (!of.sensors.any() && !of.impacts.any()) continue;
        for (const virtualpoint::WrongDirection& wrong : of.wrong) found.push_back(suspect_of(of, wrong));
        result.virtual_points.push_back(std::move(of));
      }
    }
  }
  if (found.empty()) return;
  result.verdict = Verdict::wrong;
  result.suspects.insert(result.suspects.begin(), found.begin(), found.end());
}

}  // namespace jointid::ident
