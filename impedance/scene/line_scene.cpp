#include "impedance/scene/line_scene.hpp"

#include <algorithm>
#include <array>

#include "ident/scene/scene_failure.hpp"
#include "ident/scene/scene_matrix.hpp"
#include "ident/scene/scene_sections.hpp"
#include "impedance/scene/line_sections.hpp"
#include "restrictions/restriction.hpp"

namespace jointid::impedance {
namespace {

using restrictions::EntryMatrix;
using restrictions::JointSpec;
using restrictions::Kind;
using restrictions::Pattern;

const std::vector<std::string> structures = {"symmetric", "diagonal", "massless", "masses", "given"};
const std::vector<std::string> written_structures = {"symmetric", "diagonal", "massless", "masses"};

bool has_halves(Structure structure) { return structure == Structure::massless || structure == Structure::masses; }

/// Facing halves in the order of the DOFs: those of the first part, then those of the second.
std::vector<std::pair<std::size_t, std::size_t>> halves_of(std::size_t size) {
  std::vector<std::pair<std::size_t, std::size_t>> out;
  for (std::size_t i = 0; i < size / 2; ++i) out.emplace_back(i, size / 2 + i);
  return out;
}

/// T z Tᵀ as a matrix of names, and masses on its diagonal.
EntryMatrix between_halves(const LineScene& scene, std::size_t size) {
  std::vector<std::vector<std::string>> sums(size, std::vector<std::string>(size));
  const auto& facing = scene.facing;
  for (std::size_t i = 0; i < facing.size(); ++i) {
    for (std::size_t k = 0; k < facing.size(); ++k) {
      const std::string z = "z" + std::to_string(std::min(i, k) + 1) + "_" + std::to_string(std::max(i, k) + 1);
      sums[facing[i].first][facing[k].first] = sums[facing[i].second][facing[k].second] = z;
      sums[facing[i].first][facing[k].second] = sums[facing[i].second][facing[k].first] = "-" + z;
    }
  }
  if (scene.structure == Structure::masses) {
    for (std::size_t i = 0; i < size; ++i) sums[i][i] += "+m" + std::to_string(i + 1);
  }
  EntryMatrix matrix;
  for (const auto& row : sums) matrix.emplace_back(row.begin(), row.end());
  return matrix;
}

void read_facing(const scene::Item& item, const JointSpec& joint, LineScene& out) {
  std::vector<bool> used(joint.dofs.size());
  for (const scene::Item& pair : item.list_not_empty()) {
    const std::vector<frf::Dof> dofs = pair.dofs();
    if (dofs.size() != 2) pair.fail("a pair has two DOFs, found " + std::to_string(dofs.size()), "write [\"4:+Y\", \"5:+Y\"]");
    std::array<std::size_t, 2> places{};
    for (std::size_t k = 0; k < 2; ++k) {
      places[k] = frf::find_coordinate(joint.dofs, dofs[k]);
      if (places[k] == frf::npos) pair.fail(dofs[k].name() + " is not a DOF of the joint", "add it to dofs");
      if (dofs[k].sign != joint.dofs[places[k]].sign)
        pair.fail(dofs[k].name() + " has another sign in dofs", "write it as there");
      if (used[places[k]]) pair.fail(dofs[k].name() + " is in two pairs", "each DOF has one partner");
      used[places[k]] = true;
    }
    out.facing.emplace_back(places[0], places[1]);
  }
}

void read_structure(const scene::Item& item, JointSpec& joint, LineScene& out) {
  if (item.is_text()) {
    const std::string word = item.word(written_structures);
    out.structure = static_cast<Structure>(std::ranges::find(structures, word) - structures.begin());
    return;
  }
  if (!item.is_table()) {
    item.fail("is no structure of Z",
              "write \"symmetric\", \"massless\", \"masses\", \"diagonal\", { matrix = … } or { springs = … }");
  }
  out.structure = Structure::given;
  const scene::Table table = item.table({"matrix", "springs"});
  joint.matrices[Kind::stiffness] = ident::read_matrix_spec(table.itself(), Kind::stiffness, joint);
}

Way read_way(const scene::Item& item) {
  const std::string word = item.word(way_names());
  return static_cast<Way>(std::ranges::find(way_names(), word) - way_names().begin());
}

std::vector<Way> read_ways(const scene::Item& item) {
  if (item.is_text()) return {read_way(item)};
  std::vector<Way> out;
  for (const scene::Item& each : item.list_not_empty()) {
    const Way way = read_way(each);
    if (std::ranges::find(out, way) != out.end()) each.fail("the way '" + name(way) + "' is named twice");
    out.push_back(way);
  }
  return out;
}

std::vector<LawKind> read_laws(const scene::Item& item) {
  std::vector<LawKind> out;
  const auto add = [&](const scene::Item& each) {
    const std::string word = each.word(law_names());
    const auto law = static_cast<LawKind>(std::ranges::find(law_names(), word) - law_names().begin());
    if (std::ranges::find(out, law) != out.end()) each.fail("the law '" + word + "' is named twice");
    out.push_back(law);
  };
  if (item.is_text() && item.text() == "all") {
    for (std::size_t k = 0; k < law_names().size(); ++k) out.push_back(static_cast<LawKind>(k));
  } else if (item.is_text()) {
    add(item);
  } else {
    for (const scene::Item& each : item.list_not_empty()) add(each);
  }
  return out;
}

void read_law_keys(const scene::Table& joint, LineScene& out) {
  if (const auto laws = joint.find("laws")) out.laws = read_laws(*laws);
  const std::vector<std::string> scopes = {"element", "joint"};
  for (const char* key : {"law_scope", "law_masses"}) {
    const auto item = joint.find(key);
    if (item && out.laws.empty()) item->fail("it is given, but no laws are", "add laws = \"all\", or remove it");
  }
  const bool many = out.structure != Structure::given && out.scene.joints.front().dofs.size() > 2;
  out.law_per_joint = many;
  if (const auto scope = joint.find("law_scope")) out.law_per_joint = scope->word(scopes) == "joint";
  if (const auto masses = joint.find("law_masses")) out.law_masses = masses->boolean();
  if (out.law_masses && out.structure == Structure::massless) {
    joint.require("law_masses").fail("a massless joint has no masses", "use lines = \"masses\" or \"symmetric\"");
  }
  if (out.structure == Structure::masses) out.law_masses = true;
}

void read_smoothing(const scene::Table& joint, LineScene& out) {
  constexpr int least = 4, most = 400;
  const auto smooth = joint.find("smooth"), splines = joint.find("splines");
  if (splines && !smooth) splines->fail("it is given, but smooth is not", "add smooth = \"marginal\", or remove it");
  if (splines) out.splines = static_cast<std::size_t>(splines->whole(least, most));
  if (!smooth) return;
  if (smooth->is_text()) {
    const std::string word = smooth->word(smoothing_names());
    out.smoothing = static_cast<Smoothing>(std::ranges::find(smoothing_names(), word) - smoothing_names().begin());
  } else {
    out.lambda = smooth->positive();
    out.smoothing = Smoothing::given;
  }
}

void read_joint(const scene::Table& table, LineScene& out) {
  if (const auto joints = table.find("joints")) {
    joints->fail("Z at every line is that of one joint", "write [joint] with the DOFs of all of them");
  }
  const scene::Item item = table.require("joint");
  const scene::Table joint =
      item.table({"dofs", "lines", "facing", "way", "laws", "law_scope", "law_masses", "smooth", "splines"});
  out.scene.joints.emplace_back();
  JointSpec& spec = out.scene.joints.back();
  spec.dofs = joint.require("dofs").dofs();
  read_structure(joint.require("lines"), spec, out);
  if (const auto facing = joint.find("facing")) {
    if (!has_halves(out.structure) && !(out.structure == Structure::symmetric && joint.find("laws"))) {
      facing->fail("only \"massless\" and \"masses\", and laws on \"symmetric\", have facing DOFs", "remove facing");
    }
    read_facing(*facing, spec, out);
  }
  if (const auto way = joint.find("way")) out.ways = read_ways(*way);
  read_law_keys(joint, out);
  read_smoothing(joint, out);
  item.here([&] { set_structure(out); });
}

void refuse_identify(const scene::Item& item, const ident::IdentifySection& identify) {
  const scene::Table table = item.open_table();
  for (const auto& [key, value] : table.members()) {
    if (key != "method" && key != "equations" && key != "variance" && key != "smooth_variance") {
      value.fail("does not apply to lines",
                 "remove " + key + ": [joint] lines has method, equations, variance and smooth_variance");
    }
  }
  if (!identify.automatic && identify.method != ident::Method::likelihood) {
    table.require("method").fail("Z at every line is found by ways, not by method \"" + ident::name(identify.method) + "\"",
                                 "remove method; [joint] way = \"primal\" and others choose closed forms");
  }
}

}  // namespace

std::string name(Structure structure) { return structures[static_cast<std::size_t>(structure)]; }

const std::vector<std::string>& way_names() {
  static const std::vector<std::string> words = {"likelihood",   "weighed",  "primal",   "dual", "average",
                                                 "off-diagonal", "relative", "extended", "nj",   "nn"};
  return words;
}

std::string name(Way way) { return way_names()[static_cast<std::size_t>(way)]; }

void set_structure(LineScene& scene) {
  JointSpec& joint = scene.scene.joints.front();
  const std::size_t size = joint.dofs.size();
  if (scene.structure == Structure::symmetric && !scene.facing.empty() && 2 * scene.facing.size() != size) {
    ident::fail(scene.scene, "[joint] facing", "some DOFs of the joint face no other", "pair all of them, or remove facing");
  }
  if (has_halves(scene.structure)) {
    if (scene.facing.empty() && size % 2 == 0) scene.facing = halves_of(size);
    if (2 * scene.facing.size() != size) {
      ident::fail(scene.scene, "[joint] facing",
                  "the joint has " + std::to_string(size) + " DOFs, of which facing ones are pairs",
                  "list the DOFs of one part, then those that face them; or give facing = [[\"4:+Y\", \"5:+Y\"], …]");
    }
    joint.matrices[Kind::stiffness] = between_halves(scene, size);
  } else if (scene.structure != Structure::given) {
    joint.matrices[Kind::stiffness] = scene.structure == Structure::symmetric ? Pattern::symmetric : Pattern::diagonal;
  }
  joint.matrices[Kind::hysteretic_damping] = joint.matrices.at(Kind::stiffness);
  const restrictions::Restriction all = restrictions::build({joint});
  if (!all.symmetric()) ident::fail(scene.scene, "[joint] lines", "the matrix is not symmetric", "Z is: FRFs are reciprocal");
  for (const restrictions::MatrixTerms& matrix : all.matrices) {
    if (!matrix.known.empty()) ident::fail(scene.scene, "[joint] lines", "the matrix has known numbers", "write names or 0");
  }
  ident::IdentifySection& identify = scene.scene.identify;
  identify.method = ident::Method::likelihood;
  identify.automatic = false;
  identify.start[Kind::stiffness] = ident::Matrix(size, std::vector<double>(size, 0.0));
}

LineScene read_sections(const scene::Document& document, const std::filesystem::path& file) {
  const scene::Table& table = document.table();
  LineScene out;
  ident::Scene& scene = out.scene;
  scene.file = file;
  scene.title = document.title();
  scene.data = ident::read_data(table.require("data"), file.parent_path());
  if (const auto frequency = table.find("frequency")) scene.frequency = ident::read_frequency(*frequency);
  if (const auto identify = table.find("identify")) {
    scene.identify.automatic = !identify->open_table().find("method");
    ident::IdentifySection read = ident::read_identify(*identify, scene.joints);
    read.automatic = scene.identify.automatic || read.automatic;
    refuse_identify(*identify, read);
    scene.identify = read;
  }
  if (const auto noise = table.find("noise")) scene.noise = ident::read_noise(*noise);
  ident::read_virtual_points(table, file.parent_path(), ident::all_files(scene.data));
  ident::set_virtual_noise(scene.noise, ident::all_files(scene.data));
  return out;
}

LineScene parse_line_scene(const std::string& text, const std::filesystem::path& file) {
  const scene::Document document(text, file,
                                 {"data", "frequency", "joint", "joints", "nodes", "identify", "noise", "virtual_points"});
  LineScene out = read_sections(document, file);
  read_joint(document.table(), out);
  return out;
}

}  // namespace jointid::impedance
