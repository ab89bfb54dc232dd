#include "coupling/layout.hpp"

#include <algorithm>
#include <numeric>
#include <set>
#include <tuple>

#include "base/eigen.hpp"
#include "base/error.hpp"
#include "coupling/groups.hpp"
#include "restrictions/impedance_factor.hpp"

namespace jointid::coupling {

using restrictions::Kind;

namespace {

struct Found {
  Coordinate coordinate;
  double sign = 1.0;  ///< of the DOF asked for to the part's
};

class Builder {
 public:
  Builder(const std::vector<Part>& parts, const Assembly& assembly, const std::string& where)
      : parts_(parts), assembly_(assembly), where_(where) {}

  Layout build() {
    layout_.part_sign.assign(parts_.size(), 1.0);
    for (const std::string& name : assembly_.remove) layout_.part_sign[part_index(name)] = -1.0;
    collect_connected();
    Groups groups(layout_.connected.size());
    add_conditions(groups);
    add_joint();
    if (layout_.connected.empty()) fail("", "nothing is coupled", "name DOFs to join or to ground, or a joint");
    choose_result(groups, true);
    choose_result(groups, false);
    return std::move(layout_);
  }

 private:
  [[noreturn]] void fail(std::string place, std::string problem, std::string remedy) const {
    throw InputError({.kind = ErrorKind::usage,
                      .file = where_,
                      .place = std::move(place),
                      .problem = std::move(problem),
                      .remedy = std::move(remedy)});
  }

  std::size_t part_index(const std::string& name) const {
    std::vector<std::string> names;
    for (std::size_t p = 0; p < parts_.size(); ++p) {
      if (parts_[p].name == name) return p;
      names.push_back(parts_[p].name);
    }
    const std::string near = nearest_word(name, names);
    fail("", "there is no part " + name, near.empty() ? "use one of the parts" : "did you mean " + near + "?");
  }

  std::string nearest(const frf::Dof& dof) const {
    std::vector<std::string> names;
    for (const Part& part : parts_) {
      for (const frf::Dof& other : part.system->responses()) names.push_back(other.name());
    }
    const std::string near = nearest_word(dof.name(), names);
    return near.empty() ? "see `jointid info` for the DOFs of a file" : "did you mean " + near + "?";
  }

  Found find(const PlacedDof& placed) const {
    std::vector<std::size_t> owners;
    for (std::size_t p = 0; p < parts_.size(); ++p) {
      const frf::FrfSystem& system = *parts_[p].system;
      if (!placed.part.empty() && p != part_index(placed.part)) continue;
      if (frf::has(system.responses(), placed.dof) || frf::has(system.references(), placed.dof)) owners.push_back(p);
    }
    if (owners.empty()) {
      fail("DOF " + placed.name(), placed.part.empty() ? "no part has it" : "the part has no such DOF", nearest(placed.dof));
    }
    if (owners.size() > 1) {
      const std::string &one = parts_[owners[0]].name, &two = parts_[owners[1]].name;
      fail("DOF " + placed.name(), "it is in " + one + " and in " + two,
           "name the one that is meant: \"" + one + "/" + placed.dof.name() + "\"");
    }
    const frf::FrfSystem& system = *parts_[owners[0]].system;
    const std::vector<frf::Dof>& dofs = frf::has(system.responses(), placed.dof) ? system.responses() : system.references();
    const frf::Dof& own = dofs[frf::find_coordinate(dofs, placed.dof)];
    return {{owners[0], own}, static_cast<double>(own.sign * placed.dof.sign)};
  }

  Index find_connected(const Coordinate& coordinate) const {
    const auto at = std::ranges::find_if(layout_.connected, [&](const Coordinate& other) {
      return other.part == coordinate.part && other.dof.same_coordinate(coordinate.dof);
    });
    return at == layout_.connected.end() ? -1 : at - layout_.connected.begin();
  }

  void connect(const PlacedDof& placed) {
    const Coordinate coordinate = find(placed).coordinate;
    if (find_connected(coordinate) >= 0) return;
    const frf::FrfSystem& system = *parts_[coordinate.part].system;
    const bool response = frf::has(system.responses(), coordinate.dof), reference = frf::has(system.references(), coordinate.dof);
    if (!response || !reference) {
      fail("DOF " + placed.name(), std::string("it is no ") + (response ? "reference" : "response") + " of " + parts_[coordinate.part].name,
           "coordinates that are coupled need both roles: measure it, or set reciprocity = true");
    }
    layout_.connected.push_back(coordinate);
  }

