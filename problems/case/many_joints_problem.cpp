#include "problems/case/many_joints_problem.hpp"

#include <algorithm>

#include "base/text.hpp"
#include "problems/case/case.hpp"

namespace jointid::problems {
namespace {

constexpr double many_joints_noise = 0.01;
constexpr std::size_t most_of_truth = 300;  ///< joint coordinates; larger matrices are only in truth.json, by their unknowns
constexpr std::size_t most_of_modes = 400;  ///< coordinates of the assembly

bool is_diagonal(const Matrix& matrix) {
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    for (std::size_t j = 0; j < matrix.size(); ++j) {
      if (i != j && matrix[i][j] != 0.0) return false;
    }
  }
  return true;
}

/// [a b −a −b; b c −b −c; …] of a relative 2 × 2 matrix.
JointMatrix relative(Kind kind, const BeamJoint& joint, const Matrix& x) {
  restrictions::EntryMatrix entries(4, std::vector<restrictions::Entry>(4));
  const std::string letters[2][2] = {{"a", "b"}, {"b", "c"}};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) entries[i][j] = (i / 2 == j / 2 ? "" : "-") + letters[i % 2][j % 2];
  }
  return expressed(kind, joint.over_dofs(x), std::move(entries), {{"a", x[0][0]}, {"b", x[0][1]}, {"c", x[1][1]}});
}

/// A joint of the scene: one of the structure, or those that share coordinates.
struct SceneJoint {
  std::string name;
  std::vector<frf::Dof> dofs;
  std::vector<const BeamJoint*> members;
};

std::vector<SceneJoint> scene_joints(const ManyJoints& structure) {
  std::vector<SceneJoint> out;
  for (const BeamJoint& joint : structure.joints) {
    const auto shared = [&](const SceneJoint& each) {
      return std::ranges::any_of(joint.dofs, [&](const frf::Dof& dof) { return frf::has(each.dofs, dof); });
    };
    if (out.empty() || !shared(out.back())) out.push_back({"j" + std::to_string(out.size() + 1), {}, {}});
    SceneJoint& to = out.back();
    to.members.push_back(&joint);
    for (const frf::Dof& dof : joint.dofs) {
      if (!frf::has(to.dofs, dof)) to.dofs.push_back(dof);
    }
  }
  return out;
}

const Matrix& relative_of(Kind kind, const BeamJoint& joint) {
  return kind == Kind::stiffness ? joint.relative_stiffness : joint.relative_damping;
}

JointMatrix springs_of(Kind kind, const SceneJoint& joint) {
  std::vector<restrictions::Spring> ends;
  std::vector<double> values;
  for (const BeamJoint* member : joint.members) {
    const Matrix& x = relative_of(kind, *member);
    const bool ground = member->dofs.size() == x.size();
    for (std::size_t q = 0; q < x.size(); ++q) {
      ends.push_back({member->dofs[q], ground ? std::nullopt : std::optional(member->dofs[q + x.size()])});
      values.push_back(x[q][q]);
    }
  }
  return springs(kind, joint.dofs, std::move(ends), values);
}

JointMatrix matrix_of(Kind kind, const SceneJoint& joint, bool all_elements) {
  const BeamJoint& first = *joint.members.front();
  const Matrix& x = relative_of(kind, first);
  if (is_diagonal(x)) return springs_of(kind, joint);
  return all_elements ? symmetric(kind, first.over_dofs(x)) : relative(kind, first, x);
}

std::string in_quotes(const std::string& text) { return "\"" + text + "\""; }

std::string dof_list_text(const std::vector<frf::Dof>& dofs) {
  return "[" + comma_list(dofs, [](const frf::Dof& dof) { return in_quotes(dof.name()); }) + "]";
}

std::string joint_declaration(const restrictions::MatrixSpec& spec) {
  if (const auto* springs = std::get_if<std::vector<restrictions::Spring>>(&spec)) {
    const auto spring = [](const restrictions::Spring& each) {
      return "[" + in_quotes(each.first.name()) + ", " + in_quotes(each.second ? each.second->name() : "ground") + "]";
    };
    return "springs = [" + comma_list(*springs, spring) + "]\n";
  }
  const auto* entries = std::get_if<restrictions::EntryMatrix>(&spec);
  if (entries == nullptr) return "pattern = \"symmetric\"\n";
  const auto row = [](const std::vector<restrictions::Entry>& each) {
    return "[" + comma_list(each, [](const restrictions::Entry& entry) { return in_quotes(std::get<std::string>(entry)); }) + "]";
  };
  return "matrix = [" + comma_list(*entries, row) + "]\n";
}

