#include "problems/vibration/rig_two.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "base/complex.hpp"
#include "base/random.hpp"
#include "base/temporary_file.hpp"
#include "friction/curve/equivalent.hpp"
#include "friction/law/laws.hpp"
#include "problems/case/case.hpp"
#include "problems/case/set_format.hpp"
#include "problems/structure/beam.hpp"
#include "problems/structure/response.hpp"

namespace jointid::problems {
namespace {

constexpr BeamSection wide = {.width = 0.0508, .thickness = 0.0095, .youngs_modulus = 2.1e11, .density = 7850.0};
constexpr BeamSection narrow = {.width = 0.0254, .thickness = 0.0127, .youngs_modulus = 2.1e11, .density = 7850.0};
constexpr double rod_diameter = 0.004, rod_length = 0.091;  ///< m; the length between the beams
constexpr double rod_place = 0.4475;                        ///< m from the middles: 1 cm from the ends of the shorter beam; ours
constexpr double block_mass = 0.25;                         ///< kg, of each block with its aluminium piece; ours
constexpr double steel_loss_factor = 0.0005;
constexpr double rigid_stiffness = 1e10;  ///< N/m
constexpr double gain_error = 0.017, phase_error = 0.01, random_error = 0.003;

const frf::Dof middle_1{.node = 109, .direction = frf::Direction::y}, middle_2{.node = 209, .direction = frf::Direction::y};

struct Clamping {
  const char *name, *description;
  double force;
  std::vector<double> element;
};

const std::vector<Clamping>& clampings() {
  static const std::vector<Clamping> all = {
      {"rig2",
       "replica of rig two: two steel beams, friction joint under 200 N, sine tests at eight displacements (§7.3)",
       200.0,
       {1.07e-7, 4.27, 8.20e6}},
      {"rig2-264", "rig2 under 264 N (§7.3)", 264.0, {1.98e-7, 4.21, 6.46e6}}};
  return all;
}

/// A beam of 16 elements about its middle, which is its ninth node; nodes 2 and 16 are where the rods are.
Structure half_and_half(const BeamSection& section, double length, std::int64_t first_node) {
  std::vector<double> x = {-0.5 * length};
  for (int i = -7; i <= 7; ++i) x.push_back(rod_place * i / 7.0);
  x.push_back(0.5 * length);
  return beam(section, {.first_node = first_node, .x = x});
}

/// A rod that holds two ends apart and bends with their slopes; the beams do not move along themselves.
void add_rod(Structure& structure, std::int64_t one, std::int64_t other) {
  const double area = std::numbers::pi * std::pow(rod_diameter, 2) / 4.0,
               inertia = std::numbers::pi * std::pow(rod_diameter, 4) / 64.0;
  structure.add(Kind::stiffness,
                {{.node = one, .direction = frf::Direction::y}, {{.node = other, .direction = frf::Direction::y}}},
                wide.youngs_modulus * area / rod_length);
  const double bending = wide.youngs_modulus * inertia / rod_length;
  structure.add(Kind::stiffness, {beam_dofs(one)[1], beam_dofs(other)[1]},
                {{4.0 * bending, 2.0 * bending}, {2.0 * bending, 4.0 * bending}});
}

/// With k + id between the middles, excited at the first.
frf::FrfSet with_joint(Structure structure, double stiffness, double damping, const std::string& file) {
  structure.add(Kind::stiffness, {middle_1, middle_2}, stiffness);
  structure.add(Kind::hysteretic_damping, {middle_1, middle_2}, damping);
  frf::FrfSet set = frequency_response(
      structure, {.response = {middle_1, middle_2}, .reference = {middle_1}, .frequency_hz = frequencies({48.0, 0.25, 41})});
  set.header.file = file;
  return set;
}

std::string level_file(const std::string& name, std::size_t level) {
  return name + "_level_" + std::to_string(level + 1) + ".h5";
}

std::string scene_of(const RigTwo& rig) {
  std::string levels;
  for (std::size_t i = 0; i < rig.levels.size(); ++i) {
    const std::string displacement = nlohmann::json(rig.displacements[i]).dump();
    levels += "  { assembly = \"" + rig.levels[i].header.file + "\", displacement = " + displacement + " },\n";
  }
  return "title = \"" + rig.name + ": " + rig.description + "\"\n\n[data]\nparts = [\"" + rig.parts.header.file +
         "\"]\n\n[frequency]\nrange = [48.0, 57.0]  # Hz; the first resonance of the assembly is at 57.05 Hz and "
         "below\n\n[equivalent]\ndofs = [\"" +
         middle_1.name() + "\", \"" + middle_2.name() +
         "\"]  # excited at the first\nlevels = [  # amplitude of the relative displacement in m\n" + levels + "]\nrigid = \"" +
         rig.rigid.header.file + "\"  # (7.18); without it (7.11)\nreal = true  # (7.19)\nweighting = \"relative\"\n";
}

const Clamping& find(const std::string& name) {
  std::vector<std::string> names;
  for (const Clamping& each : clampings()) {
    if (each.name == name) return each;
    names.emplace_back(each.name);
  }
  refuse_problem("there is no rig '" + name + "'", name, names);
}

/// gain·e^{iφ} per FRF and an error of every value; `set` numbers the measurement.
void pollute(frf::FrfSet& set, const std::vector<Complex>& factors, const RandomStream& stream) {
  for (std::size_t i = 0; i < set.values.size(); ++i) {
    const auto e = normal_numbers(stream, i);
    set.values[i] *= factors[i % factors.size()] * Complex(1.0 + random_error * e[0], random_error * e[1]);
  }
}

Complex factor(const std::array<double, 4>& uniform, double phase) {
  return std::polar(1.0 + gain_error * (2.0 * uniform[0] - 1.0), phase * (2.0 * uniform[1] - 1.0));
}

}  // namespace

Structure rig_two_structure() {
  Structure result = merged(half_and_half(wide, 1.04, 101), half_and_half(narrow, 0.915, 201));
  add_rod(result, 102, 202);
  add_rod(result, 116, 216);
  for (const frf::Dof& middle : {middle_1, middle_2}) result.add(Kind::mass, {middle}, {{block_mass}});
  result.add_proportional_damping(steel_loss_factor);
  return result;
}

std::array<frf::Dof, 2> rig_two_middles() { return {middle_1, middle_2}; }

std::vector<ProblemInfo> list_rig_two() {
  std::vector<ProblemInfo> out;
  for (const Clamping& each : clampings()) out.push_back({each.name, each.description});
  return out;
}

RigTwo make_rig_two(const std::string& name) {
  const Clamping& clamping = find(name);
  RigTwo rig{.name = name,
             .description = clamping.description,
             .clamping_force = clamping.force,
             .element = clamping.element,
             .limit = 0.0,
             .displacements = {},
             .parts = {},
             .levels = {},
             .rigid = {},
             .scene = {}};
  const auto element = friction::make_element("ren", rig.element);
  rig.limit = element->limit();
  const Structure structure = rig_two_structure();
  rig.parts = frequency_response(
      structure,
      {.response = {middle_1, middle_2}, .reference = {middle_1, middle_2}, .frequency_hz = frequencies({48.0, 0.25, 41})});
  rig.parts.header.file = name + "_parts.h5";
  for (double displacement = 0.4e-6; displacement < 60e-6; displacement *= 2.0) {
    const friction::Equivalent joint = friction::equivalent(*element, displacement);
    rig.displacements.push_back(displacement);
    rig.levels.push_back(with_joint(structure, joint.stiffness, joint.damping, level_file(name, rig.levels.size())));
  }
  rig.rigid = with_joint(structure, rigid_stiffness, 0.0, name + "_rigid.h5");
  rig.scene = scene_of(rig);
  return rig;
}

RigTwo polluted(const RigTwo& rig, std::uint64_t seed) {
  RigTwo out = rig;
  const auto uniform = [seed](std::uint64_t entry) { return uniform_numbers({.seed = seed}, entry); };
  const Complex cross = factor(uniform(2), phase_error);  // measured once, in either role
  pollute(out.parts, {factor(uniform(0), phase_error), cross, cross, factor(uniform(1), phase_error)},
          {.seed = seed, .trial = 0, .set = 1});
  const std::vector<Complex> assembly = {factor(uniform(3), 0.0), factor(uniform(4), 0.0)};
  pollute(out.rigid, assembly, {.seed = seed, .trial = 0, .set = 2});
  for (std::size_t i = 0; i < out.levels.size(); ++i) pollute(out.levels[i], assembly, {.seed = seed, .trial = 0, .set = 3 + i});
  return out;
}

std::filesystem::path write(const RigTwo& rig, const std::filesystem::path& directory, const WriteOptions& options) {
  const SetFormat& format = find_set_format(options.format);
  const RigTwo data = options.clean ? rig : polluted(rig, options.seed);
  std::error_code ignored;  // a folder that cannot be made shows when the first file is written
  std::filesystem::create_directories(directory, ignored);
  std::string scene = data.scene;
  const auto write_set = [&](const frf::FrfSet& set) {
    const std::string file = std::filesystem::path(set.header.file).replace_extension(format.name).string();
    format.write(set, directory / file);
    scene.replace(scene.find(set.header.file), set.header.file.size(), file);
  };
  write_set(data.parts);
  for (const frf::FrfSet& level : data.levels) write_set(level);
  write_set(data.rigid);
  const nlohmann::ordered_json truth = {
      {"name", rig.name}, {"description", rig.description}, {"clamping_force", rig.clamping_force},
      {"law", "ren"},     {"parameters", rig.element},      {"limit", rig.limit}};
  write_text(directory / "truth.json", truth.dump(1) + "\n");
  const std::filesystem::path path = directory / (rig.name + ".toml");
  write_text(path, scene);
  return path;
}

}  // namespace jointid::problems