  void collect_connected() {
    for (const auto& dofs : assembly_.join) std::ranges::for_each(dofs, [&](const PlacedDof& dof) { connect(dof); });
    std::ranges::for_each(assembly_.ground, [&](const PlacedDof& dof) { connect(dof); });
    for (const KnownJoint& joint : assembly_.joints) {
      std::ranges::for_each(joint.dofs, [&](const PlacedDof& dof) { connect(dof); });
    }
  }

  void add_condition(const Condition& condition, const std::string& name, Groups& groups) {
    const Groups::Outcome outcome = groups.join(condition);
    if (outcome == Groups::Outcome::contradiction) {
      fail(name, "it contradicts the other conditions: together they hold the coordinate in place",
           "check the signs, or ground it");
    }
    if (outcome == Groups::Outcome::implied) return;
    layout_.conditions.push_back(condition);
    layout_.condition_names.push_back(name);
  }

  void add_conditions(Groups& groups) {
    for (const auto& dofs : assembly_.join) {
      const Found first = find(dofs.front());
      for (std::size_t k = 1; k < dofs.size(); ++k) {
        const Found other = find(dofs[k]);
        add_condition({find_connected(first.coordinate), find_connected(other.coordinate), first.sign * other.sign},
                      dofs.front().name() + " = " + dofs[k].name(), groups);
      }
    }
    for (const PlacedDof& dof : assembly_.ground) {
      add_condition({find_connected(find(dof).coordinate), std::nullopt, 1.0}, dof.name() + " = 0", groups);
    }
  }

  void add_joint() {
    std::vector<Index>& at = layout_.joint.at;
    for (const KnownJoint& joint : assembly_.joints) {
      for (const PlacedDof& dof : joint.dofs) {
        const Index index = find_connected(find(dof).coordinate);
        if (std::ranges::find(at, index) == at.end()) at.push_back(index);
      }
    }
    const auto n = jointid::at(at.size());
    make_zero(n, layout_.joint);
    for (const KnownJoint& joint : assembly_.joints) {
      add_matrices(joint, joint, layout_.joint);
      if (joint.uncertainty) add_uncertainty(joint, n);
    }
  }

  static void make_zero(Index n, LayoutJoint& joint) {
    for (Eigen::MatrixXd* matrix : {&joint.stiffness, &joint.mass, &joint.viscous_damping, &joint.hysteretic_damping}) {
      *matrix = Eigen::MatrixXd::Zero(n, n);
    }
  }

  /// The four of something over the DOFs of a joint.
  template <class Matrices>
  void add_matrices(const KnownJoint& joint, const Matrices& of, LayoutJoint& to) const {
    add_matrix(joint, of.stiffness, to.stiffness);
    add_matrix(joint, of.mass, to.mass);
    add_matrix(joint, of.viscous_damping, to.viscous_damping);
    add_matrix(joint, of.hysteretic_damping, to.hysteretic_damping);
  }

  void add_uncertainty(const KnownJoint& joint, Index n) {
    LayoutJoint& all = layout_.joint;
    const auto before = jointid::at(all.by_unknown.size()), own = jointid::at(joint.uncertainty->unknowns.size());
    for (const JointUncertainty::Unknown& unknown : joint.uncertainty->unknowns) {
      all.by_unknown.emplace_back();
      make_zero(n, all.by_unknown.back());
      add_matrices(joint, unknown, all.by_unknown.back());
    }
    const Eigen::MatrixXd known = all.covariance;
    all.covariance = Eigen::MatrixXd::Zero(before + own, before + own);
    all.covariance.topLeftCorner(before, before) = known;
    all.covariance.bottomRightCorner(own, own) = Eigen::Map<const Eigen::MatrixXd>(joint.uncertainty->covariance.data(), own, own);
    all.identified.push_back(joint.uncertainty);
  }

  void add_matrix(const KnownJoint& joint, const std::vector<double>& values, Eigen::MatrixXd& to) const {
    if (values.empty()) return;
    std::vector<Index> at;
    std::vector<double> sign;
    for (const PlacedDof& dof : joint.dofs) {
      const Found found = find(dof);
      at.push_back(std::ranges::find(layout_.joint.at, find_connected(found.coordinate)) - layout_.joint.at.begin());
      sign.push_back(found.sign);
    }
    for (std::size_t i = 0; i < at.size(); ++i) {
      for (std::size_t j = 0; j < at.size(); ++j) to(at[i], at[j]) += sign[i] * sign[j] * values[i * at.size() + j];
    }
  }