std::string number(double value) { return digits(value, "%.17g"); }

std::string matrix_rows_text(const Matrix& matrix) {
  return "[" + comma_list(matrix, [](const std::vector<double>& row) { return "[" + comma_list(row, number) + "]"; }) + "]";
}

/// The joint as it should be, by numbers: the stiffness of which `loose` finds a share, and the damping.
std::string nominal_text(const BeamJoint& joint) {
  return "[joints.stiffness]\nmatrix = " + matrix_rows_text(joint.over_dofs(joint.relative_stiffness)) +
         "\n[joints.hysteretic_damping]\nmatrix = " + matrix_rows_text(joint.over_dofs(joint.relative_damping)) + "\n";
}

/// `nominal`: the joints as they should be, where the scene asks which are loose; else nullptr.
std::string scene_of_many(const Problem& problem, const ManyJoints& structure, bool all_elements, const ManyJoints* nominal) {
  const auto file = [](const frf::FrfSet& set) { return in_quotes(set.header.file); };
  std::string text = "title = " + in_quotes(problem.name + ": " + problem.description) + "\n\n[data]\nsubstructures = [" +
                     comma_list(problem.substructures, file) + "]\nassembly = [" + file(problem.assembly) + "]\n\n[frequency]\nrange = [" +
                     number(structure.frequency_hz.front()) + ", " + number(structure.frequency_hz.back()) + "]  # Hz\n";
  for (const SceneJoint& joint : scene_joints(structure)) {
    text += "\n[[joints]]\nname = " + in_quotes(joint.name) + "\ndofs = " + dof_list_text(joint.dofs) + "\n";
    if (nominal != nullptr) {
      text += nominal_text(nominal->joints[static_cast<std::size_t>(joint.members.front() - structure.joints.data())]);
      continue;
    }
    text += "[joints.stiffness]\n" +
            joint_declaration(matrix_of(Kind::stiffness, joint, all_elements).spec) + "[joints.hysteretic_damping]\n" +
            joint_declaration(matrix_of(Kind::hysteretic_damping, joint, all_elements).spec);
  }
  text += nominal != nullptr ? "\n[identify]\nmethod = \"auto\"\nloose = true\n" : "\n[identify]\nmethod = \"one\"\nweighting = \"WB\"\n";
  text += "\n[noise]\nmodel = \"circular\"\nlevel = " + number(many_joints_noise) + "\n";
  if (!problem.truth.empty()) text += "\n[truth]\n";
  for (const auto& [kind, matrix] : problem.truth) text += restrictions::key(kind) + " = " + matrix_rows_text(matrix) + "\n";
  return text;
}

/// The joint matrices over all joint coordinates.
Matrix whole_matrix(const std::vector<SceneJoint>& joints, Kind kind, bool all_elements, std::size_t coordinates) {
  Matrix out(coordinates, std::vector<double>(coordinates));
  std::size_t first = 0;
  for (const SceneJoint& joint : joints) {
    const Matrix own = matrix_of(kind, joint, all_elements).truth;
    for (std::size_t i = 0; i < own.size(); ++i)
      std::copy(own[i].begin(), own[i].end(), out[first + i].begin() + static_cast<std::ptrdiff_t>(first));
    first += own.size();
  }
  return out;
}

Modes assembly_modes(const ManyJoints& structure) {
  Structure all = structure.parts.front();
  for (std::size_t s = 1; s < structure.parts.size(); ++s) all = merged(all, structure.parts[s]);
  for (const BeamJoint& joint : structure.joints) {
    all.add(Kind::stiffness, joint.dofs, joint.over_dofs(joint.relative_stiffness));
    all.add(Kind::hysteretic_damping, joint.dofs, joint.over_dofs(joint.relative_damping));
  }
  return modes(all);
}

}  // namespace

