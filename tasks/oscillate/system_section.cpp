#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <utility>

#include "tasks/oscillate/oscillate_sections.hpp"
#include "tasks/response/scene_values.hpp"

namespace jointid::tasks {
namespace {

constexpr int most_degrees = 1000;

const std::vector<std::string> kinds = {"belt_chain", "cantilever", "matrices"};
const std::vector<std::string> common = {"kind",    "velocity",           "amplitude",    "frequency",
                                         "damping", "first_mode_damping", "modal_damping"};

/// Keys of a cantilever and what they set, all > 0.
std::vector<std::pair<std::string, double*>> beam_numbers(oscillation::Cantilever& beam) {
  return {{"length", &beam.length},
          {"width", &beam.width},
          {"thickness", &beam.thickness},
          {"youngs_modulus", &beam.youngs_modulus},
          {"density", &beam.density},
          {"extension", &beam.extension},
          {"extension_free", &beam.extension_free},
          {"extension_width", &beam.extension_width},
          {"extension_thickness", &beam.extension_thickness}};
}

/// Those that may be 0: a bare beam.
std::vector<std::pair<std::string, double*>> tip_numbers(oscillation::Cantilever& beam) {
  return {{"extension_density", &beam.extension_density}, {"fixture_mass", &beam.fixture_mass}};
}

/// A kind that is not given has other keys.
std::vector<std::string> keys_of(SystemSpec& spec) {
  std::vector<std::string> keys = common;
  switch (spec.kind) {
    case SystemKind::belt_chain:
      keys.insert(keys.end(), {"masses", "mass", "stiffness"});
      break;
    case SystemKind::cantilever:
      for (const auto& [key, number] : beam_numbers(spec.beam)) keys.push_back(key);
      for (const auto& [key, number] : tip_numbers(spec.beam)) keys.push_back(key);
      keys.insert(keys.end(), {"modes", "points", "strain_at", "poisson_ratio"});
      break;
    case SystemKind::matrices:
      keys.insert(keys.end(), {"mass", "stiffness", "contact"});
      break;
  }
  return keys;
}

void read_chain(const scene::Table& table, SystemSpec& spec) {
  spec.chain.masses = static_cast<std::size_t>(table.require("masses").whole(1, most_degrees));
  if (const auto mass = table.find("mass")) spec.chain.mass = mass->positive();
  if (const auto stiffness = table.find("stiffness")) spec.chain.stiffness = stiffness->positive();
}

void read_beam(const scene::Table& table, SystemSpec& spec) {
  for (const auto& [key, number] : beam_numbers(spec.beam)) {
    if (const auto item = table.find(key)) *number = item->positive();
  }
  for (const auto& [key, number] : tip_numbers(spec.beam)) {
    if (const auto item = table.find(key)) *number = item->not_negative();
  }
  if (const auto ratio = table.find("poisson_ratio")) {
    spec.poisson_ratio = ratio->not_negative();
    if (*spec.poisson_ratio > 0.5) ratio->fail("is above 0.5, which no material has", "metals have about 0.3");
  }
  if (const auto modes = table.find("modes")) spec.beam.modes = static_cast<std::size_t>(modes->whole(1, 40));
  const auto place = [&](const scene::Item& item) {
    const double x = item.not_negative();
    if (x > spec.beam.length) item.fail("lies beyond the beam of " + scene::number_text(spec.beam.length) + " m");
    return x;
  };
  if (const auto points = table.find("points")) {
    for (const scene::Item& item : points->list_not_empty()) spec.points.push_back(place(item));
  } else {
    for (int k = 1; k <= 8; ++k) spec.points.push_back(spec.beam.length * k / 8.0);
  }
  spec.strain_at = spec.beam.length / 8.0;
  if (const auto strain = table.find("strain_at")) spec.strain_at = place(*strain);
}

void read_matrices(const scene::Table& table, OscillateScene& scene) {
  SystemSpec& spec = scene.system;
  const ident::Path folder = scene.file.parent_path();
  spec.mass = read_matrix(table.require("mass"), folder, 0, scene.named);
  spec.stiffness = read_matrix(table.require("stiffness"), folder, spec.mass.rows(), scene.named);
  const scene::Item contact = table.require("contact");
  spec.contact = read_vector(contact);
  if (spec.contact.size() != spec.mass.rows()) {
    contact.fail("has " + std::to_string(spec.contact.size()) + " numbers, the matrices " + std::to_string(spec.mass.rows()) +
                 " rows");
  }
}

void read_damping(const scene::Table& table, SystemSpec& spec) {
  const std::pair<const char*, DampingKind> choices[] = {{"damping", DampingKind::stiffness},
                                                         {"first_mode_damping", DampingKind::first_mode},
                                                         {"modal_damping", DampingKind::modal}};
  bool found = false;
  for (const auto& [key, kind] : choices) {
    const auto item = table.find(key);
    if (!item) continue;
    if (found) item->fail("there is another damping", "remove one");
    found = true;
    spec.damping_kind = kind;
    spec.damping = item->not_negative();
  }
}

/// Rows [Hz, m] of a table A(f).
std::vector<std::array<double, 2>> read_amplitudes(const scene::Item& item) {
  std::vector<std::array<double, 2>> rows;
  for (const scene::Item& each : item.list_not_empty()) {
    const std::vector<scene::Item> pair = each.is_list() ? each.list() : std::vector<scene::Item>();
    if (pair.size() != 2) each.fail("is not a row of frequency and amplitude", "write [12.0, 0.0023]: Hz, m");
    rows.push_back({pair[0].positive(), pair[1].positive()});
    if (rows.size() > 1 && !(rows[rows.size() - 2][0] < rows.back()[0]))
      each.fail("does not lie above the frequency before", "sort the rows by frequency");
  }
  return rows;
}

/// What the contact slides on: a belt, a slider, or the ground.
void read_drive(const scene::Table& table, SystemSpec& spec) {
  const auto velocity = table.find("velocity"), amplitude = table.find("amplitude"), frequency = table.find("frequency");
  if (velocity) spec.velocity = velocity->number();
  if (amplitude.has_value() != frequency.has_value())
    (amplitude ? *amplitude : *frequency).fail("a slider A sin 2πft has amplitude and frequency", "give both");
  if (frequency) spec.frequency_hz = frequency->positive();
  if (amplitude && amplitude->is_list()) {
    spec.amplitudes = read_amplitudes(*amplitude);
  } else if (amplitude) {
    spec.amplitude = amplitude->positive();
  }
  if (!velocity && !amplitude)
    table.itself().fail("nothing moves the contact", "give velocity (a belt) or amplitude and frequency (a slider)");
}

/// Degrees, between the angles at which the contact locks and at which it slides by its load alone.
double read_tilt(const scene::Item& item, const oscillation::Friction& law) {
  constexpr double degree = std::numbers::pi / 180.0;
  const double tilt = item.number() * degree, slides = std::atan(law.kinetic), locks = std::numbers::pi / 2.0 - std::atan(law.statical);
  if (!(std::abs(tilt) <= slides)) {
    item.fail("lets the contact slide by its load alone from " + scene::number_text(slides / degree) + " degrees on",
              "tilt is in degrees, a few at most");
  }
  if (!(std::abs(tilt) < locks)) {
    item.fail("locks the contact from " + scene::number_text(locks / degree) + " degrees on", "tilt is in degrees, a few at most");
  }
  return tilt;
}

}  // namespace

void read_system(const scene::Item& item, OscillateScene& scene) {
  SystemSpec& spec = scene.system;
  const std::string kind = item.open_table().require("kind").word(kinds);
  spec.kind = kind == kinds[0] ? SystemKind::belt_chain : kind == kinds[1] ? SystemKind::cantilever : SystemKind::matrices;
  const scene::Table table = item.table(keys_of(spec));
  if (spec.kind == SystemKind::belt_chain) read_chain(table, spec);
  if (spec.kind == SystemKind::cantilever) read_beam(table, spec);
  if (spec.kind == SystemKind::matrices) read_matrices(table, scene);
  read_damping(table, spec);
  read_drive(table, spec);
}

oscillation::Friction read_friction(const scene::Item& item) {
  const scene::Table table = item.table({"kinetic", "static", "decay", "normal", "normal_slope", "contact_stiffness", "tilt"});
  oscillation::Friction out;
  out.kinetic = table.require("kinetic").not_negative();
  const scene::Item statical = table.require("static");
  out.statical = statical.not_negative();
  if (out.statical < out.kinetic) statical.fail("is below kinetic, " + scene::number_text(out.kinetic));
  if (const auto decay = table.find("decay")) out.decay = decay->positive();
  out.normal = table.require("normal").positive();
  if (const auto slope = table.find("normal_slope")) out.normal_slope = slope->number();
  if (const auto stiffness = table.find("contact_stiffness")) {
    if (out.decay) stiffness->fail("of a compliant contact the law is Coulomb's", "remove decay");
    out.contact_stiffness = stiffness->positive();
  }
  if (const auto tilt = table.find("tilt")) out.tilt = read_tilt(*tilt, out);
  return out;
}

}  // namespace jointid::tasks
