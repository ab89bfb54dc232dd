#include "ident/scene/reduce_joints.hpp"

#include <algorithm>

#include "coupling/groups.hpp"
#include "scene/reader.hpp"
#include "restrictions/linear_expression.hpp"

namespace jointid::ident {
namespace {

using restrictions::Entry;
using restrictions::EntryMatrix;
using restrictions::JointSpec;
using restrictions::Kind;
using restrictions::LinearExpression;
using restrictions::MatrixSpec;
using restrictions::Spring;
using Dofs = std::vector<frf::Dof>;

/// Which coordinates the pairs make one.
class Ties {
 public:
  explicit Ties(const std::vector<std::array<frf::Dof, 2>>& pairs) : groups_(2 * pairs.size()) {
    for (const auto& pair : pairs) {
      for (const frf::Dof& dof : pair) {
        if (!frf::has(dofs_, dof)) dofs_.push_back({dof.node, dof.direction, +1});
      }
      const coupling::Condition condition{index(pair[0]), index(pair[1]), static_cast<double>(pair[0].sign * pair[1].sign)};
      if (groups_.join(condition) != coupling::Groups::Outcome::contradiction) continue;
      throw InputError({ErrorKind::usage, "", "", "couple_first contradicts itself about " + pair[0].name() + " = " + pair[1].name(),
                        "check the signs of the pairs"});
    }
  }

  /// The coordinate that stands for a DOF, the first of its group, with the sign that makes them equal.
  frf::Dof kept(const frf::Dof& dof) const {
    const std::size_t at = frf::find_coordinate(dofs_, dof);
    if (at == frf::npos) return dof;
    coupling::Index first = 0;
    while (!groups_.same(first, static_cast<coupling::Index>(at))) ++first;
    frf::Dof out = dofs_[static_cast<std::size_t>(first)];
    out.sign = dof.sign * (groups_.sign_between(static_cast<coupling::Index>(at), first) > 0.0 ? 1 : -1);
    return out;
  }

 private:
  coupling::Index index(const frf::Dof& dof) const { return static_cast<coupling::Index>(frf::find_coordinate(dofs_, dof)); }

  Dofs dofs_;
  coupling::Groups groups_;
};

/// x = T x' of a joint: DOF i is sign[i] times DOF to[i] of those left; npos: deleted.
struct Connection {
  Dofs dofs;
  std::vector<std::size_t> to;
  std::vector<int> sign;
  std::vector<bool> merged;  ///< of the DOFs left: several became this one

