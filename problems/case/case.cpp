#include "problems/case/case.hpp"

#include <utility>

#include "problems/structure/spring_coupling.hpp"

namespace jointid::problems {
namespace {

std::vector<frf::Dof> measured(const Structure& structure, const std::vector<frf::Dof>& chosen) {
  if (chosen.empty()) return structure.dofs();
  std::vector<frf::Dof> result;
  for (const frf::Dof& dof : structure.dofs()) {
    if (frf::has(chosen, dof)) result.push_back(dof);
  }
  return result;
}

void add_hammer_coherence(frf::FrfSet& set, const HammerCoherence& hammer, double averages) {
  set.header.noise = frf::NoiseRecord::coherence;
  set.header.averages = averages;
  set.coherence.reserve(set.values.size());
  for (std::size_t i = 0; i < set.values.size(); ++i) {
    const double frequency = set.header.frequency_hz[i / set.header.entries()];
    const double accelerance =
        std::abs(set.values[i] * frf::from_receptance(frf::Quantity::accelerance, frequency));
    const double floor = hammer.accelerance_floor / accelerance;
    set.coherence.push_back(1.0 / (1.0 / hammer.ceiling + floor * floor));
  }
}

ResponseRequest request_of(const Case& definition, const Structure& structure, const std::vector<frf::Dof>& chosen) {
  const std::vector<frf::Dof> dofs = measured(structure, chosen);
  return {.response = dofs, .reference = dofs, .frequency_hz = frequencies(definition.axis), .window_rate = definition.window_rate};
}

/// What the file of a structure holds, from its receptances.
frf::FrfSet clean_set(const Case& definition, frf::FrfSet set, const std::string& file) {
  set.header.file = file;
  set.header.quantity = definition.quantity;
  if (definition.accelerometer_mass > 0.0) {
    set = with_accelerometer(set, definition.accelerometer_mass, definition.window_rate);
  }
  if (definition.hammer) {
    add_hammer_coherence(set, *definition.hammer, std::get<frf::NoiseModel>(definition.noise).averages);
  }
  return set;
}

frf::FrfSet part_response(const Case& definition, const Structure& part, const Modes& all_modes) {
  const ResponseRequest request = request_of(definition, part, definition.measured_substructures);
  return definition.coupled_by_springs ? modal_response(all_modes, request) : frequency_response(part, request);
}

std::vector<ComplexSpring> complex_springs(const Case& definition) {
  std::vector<ComplexSpring> result;
  for (const JointMatrix& matrix : definition.joint) {
    const auto& springs = std::get<std::vector<restrictions::Spring>>(matrix.spec);
    const Complex unit = matrix.kind == Kind::stiffness ? Complex(1.0) : Complex(0.0, 1.0);
    result.resize(springs.size());
    for (std::size_t i = 0; i < springs.size(); ++i) {
      result[i].ends = springs[i];
      result[i].stiffness += unit * matrix.unknowns[i].value;
    }
  }
  return result;
}

frf::FrfSet assembly_response(const Case& definition, const std::vector<frf::FrfSet>& parts) {
  if (definition.coupled_by_springs) return with_springs(side_by_side(parts), complex_springs(definition));
  return frequency_response(definition.assembly, request_of(definition, definition.assembly, definition.measured_assembly));
}

}  // namespace

JointMatrix springs(Kind kind, const std::vector<frf::Dof>& joint_dofs, std::vector<restrictions::Spring> springs,
                    const std::vector<double>& values) {
  Structure joint({}, joint_dofs);
  JointMatrix result{.kind = kind, .truth = {}, .spec = {}, .unknowns = {}};
  for (std::size_t i = 0; i < springs.size(); ++i) {
    joint.add(kind, springs[i], values[i]);
    const std::string other = springs[i].second ? springs[i].second->name() : "ground";
    result.unknowns.push_back({restrictions::symbol(kind) + "[" + springs[i].first.name() + "," + other + "]", values[i]});
  }
  const std::size_t n = joint_dofs.size();
  for (std::size_t i = 0; i < n; ++i) {
    const auto row = joint.matrix(kind).begin() + static_cast<std::ptrdiff_t>(i * n);
    result.truth.emplace_back(row, row + static_cast<std::ptrdiff_t>(n));
  }
  result.spec = std::move(springs);
  return result;
}

std::vector<double> frequencies(const Axis& axis) {
  std::vector<double> result(axis.lines);
  for (std::size_t i = 0; i < axis.lines; ++i)
    result[i] = axis.start_hz + static_cast<double>(i) * axis.step_hz;
  return result;
}

JointMatrix symmetric(Kind kind, Matrix truth) {
  JointMatrix result{
      .kind = kind, .truth = std::move(truth), .spec = restrictions::Pattern::symmetric, .unknowns = {}};
  for (std::size_t i = 0; i < result.truth.size(); ++i) {
    for (std::size_t j = i; j < result.truth.size(); ++j) {
      const std::string place = "(" + std::to_string(i + 1) + "," + std::to_string(j + 1) + ")";
      result.unknowns.push_back({restrictions::symbol(kind) + place, result.truth[i][j]});
    }
  }
  return result;
}

JointMatrix expressed(Kind kind, const Matrix& truth, restrictions::EntryMatrix entries,
                      const std::vector<ExactUnknown>& letters) {
  JointMatrix result{.kind = kind, .truth = truth, .spec = std::move(entries), .unknowns = {}};
  for (const ExactUnknown& letter : letters) {
    result.unknowns.push_back({restrictions::symbol(kind) + "." + letter.name, letter.value});
  }
  return result;
}

Structure assembled(const std::vector<Structure>& parts, const std::vector<frf::Dof>& joint_dofs,
                    const std::vector<JointMatrix>& joint) {
  Structure result = parts.front();
  for (std::size_t i = 1; i < parts.size(); ++i) result = merged(result, parts[i]);
  for (const JointMatrix& matrix : joint) result.add(matrix.kind, joint_dofs, matrix.truth);
  return result;
}

Problem build(const Case& definition) {
  Problem problem;
  problem.name = definition.name;
  problem.description = definition.description;
  problem.joint_dofs = definition.joint_dofs;
  problem.noise = definition.noise;
  std::vector<frf::FrfSet> parts;
  for (std::size_t i = 0; i < definition.substructures.size(); ++i) {
    const std::string file = definition.name + "_substructure_" + std::to_string(i + 1) + ".h5";
    const Structure& part = definition.substructures[i];
    problem.substructure_modes.push_back(modes(part));
    parts.push_back(part_response(definition, part, problem.substructure_modes.back()));
    problem.substructures.push_back(clean_set(definition, parts.back(), file));
  }
  problem.assembly = clean_set(definition, assembly_response(definition, parts), definition.name + "_assembly.h5");
  problem.assembly_modes = modes(definition.assembly);
  for (const JointMatrix& matrix : definition.joint) {
    problem.truth[matrix.kind] = matrix.truth;
    problem.unknowns.insert(problem.unknowns.end(), matrix.unknowns.begin(), matrix.unknowns.end());
  }
  problem.scene = scene_text(definition, problem);
  return problem;
}

}  // namespace jointid::problems
