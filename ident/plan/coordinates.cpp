#include "ident/plan/coordinates.hpp"

#include <algorithm>
#include <array>

#include "ident/scene/scene_failure.hpp"

namespace jointid::ident {
namespace {

/// The nearest DOF among those of a system, by spelling.
std::string nearest_dof(const frf::Dof& dof, const frf::FrfSystem& system) {
  return nearest_word(dof.name(), frf::names(system.responses()));
}

/// First joint DOF that is missing from `dofs`, as "4:+RZ", or empty.
std::string first_missing(const Dofs& joint, const Dofs& dofs) {
  for (const frf::Dof& dof : joint) {
    if (!frf::has(dofs, dof)) return dof.name();
  }
  return {};
}

/// What an equation lacks, in words, or empty.
class Availability {
 public:
  Availability(const Scene& scene, const Coordinates& coordinates, const frf::FrfSystem& substructures,
               const frf::FrfSystem& assembly)
      : method_(traits(scene.identify.method)), at_(coordinates), sub_(substructures), asm_(assembly) {}

  /// Whether the methods that need no joint coordinate of the assembly get along without what is lacking.
  bool only_the_joint_on_the_assembly() const {
    return method_.joint_on_assembly && lacks_of_parts(Equation::nn).empty();
  }

  std::string lacks(Equation equation) const {
    if (method_.inverts_substructures) return lacks_to_invert(equation);
    if (!method_.joint_on_assembly) return lacks_of_parts(equation);
    switch (equation) {
      case Equation::nn:
        return first_of({responses(), references(), joint(asm_, false), joint(sub_, true)});
      case Equation::nj:
        return first_of({responses(), joint(asm_, false), joint(sub_, true), joint(sub_, false)});
      case Equation::jj:
        return first_of({joint(asm_, true), joint(asm_, false), joint(sub_, true), joint(sub_, false)});
      case Equation::jn:
        break;
    }
    return first_of({references(), joint(asm_, true), joint(asm_, false), joint(sub_, true)});
  }

 private:
  static std::string first_of(const std::array<std::string, 4>& reasons) {
    for (const std::string& reason : reasons) {
      if (!reason.empty()) return reason;
    }
    return {};
  }

  std::string responses() const {
    return at_.responses.empty() ? "no non-joint response is in both the substructures and the assembly" : "";
  }
  std::string references() const {
    return at_.references.empty() ? "no non-joint reference is in both the substructures and the assembly" : "";
  }
  std::string joint(const frf::FrfSystem& system, bool as_response) const {
    const std::string missing = first_missing(at_.joint, as_response ? system.responses() : system.references());
    if (missing.empty()) return {};
    return "the " + system.name() + (&system == &sub_ ? " have no " : " has no ") + (as_response ? "response " : "reference ") + missing;
  }
  std::string lacks_to_invert(Equation equation) const {
    if (equation == Equation::nn || equation == Equation::nj) return method_.phrase + " has the equations jn and jj only";
    return first_of({joint(sub_, true), joint(sub_, false), joint(asm_, true),
                     equation == Equation::jn ? references() : joint(asm_, false)});
  }
  std::string lacks_of_parts(Equation equation) const {
    if (equation != Equation::nn) return method_.phrase + " uses the equation nn only";
    if (method_.inverts_references && at_.references.size() < at_.joint.size()) {
      return method_.phrase + " needs at least as many non-joint references (" + std::to_string(at_.references.size()) +
             ") as joint DOFs (" + std::to_string(at_.joint.size()) + ")";
    }
    return first_of({responses(), references(), joint(sub_, true), joint(sub_, false)});
  }