  std::size_t size() const { return dofs.size(); }
};

Connection connect(const Dofs& dofs, const Ties& ties) {
  Connection out;
  for (const frf::Dof& dof : dofs) {
    const frf::Dof kept = ties.kept(dof);
    std::size_t at = frf::find_coordinate(out.dofs, kept);
    if (at == frf::npos) {
      at = out.dofs.size();
      out.dofs.push_back(kept);
      out.merged.push_back(false);
    } else {
      out.merged[at] = true;
    }
    out.to.push_back(at);
    out.sign.push_back(kept.sign * out.dofs[at].sign);
  }
  return out;
}

LinearExpression parse(const Entry& entry) {
  if (const double* number = std::get_if<double>(&entry)) return {*number, {}};
  return restrictions::parse_linear(std::get<std::string>(entry));
}

void add(LinearExpression& to, const LinearExpression& what, double factor) {
  to.constant += factor * what.constant;
  for (const restrictions::LinearTerm& term : what.terms) {
    const auto found = std::ranges::find(to.terms, term.name, &restrictions::LinearTerm::name);
    if (found == to.terms.end()) {
      to.terms.push_back({term.name, factor * term.coefficient});
    } else {
      found->coefficient += factor * term.coefficient;
    }
  }
  std::erase_if(to.terms, [](const restrictions::LinearTerm& term) { return term.coefficient == 0.0; });
}

std::string exact(double value) {
  std::array<char, 32> out{};
  std::snprintf(out.data(), out.size(), "%.17g", value);
  return out.data();
}

Entry entry_of(const LinearExpression& expression) {
  if (expression.terms.empty()) return expression.constant;
  std::string text = expression.constant == 0.0 ? "" : exact(expression.constant);
  for (const restrictions::LinearTerm& term : expression.terms) {
    text += (text.empty() ? "" : " + ") + std::string("(") + exact(term.coefficient) + ")*" + term.name;
  }
  return text;
}

EntryMatrix reduced(const EntryMatrix& matrix, const Connection& connection) {
  std::vector<std::vector<LinearExpression>> sums(connection.size(), std::vector<LinearExpression>(connection.size()));
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    for (std::size_t j = 0; j < matrix.size(); ++j) {
      if (connection.to[i] == frf::npos || connection.to[j] == frf::npos) continue;
      add(sums[connection.to[i]][connection.to[j]], parse(matrix[i][j]), connection.sign[i] * connection.sign[j]);
    }
  }
  EntryMatrix out;
  for (const auto& row : sums) {
    out.emplace_back();
    for (const LinearExpression& sum : row) out.back().push_back(entry_of(sum));
  }
  return out;
}

std::vector<Spring> reduced(const std::vector<Spring>& springs, const Ties& ties) {
  std::vector<Spring> out;
  for (const Spring& spring : springs) {
    Spring moved{ties.kept(spring.first), std::nullopt};
    if (spring.second) moved.second = ties.kept(*spring.second);
    if (!moved.second || !moved.second->same_coordinate(moved.first)) out.push_back(moved);
  }
  return out;
}

/// Whether a matrix, connected already, has anything but zeros that keeps a merged DOF in the joint: ties to other DOFs, and
/// for mass what stands at the DOF itself.
bool needs(Kind kind, const MatrixSpec& spec, const Dofs& dofs, std::size_t at) {
  if (std::holds_alternative<restrictions::Pattern>(spec)) return true;
  if (const auto* springs = std::get_if<std::vector<Spring>>(&spec)) {
    return std::ranges::any_of(*springs, [&](const Spring& spring) {
      return spring.first.same_coordinate(dofs[at]) || (spring.second && spring.second->same_coordinate(dofs[at]));
    });
  }
  const auto& matrix = std::get<EntryMatrix>(spec);
  const auto zero = [](const Entry& entry) {
    const LinearExpression value = parse(entry);
    return value.terms.empty() && value.constant == 0.0;
  };
  for (std::size_t k = 0; k < dofs.size(); ++k) {
    if (k == at && kind != Kind::mass) continue;
    if (!zero(matrix[at][k]) || !zero(matrix[k][at])) return true;
  }
  return false;
}

void erase(Connection& connection, std::size_t at) {
  connection.dofs.erase(connection.dofs.begin() + static_cast<std::ptrdiff_t>(at));
  connection.merged.erase(connection.merged.begin() + static_cast<std::ptrdiff_t>(at));
  for (std::size_t& to : connection.to) {
    if (to == at) {
      to = frf::npos;
    } else if (to != frf::npos && to > at) {
      --to;
    }
  }
}

std::map<Kind, MatrixSpec> reduced(const JointSpec& joint, const Connection& connection, const Ties& ties) {
  std::map<Kind, MatrixSpec> out;
  for (const auto& [kind, spec] : joint.matrices) {
    if (const auto* entries = std::get_if<EntryMatrix>(&spec)) {
      out[kind] = reduced(*entries, connection);
    } else if (const auto* springs = std::get_if<std::vector<Spring>>(&spec)) {
      std::vector<Spring> left = reduced(*springs, ties);
      if (!left.empty()) out[kind] = std::move(left);
    } else {
      out[kind] = spec;
    }
  }
  return out;
}

Connection reduce(JointSpec& joint, const Ties& ties, Dofs& hidden) {
  Connection connection = connect(joint.dofs, ties);
  const std::map<Kind, MatrixSpec> together = reduced(joint, connection, ties);
  const Dofs all = connection.dofs;
  for (std::size_t at = all.size(); at-- > 0;) {
    const bool needed = std::ranges::any_of(together, [&](const auto& matrix) { return needs(matrix.first, matrix.second, all, at); });
    if (!connection.merged[at] || needed) continue;
    hidden.push_back(all[at]);
    erase(connection, at);
  }
  joint.matrices = reduced(joint, connection, ties);
  joint.dofs = connection.dofs;
  return connection;
}

/// TᵀXT over all joints, whose DOFs stand one after the other.
Matrix reduced(const Matrix& matrix, const std::vector<Connection>& joints) {
  std::vector<std::size_t> to;
  std::vector<int> sign;
  std::size_t size = 0;
  for (const Connection& joint : joints) {
    for (std::size_t i = 0; i < joint.to.size(); ++i) {
      to.push_back(joint.to[i] == frf::npos ? frf::npos : size + joint.to[i]);
      sign.push_back(joint.sign[i]);
    }
    size += joint.size();
  }
  Matrix out(size, std::vector<double>(size, 0.0));
  for (std::size_t i = 0; i < to.size(); ++i) {
    for (std::size_t j = 0; j < to.size(); ++j) {
      if (to[i] != frf::npos && to[j] != frf::npos) out[to[i]][to[j]] += sign[i] * sign[j] * matrix[i][j];
    }
  }
  return out;
}

}  // namespace

void reduce_joints(Scene& scene) {
  const Ties ties(scene.couple_first.pairs);
  std::vector<Connection> connections;
  for (JointSpec& joint : scene.joints) connections.push_back(reduce(joint, ties, scene.couple_first.hidden));
  std::erase_if(scene.joints, [](const JointSpec& joint) { return joint.dofs.empty() || joint.matrices.empty(); });
  if (scene.joints.empty()) {
    throw InputError({ErrorKind::usage, "", "", "couple_first makes the whole joint rigid: nothing is left to identify",
                      "leave out a pair"});
  }
  for (auto* matrices : {&scene.truth, &scene.identify.start}) {
    for (auto& [kind, matrix] : *matrices) matrix = reduced(matrix, connections);
  }
}

}  // namespace jointid::ident
