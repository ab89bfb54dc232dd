#include <cmath>

#include "scene/document.hpp"
#include "scene/text.hpp"
#include "tasks/oscillate/oscillate_sections.hpp"
#include "tasks/response/scene_values.hpp"

namespace jointid::tasks {
namespace {

constexpr double most_motion_samples = 1e7, most_cycles = 1e6, most_intervals = 1e6;

const std::vector<std::string> basis_words = {"pod", "normal_modes", "craig_bampton"};

double not_negative_or(const scene::Table& table, const char* key, double otherwise) {
  const auto item = table.find(key);
  return item ? item->not_negative() : otherwise;
}

std::size_t whole(const scene::Item& item, int least, int most) { return static_cast<std::size_t>(item.whole(least, most)); }

Eigen::VectorXd start_of(const scene::Table& table, const char* key, Eigen::Index degrees) {
  const auto item = table.find(key);
  if (!item) return Eigen::VectorXd::Zero(degrees);
  const Eigen::VectorXd out = read_vector(*item);
  if (out.size() != degrees)
    item->fail("has " + std::to_string(out.size()) + " numbers, the system " + std::to_string(degrees) + " coordinates");
  return out;
}

void read_start(const std::optional<scene::Item>& item, OscillateScene& scene) {
  const Eigen::Index n = model_of(scene.system).mechanics.contact.size();
  scene.q = scene.v = Eigen::VectorXd::Zero(n);
  if (!item) return;
  const scene::Table table = item->table({"displacement", "velocity"});
  scene.q = start_of(table, "displacement", n);
  scene.v = start_of(table, "velocity", n);
}

/// Of a driven motion.
void require_cycles(const scene::Item& item, const SystemSpec& system, double seconds) {
  const double cycles = system.is_driven() ? seconds * system.frequency_hz : 0.0;
  if (!(cycles <= most_cycles))
    item.fail("transient and length are " + scene::number_text(cycles) + " cycles of the slider",
              "take 1e6 at most: shorten them");
}

MotionSection read_motion(const scene::Item& item, const SystemSpec& system) {
  const scene::Table table = item.table({"transient", "length", "step"});
  MotionSection out;
  out.transient = not_negative_or(table, "transient", 0.0);
  out.length = table.require("length").positive();
  const scene::Item step = table.require("step");
  out.step = step.positive();
  const double samples = out.length / out.step;
  if (samples < 20.0 || samples > most_motion_samples)
    step.fail("gives " + scene::number_text(std::floor(samples)) + " samples", "take 20 to 1e7");
  require_cycles(item, system, out.transient + out.length);
  return out;
}

OrbitSection read_orbit(const scene::Item& item, const SystemSpec& system) {
  const scene::Table table = item.table({"slips", "cycles"});
  const auto slips = table.find("slips"), cycles = table.find("cycles");
  if (system.is_driven()) {
    if (slips) slips->fail("of a driven system the period is a number of cycles", "give cycles");
    return {whole(table.require("cycles"), 1, 10000)};
  }
  if (cycles) cycles->fail("there is no drive with cycles", "give slips, the break-aways of a period");
  if (system.friction.contact_stiffness)
    item.fail("periodic orbits without a drive are found of rigid contacts only", "remove contact_stiffness or [orbit]");
  return {whole(table.require("slips"), 1, 10000)};
}

ExponentSection read_exponents(const scene::Item& item, const OscillateScene& scene) {
  const scene::Table table = item.table({"count", "transient", "length", "interval"});
  ExponentSection out{1, scene.motion.transient, 0.0, 0.0};
  if (const auto count = table.find("count")) out.count = whole(*count, 1, 2 * static_cast<int>(scene.q.size()));
  out.transient = not_negative_or(table, "transient", out.transient);
  out.length = table.require("length").positive();
  const scene::Item interval = table.require("interval");
  out.interval = interval.positive();
  if (out.length < 20.0 * out.interval) interval.fail("the length has less than 20 of them", "shorten interval");
  const double intervals = (out.transient + out.length) / out.interval;
  if (!(intervals <= most_intervals))
    interval.fail("transient and length have " + scene::number_text(intervals) + " of them", "take 1e6 at most");
  return out;
}

SweepSection read_sweep(const scene::Item& item, const SystemSpec& system) {
  const scene::Table table = item.table({"parameter", "range", "points", "transient", "length", "continued", "back", "reduced"});
  SweepSection out;
  const scene::Item parameter = table.require("parameter");
  out.parameter = parameter.word(swept_names());
  const bool slider = out.parameter == "amplitude" || out.parameter == "frequency";
  if (slider && !system.is_driven()) parameter.fail("there is no slider", "sweep velocity");
  if (out.parameter == "amplitude" && !system.amplitudes.empty())
    parameter.fail("the amplitude is a table over the frequency", "sweep frequency, or give amplitude as one number");
  if (out.parameter == "decay" && !system.friction.decay) parameter.fail("the law does not fall", "give [friction] decay");
  const scene::Item range = table.require("range");
  const Eigen::VectorXd ends = read_vector(range);
  if (ends.size() != 2 || ends(0) == ends(1)) range.fail("a range is two different numbers");
  const bool positive = out.parameter != "velocity" && out.parameter != "tilt" && ends.minCoeff() <= 0.0;
  if (positive) range.fail("has numbers that are not above 0");
  out.from = ends(0), out.to = ends(1);
  out.points = whole(table.require("points"), 2, 100000);
  out.transient = not_negative_or(table, "transient", 0.0);
  out.length = table.require("length").positive();
  if (system.is_driven() && out.transient + out.length > most_cycles)
    table.require("length").fail("transient and length are more than 1e6 cycles", "shorten them");
  if (const auto continued = table.find("continued")) out.continued = continued->boolean();
  if (const auto back = table.find("back")) {
    out.back = back->boolean();
    if (out.back && !out.continued) back->fail("only a continued sweep has a way back", "give continued = true");
  }
  if (const auto reduced = table.find("reduced")) out.reduced = reduced->boolean();
  return out;
}

NormalVibrationSection read_normal_vibrations(const scene::Item& item, const SystemSpec& system) {
  const scene::Table table = item.table({"mass", "stiffness", "extension_stiffness", "damping", "extension_damping", "slope", "offset",
                                         "frequencies"});
  NormalVibrationSection out;
  out.system.mass = table.require("mass").positive();
  out.system.stiffness = table.require("stiffness").positive();
  out.system.extension_stiffness = table.require("extension_stiffness").positive();
  out.system.damping = not_negative_or(table, "damping", 0.0);
  out.system.extension_damping = not_negative_or(table, "extension_damping", 0.0);
  out.system.slope = table.require("slope").number();
  out.system.offset = table.require("offset").positive();
  out.frequencies_hz = {system.frequency_hz};
  if (const auto frequencies = table.find("frequencies")) {
    out.frequencies_hz.clear();
    for (const scene::Item& each : frequencies->list_not_empty()) out.frequencies_hz.push_back(each.positive());
  }
  if (!system.is_driven()) item.fail("there is no slider whose plane could be tilted", "give [system] amplitude and frequency");
  return out;
}

BasisKind basis_kind(const scene::Item& item) {
  const std::string name = item.word(basis_words);
  return name == basis_words[0] ? BasisKind::pod : name == basis_words[1] ? BasisKind::normal_modes : BasisKind::craig_bampton;
}

ReductionSection read_reduction(const scene::Item& item, OscillateScene& scene) {
  const scene::Table table = item.table({"bases", "orders", "from", "record"});
  ReductionSection out;
  for (const scene::Item& basis : table.require("bases").list_not_empty()) out.bases.push_back(basis_kind(basis));
  for (const scene::Item& order : table.require("orders").list_not_empty())
    out.orders.push_back(whole(order, 1, static_cast<int>(scene.q.size())));
  if (const auto from = table.find("from")) {
    out.from_orbit = from->word(std::vector<std::string>{"start", "orbit"}) == "orbit";
    if (out.from_orbit && !scene.orbit) from->fail("there is no [orbit]");
  }
  if (const auto record = table.find("record")) {
    out.record = scene.file.parent_path() / record->text_not_empty();
    scene.named.push_back({*out.record, record->place()});
  }
  return out;
}

}  // namespace

std::string word(BasisKind kind) { return basis_words[static_cast<std::size_t>(kind)]; }

std::vector<ident::NamedFile> files_of(const OscillateScene& scene) {
  std::vector<ident::NamedFile> files = {{scene.file, "the scene"}};
  files.insert(files.end(), scene.named.begin(), scene.named.end());
  return files;
}

OscillateScene parse_oscillate_scene(const std::string& text, const ident::Path& file) {
  const scene::Document document(text, file, {"system", "friction", "start", "motion", "orbit", "exponents", "sweep", "reduction",
                                          "normal_vibrations"});
  const scene::Table& table = document.table();
  OscillateScene scene;
  scene.file = file;
  scene.title = document.title();
  read_system(table.require("system"), scene);
  scene.system.friction = read_friction(table.require("friction"));
  table.require("system").here([&] { contact_system(model_of(scene.system)); });
  read_start(table.find("start"), scene);
  scene.motion = read_motion(table.require("motion"), scene.system);
  if (const auto orbit = table.find("orbit")) scene.orbit = read_orbit(*orbit, scene.system);
  if (const auto exponents = table.find("exponents")) scene.exponents = read_exponents(*exponents, scene);
  if (const auto sweep = table.find("sweep")) scene.sweep = read_sweep(*sweep, scene.system);
  if (const auto reduction = table.find("reduction")) scene.reduction = read_reduction(*reduction, scene);
  if (const auto normal = table.find("normal_vibrations"))
    scene.normal_vibrations = read_normal_vibrations(*normal, scene.system);
  if (scene.sweep && scene.sweep->reduced && !scene.reduction)
    table.require("sweep").fail("reduced models are swept and there is no [reduction]", "give bases and orders there");
  return scene;
}

OscillateScene read_oscillate_scene(const ident::Path& file) { return parse_oscillate_scene(scene::read_text(file), file); }

}  // namespace jointid::tasks
