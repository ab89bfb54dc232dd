#include "impedance/scene/read_line_scene.hpp"

#include <array>

#include "ident/scene/scene_matrix.hpp"
#include "impedance/scene/line_sections.hpp"

namespace jointid::impedance {
namespace {

using restrictions::JointSpec;
using restrictions::Kind;

const std::vector<std::string> written_structures = {"symmetric", "diagonal", "massless", "masses"};  // `given` has no word

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
    out.structure = read_word<Structure>(item, written_structures);
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

std::vector<LawKind> read_laws(const scene::Item& item) {
  if (!item.is_text() || item.text() != "all") return read_words<LawKind>(item, law_names(), "law");
  std::vector<LawKind> out;
  for (std::size_t k = 0; k < law_names().size(); ++k) out.push_back(static_cast<LawKind>(k));
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
    out.smoothing = read_word<Smoothing>(*smooth, smoothing_names());
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
  if (const auto way = joint.find("way")) out.ways = read_words<Way>(*way, way_names(), "way");
  read_law_keys(joint, out);
  read_smoothing(joint, out);
  item.here([&] { set_structure(out); });
}

}  // namespace

LineScene parse_line_scene(const std::string& text, const std::filesystem::path& file) {
  const scene::Document document(text, file,
                                 {"data", "frequency", "joint", "joints", "nodes", "geometry", "identify", "noise", "virtual_points"});
  LineScene out = read_sections(document, file);
  read_joint(document.table(), out);
  return out;
}

}  // namespace jointid::impedance
