#include "tasks/response/read_response_scene.hpp"

#include <algorithm>
#include <numbers>

#include "ident/scene/scene_sections.hpp"
#include "scene/document.hpp"
#include "scene/text.hpp"
#include "tasks/response/response_sections.hpp"
#include "tasks/response/scene_values.hpp"

namespace jointid::tasks {
namespace {

const std::vector<std::string> methods = {"sweep", "arc_length"};

/// [[harmonic, share, phase in degrees], …]: Re(share e^{i phase} e^{inωt}).
response::Excitation read_components(const scene::Item& item) {
  std::vector<std::pair<int, Complex>> parts;
  for (const scene::Item& one : item.list_not_empty()) {
    const std::vector<scene::Item> row = one.list();
    if (row.size() != 3) one.fail("a component is [harmonic, share, phase in degrees]");
    const int harmonic = row[0].whole(0, 1000);
    parts.emplace_back(harmonic, std::polar(1.0, row[2].number() * std::numbers::pi / 180.0) * row[1].number());
  }
  std::ranges::sort(parts, {}, &std::pair<int, Complex>::first);
  response::Excitation force = {{}, Eigen::MatrixXcd(at(parts.size()), 1)};
  for (const auto& [harmonic, share] : parts) {
    if (!force.harmonics.empty() && force.harmonics.back() == harmonic)
      item.fail("harmonic " + std::to_string(harmonic) + " occurs twice");
    force.amplitudes(at(force.harmonics.size()), 0) = share;
    force.harmonics.push_back(harmonic);
  }
  return force;
}

void read_force(const scene::Item& item, ResponseScene& scene) {
  const scene::Table table = item.table({"dof", "amplitudes", "components"});
  scene.force_dof = read_dof(table.require("dof"), scene);
  for (const scene::Item& level : table.require("amplitudes").list_not_empty()) scene.levels.push_back(level.positive());
  const auto components = table.find("components");
  scene.force = components ? read_components(*components) : response::Excitation::single(1.0);
}

void read_frequencies(const scene::Item& item, ResponseScene& scene) {
  const scene::Table table = item.table({"range", "values", "points", "modal_model"});
  const auto range = table.find("range"), values = table.find("values"), points = table.find("points");
  if (range && values) item.fail("there are both range and values", "remove one");
  if (range) scene.range_hz = range->interval();
  if (values) {
    for (const scene::Item& value : values->list_not_empty()) scene.values_hz.push_back(value.positive());
  }
  if (const auto modal = table.find("modal_model")) {
    scene.modal_model = modal->boolean();
    if (scene.modal_model && coordinates(scene) > 0) modal->fail("matrices need no modal model", "remove it");
    if (scene.modal_model && !range && !values)
      item.fail("there are neither range nor values", "modal models have no lines of their own");
  }
  if (points) {
    if ((coordinates(scene) == 0 && !scene.modal_model) || !range)
      points->fail("points belong to a range of a structure with matrices, or of modal models",
                   "remove it: the lines of the files count");
    scene.points = static_cast<std::size_t>(points->whole(2, 1000000));
  }
  if (coordinates(scene) > 0 && !range && !values) item.fail("there are neither range nor values");
  if (coordinates(scene) > 0 && range && (*scene.range_hz)[0] <= 0.0)
    range->fail("the range begins at 0 Hz, where nothing vibrates", "begin above it");
}

void read_response(const scene::Item& item, ResponseScene& scene) {
  const scene::Table table = item.table({"dofs", "harmonics", "tolerance", "largest_harmonic", "method", "stability"});
  for (const scene::Item& dof : table.require("dofs").list_not_empty()) scene.responses.push_back(read_dof(dof, scene));
  if (const auto harmonics = table.find("harmonics")) {
    for (const scene::Item& number : harmonics->list_not_empty()) scene.harmonics.fixed.push_back(number.whole(0, 1000));
    harmonics->here([&] { return response::Harmonics(scene.harmonics.fixed); });
    for (const int n : scene.force.harmonics) {
      if (std::ranges::find(scene.harmonics.fixed, n) == scene.harmonics.fixed.end()) {
        harmonics->fail("harmonic " + std::to_string(n) + " of the force is not among them", "add it");
      }
    }
  }
  if (const auto tolerance = table.find("tolerance")) scene.harmonics.tolerance = tolerance->positive();
  if (const auto largest = table.find("largest_harmonic")) scene.harmonics.largest = largest->whole(1, 1000);
  if (const auto method = table.find("method")) {
    scene.method = method->word(methods) == "sweep" ? CurveMethod::sweep : CurveMethod::arc_length;
    if (scene.method == CurveMethod::arc_length && (coordinates(scene) == 0 || !scene.range_hz)) {
      method->fail("arc_length needs the structure between frequency lines, and a range",
                   "give [structure] and [frequency] range, or use sweep");
    }
  }
  if (const auto stability = table.find("stability")) {
    scene.stability = stability->boolean();
    if (scene.stability) require_marching(*stability, scene);
  }
}

}  // namespace

ResponseScene parse_response_scene(const std::string& text, const ident::Path& file) {
  const scene::Document document(
      text, file, {"data", "structure", "joints", "force", "frequency", "response", "curves", "equivalent", "transient", "clamping"});
  const scene::Table& table = document.table();
  ResponseScene scene;
  scene.file = file;
  scene.title = document.title();
  const auto data = table.find("data"), structure = table.find("structure");
  if (data.has_value() == structure.has_value()) {
    throw InputError({.kind = ErrorKind::usage,
                      .file = file.string(),
                      .place = "",
                      .problem = data ? "there are both [data] and [structure]" : "there is no structure",
                      .remedy = "give [data] parts (FRFs) or [structure] mass and stiffness (matrices)"});
  }
  if (structure) read_structure(*structure, file.parent_path(), scene);
  if (data) {
    std::vector<std::string> names;
    const ident::DataSection parts = ident::read_parts_section(*data, file.parent_path(), names);
    scene.parts = parts.substructures;
    scene.reciprocity = parts.reciprocity;
  }
  for (const scene::Item& joint : table.require("joints").list_not_empty()) {
    scene.joints.push_back(read_joint(joint, scene, scene.joints.size() + 1));
  }
  if (const auto transient = table.find("transient")) scene.transient = read_transient(*transient, file.parent_path(), scene);
  const bool own_forces = scene.transient && (!scene.transient->records.empty() || !scene.transient->pulses.empty());
  const auto force = own_forces ? table.find("force") : table.require("force");
  if (force) read_force(*force, scene);
  const auto frequency = table.find("frequency");
  if (frequency || (force && coordinates(scene) > 0))
    read_frequencies(frequency ? *frequency : table.require("frequency"), scene);
  read_response(table.require("response"), scene);
  if (const auto curves = table.find("curves")) {
    if (!force) curves->fail("there is no [force]", "state where it acts");
    for (const scene::Item& curve : curves->list_not_empty()) scene.curves.push_back(read_curve(curve, scene));
  }
  if (const auto equivalent = table.find("equivalent")) scene.equivalent = read_equivalent(*equivalent, scene);
  if (const auto clamping = table.find("clamping")) {
    if (!force) clamping->fail("there is no [force]", "state where it acts");
    scene.clamping = read_clamping(*clamping, scene);
  }
  return scene;
}

ResponseScene read_response_scene(const ident::Path& file) { return parse_response_scene(scene::read_text(file), file); }

}  // namespace jointid::tasks