  bool hidden(const Coordinate& coordinate, Index connected, const Groups& groups) const {
    return std::ranges::any_of(assembly_.hide, [&](const PlacedDof& dof) {
      const Found found = find(dof);
      const Index other = find_connected(found.coordinate);
      if (other >= 0 && connected >= 0) return groups.same(other, connected);
      return found.coordinate.part == coordinate.part && found.coordinate.dof.same_coordinate(coordinate.dof);
    });
  }

  bool first_of_group(Index connected, const Groups& groups) const {
    for (Index i = 0; i < connected; ++i) {
      const bool stays = layout_.part_sign[layout_.connected[static_cast<std::size_t>(i)].part] > 0.0;
      if (stays && groups.same(i, connected)) return false;
    }
    return true;
  }

  void choose_result(const Groups& groups, bool responses) {
    std::vector<ResultDof>& out = responses ? layout_.responses : layout_.references;
    const auto dofs_of = [&](std::size_t part) {
      return responses ? parts_[part].system->responses() : parts_[part].system->references();
    };
    for (const PlacedDof& placed : assembly_.keep) {
      const Found found = find(placed);
      const Index connected = find_connected(found.coordinate);
      if (layout_.part_sign[found.coordinate.part] < 0.0) fail("DOF " + placed.name(), "it is of a part that is removed", "keep others");
      if (connected >= 0 && groups.grounded(connected)) fail("DOF " + placed.name(), "it is grounded", "keep others");
      if (frf::has(dofs_of(found.coordinate.part), placed.dof)) out.push_back({found.coordinate, connected, found.sign, placed.dof});
    }
    for (std::size_t p = 0; p < parts_.size() && assembly_.keep.empty(); ++p) {
      if (layout_.part_sign[p] < 0.0) continue;
      for (const frf::Dof& dof : dofs_of(p)) {
        const Coordinate coordinate = find({parts_[p].name, dof}).coordinate;
        const Index connected = find_connected(coordinate);
        if (connected >= 0 && (groups.grounded(connected) || !first_of_group(connected, groups))) continue;
        if (hidden(coordinate, connected, groups)) continue;
        out.push_back({coordinate, connected, 1.0, coordinate.dof});
      }
    }
    check_result(out, responses);
  }

  void check_result(const std::vector<ResultDof>& result, bool responses) const {
    if (result.empty()) fail("", std::string("no ") + (responses ? "response" : "reference") + " is left", "keep a DOF that has that role");
    for (std::size_t i = 0; i < result.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (!result[i].dof.same_coordinate(result[j].dof)) continue;
        fail("DOF " + result[i].dof.name(),
             "the result would have it twice, of " + parts_[result[j].coordinate.part].name + " and of " +
                 parts_[result[i].coordinate.part].name,
             "join the two, keep one of them, or number the nodes of the parts differently");
      }
    }
  }

  const std::vector<Part>& parts_;
  const Assembly& assembly_;
  const std::string& where_;
  Layout layout_;
};

}  // namespace

std::vector<Complex> LayoutJoint::common(const std::string& part, const frf::Dof& row, const frf::Dof& column, double hz) const {
  std::vector<Complex> out;
  for (const auto& joint : identified) {
    std::vector<Complex> own = joint->common ? joint->common(part, row, column, hz) : std::vector<Complex>();
    own.resize(joint->unknowns.size());
    out.insert(out.end(), own.begin(), own.end());
  }
  return out;
}

ComplexMatrix LayoutJoint::dynamic_stiffness(double omega) const {
  ComplexMatrix z = ComplexMatrix::Zero(stiffness.rows(), stiffness.cols());
  const std::pair<Kind, const Eigen::MatrixXd&> matrices[] = {{Kind::stiffness, stiffness},
                                                              {Kind::mass, mass},
                                                              {Kind::viscous_damping, viscous_damping},
                                                              {Kind::hysteretic_damping, hysteretic_damping}};
  for (const auto& [kind, matrix] : matrices) restrictions::add_impedance(kind, matrix, omega, z);
  return z;
}

Layout make_layout(const std::vector<Part>& parts, const Assembly& assembly, const std::string& where) {
  return Builder(parts, assembly, where).build();
}

std::vector<std::size_t> bodies(const std::vector<Part>& parts, const std::vector<Coordinate>& coordinates) {
  std::vector<std::size_t> first{0}, out;  // files are numbered through all parts
  for (const Part& part : parts) first.push_back(first.back() + part.system->source_count());
  for (const Coordinate& coordinate : coordinates) {
    out.push_back(first[coordinate.part] + parts[coordinate.part].system->source_of(coordinate.dof));
  }
  return out;
}

}  // namespace jointid::coupling