std::vector<ProblemInfo> list_many_joints() {
  return {{"chain-50", "51 beams in a row on 50 joints, motion at all coordinates, 11 shakers, 1 % noise"},
          {"frame-40", "a plane frame of 28 beams on 40 joints, four of them to the ground, 4 shakers, 1 % noise"},
          {"star-50", "50 beams on one long beam that carries every joint, 11 shakers, 1 % noise"},
          {"loose-3", "chain-50 with three loose joints among 50 of known nominal stiffness, motion at all coordinates, 1 % noise"},
          {"chain-500", "501 beams in a row on 500 joints of 20 unknowns each, 101 shakers, 1 % noise"}};
}

bool is_many_joints(const std::string& name) { return std::ranges::count(list_many_joints(), name, &ProblemInfo::name) > 0; }

ManyJoints many_joints(const std::string& name) {
  if (name == "frame-40") return frame_of_beams({});
  if (name == "star-50") return star_of_beams({});
  return chain_of_beams({.joints = name == "chain-500" ? 500u : 50u});
}

namespace {

Problem problem_of(const ManyJoints& structure, const ProblemInfo& info, bool all_elements, const ManyJoints* nominal) {
  Problem problem;
  problem.name = info.name;
  problem.description = info.description;
  problem.noise = frf::NoiseModel{.kind = frf::NoiseKind::circular, .level = many_joints_noise, .reciprocal = false};
  for (std::size_t s = 0; s < structure.parts.size(); ++s) {
    problem.substructures.push_back(part_receptances(structure, s));
    problem.substructures.back().header.file = info.name + "_part_" + std::to_string(s + 1) + ".h5";
    problem.substructure_modes.push_back(modes(structure.parts[s]));
  }
  problem.assembly = assembly_receptances(structure);
  problem.assembly.header.file = info.name + "_assembly.h5";
  if (problem.assembly.header.response.size() <= most_of_modes) problem.assembly_modes = assembly_modes(structure);
  const std::vector<SceneJoint> joints = scene_joints(structure);
  for (const SceneJoint& joint : joints) problem.joint_dofs.insert(problem.joint_dofs.end(), joint.dofs.begin(), joint.dofs.end());
  const std::size_t coordinates = problem.joint_dofs.size();
  for (const Kind kind : {Kind::stiffness, Kind::hysteretic_damping}) {
    for (const SceneJoint& joint : joints) {
      if (nominal != nullptr) continue;
      for (const ExactUnknown& unknown : matrix_of(kind, joint, all_elements).unknowns)
        problem.unknowns.push_back({joint.name + "." + unknown.name, unknown.value});
    }
    if (coordinates <= most_of_truth) problem.truth[kind] = whole_matrix(joints, kind, all_elements, coordinates);
  }
  for (std::size_t e = 0; nominal != nullptr && e < joints.size(); ++e) {
    const double share = structure.joints[e].relative_stiffness[0][0] / nominal->joints[e].relative_stiffness[0][0];
    problem.unknowns.push_back({joints[e].name + ".K.share", share});
  }
  problem.scene = scene_of_many(problem, structure, all_elements, nominal);
  return problem;
}

}  // namespace

Problem many_joints_problem(const ManyJoints& structure, const ProblemInfo& info, bool all_elements) {
  return problem_of(structure, info, all_elements, nullptr);
}

Problem loose_joints_problem(const ManyJoints& nominal, const std::map<std::size_t, double>& lost, const ProblemInfo& info) {
  ManyJoints structure = nominal;
  for (const auto& [joint, share] : lost) {
    for (std::vector<double>& row : structure.joints[joint].relative_stiffness) {
      for (double& element : row) element *= 1.0 - share;
    }
  }
  return problem_of(structure, info, false, &nominal);
}

Problem make_many_joints(const std::string& name) {
  const std::vector<ProblemInfo> infos = list_many_joints();
  const ProblemInfo& info = *std::ranges::find(infos, name, &ProblemInfo::name);
  if (name == "loose-3") return loose_joints_problem(many_joints(name), {{11, 0.7}, {26, 0.5}, {37, 0.8}}, info);
  return many_joints_problem(many_joints(name), info, name == "chain-500");
}

}  // namespace jointid::problems