  const MethodTraits& method_;
  const Coordinates& at_;
  const frf::FrfSystem& sub_;
  const frf::FrfSystem& asm_;
};

}  // namespace

Dofs joined(Dofs first, const Dofs& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

EquationSet::EquationSet(const std::vector<Equation>& equations) {
  for (const Equation equation : equations) {
    nn = nn || equation == Equation::nn;
    nj = nj || equation == Equation::nj;
    jj = jj || equation == Equation::jj;
    jn = jn || equation == Equation::jn;
  }
}

Coordinates find_coordinates(const Scene& scene, const restrictions::Restriction& restriction,
                             const frf::FrfSystem& substructures, const frf::FrfSystem& assembly) {
  Coordinates at;
  at.joint = restriction.dofs;
  for (const frf::Dof& dof : at.joint) {
    if (frf::has(substructures.responses(), dof) || frf::has(substructures.references(), dof)) continue;
    const std::string near = nearest_dof(dof, substructures);
    fail(scene, "[joint] dofs", "no substructure file has the DOF " + dof.name(),
         near.empty() ? "see `jointid info` for the DOFs of a file" : "did you mean " + near + "?");
  }
  const bool invert = traits(scene.identify.method).inverts_substructures;
  for (const frf::Dof& dof : assembly.responses()) {
    // Their matrix is inverted, so that its coordinates need both roles there.
    const bool usable = frf::has(substructures.responses(), dof) && (!invert || frf::has(substructures.references(), dof));
    if (usable && !frf::has(at.joint, dof)) at.responses.push_back(dof);
  }
  for (const frf::Dof& dof : assembly.references()) {
    // A force outside the inverted coordinates would not vanish in Z_sub H_asm = I − Z_j H_j.
    const bool usable = invert ? frf::has(at.responses, dof) : frf::has(substructures.references(), dof);
    if (usable && !frf::has(at.joint, dof)) at.references.push_back(dof);
  }
  return at;
}

std::vector<Equation> choose_equations(const Scene& scene, const Coordinates& coordinates,
                                       const frf::FrfSystem& substructures, const frf::FrfSystem& assembly) {
  const Availability availability(scene, coordinates, substructures, assembly);
  constexpr std::array<Equation, 4> all = {Equation::nn, Equation::nj, Equation::jj, Equation::jn};
  const std::vector<Equation>& named = scene.identify.equations;
  std::vector<Equation> chosen;
  for (const Equation equation : all) {
    const bool is_named = std::find(named.begin(), named.end(), equation) != named.end();
    if (!named.empty() && !is_named) continue;
    const std::string lack = availability.lacks(equation);
    if (lack.empty()) {
      chosen.push_back(equation);
    } else if (is_named) {
      fail(scene, "[identify] equations", "equation " + name(equation) + " cannot be used: " + lack,
           "leave it out, measure what it lacks, or let `jointid check` look for a mistaken label");
    }
  }
  if (chosen.empty()) {
    const Equation least = traits(scene.identify.method).inverts_substructures ? Equation::jn : Equation::nn;
    fail(scene, "[data]", "the data allow no equation: " + availability.lacks(least),
         availability.only_the_joint_on_the_assembly()
             ? "measure it, or use method = \"likelihood\" with a start, e.g. start = { stiffness = [[1e6, …], …] }: it needs no "
               "joint coordinate of the assembly (method \"direct\" neither, but it bears no noise)"
             : "measure it");
  }
  return chosen;
}

std::vector<Equation> equations_by_parts(const Scene& scene, const Coordinates& coordinates, const frf::FrfSystem& substructures,
                                         const frf::FrfSystem& assembly) {
  const Dofs& joint = coordinates.joint;
  constexpr std::size_t fewest_parts = 3;  // of two parts the FRF that is missing is named
  const bool balances = scene.identify.method == Method::one || scene.identify.method == Method::likelihood;
  if (!balances || substructures.source_count() < fewest_parts) return {};
  if (!first_missing(joint, assembly.responses()).empty() || !first_missing(joint, substructures.references()).empty()) return {};
  const bool forces = std::ranges::any_of(joint, [&](const frf::Dof& dof) { return frf::has(assembly.references(), dof); });
  const bool motion = first_missing(joint, substructures.responses()).empty();
  const bool n_rows = !coordinates.responses.empty(), n_columns = !coordinates.references.empty();
  const std::pair<Equation, bool> all[] = {{Equation::nn, n_rows && n_columns},
                                           {Equation::nj, n_rows && forces},
                                           {Equation::jj, motion && forces},
                                           {Equation::jn, motion && n_columns}};
  const std::vector<Equation>& named = scene.identify.equations;
  std::vector<Equation> chosen;
  for (const auto& [equation, is_there] : all) {
    const bool wanted = named.empty() || std::ranges::find(named, equation) != named.end();
    if (wanted && is_there) chosen.push_back(equation);
    if (wanted && !is_there && !named.empty()) return {};
  }
  return chosen;
}

}  // namespace jointid::ident
