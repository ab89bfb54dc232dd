#include "restrictions/restriction.hpp"

#include <algorithm>
#include <cassert>
#include <set>
#include <tuple>

#include "base/error.hpp"
#include "restrictions/local_matrix.hpp"

namespace jointid::restrictions {
namespace {

[[noreturn]] void fail_joint(const JointSpec& joint, const std::string& problem, const std::string& remedy) {
  throw InputError({.kind = ErrorKind::usage,
                    .file = {},
                    .place = joint.name.empty() ? "[joint]" : "joint '" + joint.name + "'",
                    .problem = problem,
                    .remedy = remedy});
}

void check_names(const std::vector<JointSpec>& joints) {
  if (joints.empty()) {
    throw InputError({.kind = ErrorKind::usage,
                      .file = {},
                      .place = {},
                      .problem = "there is no joint",
                      .remedy = "declare [joint] or [[joints]]"});
  }
  std::set<std::string> names;
  for (const JointSpec& joint : joints) {
    if (joints.size() > 1 && joint.name.empty()) {
      fail_joint(joint, "one of several joints has no name", "give every [[joints]] a name");
    }
    if (!names.insert(joint.name).second) fail_joint(joint, "two joints have this name", "name them apart");
  }
}

void check_dofs(const std::vector<JointSpec>& joints) {
  std::map<std::int64_t, std::string> owner;  // by coordinate
  for (const JointSpec& joint : joints) {
    if (joint.dofs.empty()) fail_joint(joint, "dofs is empty", "list the joint's DOFs");
    if (joint.matrices.empty()) {
      fail_joint(joint, "the joint has no matrix", "give it stiffness, mass, viscous_damping or hysteretic_damping");
    }
    for (const frf::Dof& dof : joint.dofs) {
      const auto [same, is_new] = owner.try_emplace(frf::coordinate_key(dof), joint.name);
      if (is_new) continue;
      if (same->second == joint.name) fail_joint(joint, "dofs has the coordinate of " + dof.name() + " twice", "");
      fail_joint(joint, dof.name() + " is a DOF of joint '" + same->second + "', too",
                 "make joints that share a DOF one joint");
    }
  }
}

LocalMatrix local_matrix(const JointSpec& joint, Kind kind, const MatrixSpec& spec) {
  if (const auto* pattern = std::get_if<Pattern>(&spec)) {
    return *pattern == Pattern::free ? from_free_pattern(joint, kind) : from_pattern(joint, kind, *pattern);
  }
  if (const auto* entries = std::get_if<EntryMatrix>(&spec)) return from_entries(joint, kind, *entries);
  return from_springs(joint, kind, std::get<std::vector<Spring>>(spec));
}

/// Moves one joint's matrix to its rows, columns and unknowns of the whole.
void append(Restriction& whole, MatrixTerms& matrix, LocalMatrix local, const std::string& prefix, std::size_t joint,
            std::size_t offset) {
  const std::size_t first_unknown = whole.unknowns.size();
  for (LocalUnknown& unknown : local.unknowns) {
    whole.unknowns.push_back({prefix + unknown.name, std::move(unknown.unit), matrix.kind, joint});
  }
  for (const Term& term : local.terms) {
    matrix.terms.push_back(
        {term.row + offset, term.column + offset, term.unknown + first_unknown, term.coefficient});
  }
  for (const Known& known : local.known) {
    matrix.known.push_back({known.row + offset, known.column + offset, known.value});
  }
}

auto position(const Term& term) { return std::tuple(term.unknown, term.row, term.column); }
auto position(const Known& known) { return std::tuple(known.row, known.column); }
bool is_zero(const Term& term) { return term.coefficient == 0.0; }
bool is_zero(const Known& known) { return known.value == 0.0; }

/// The order that the header promises, without zeros.
template <class Item>
void tidy(std::vector<Item>& items) {
  std::erase_if(items, [](const Item& item) { return is_zero(item); });
  std::sort(items.begin(), items.end(), [](const Item& a, const Item& b) { return position(a) < position(b); });
}

void add_kind(Restriction& whole, const std::vector<JointSpec>& joints, Kind kind) {
  MatrixTerms matrix{.kind = kind, .terms = {}, .known = {}};
  std::size_t offset = 0;
  bool present = false;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const auto spec = joints[j].matrices.find(kind);
    if (spec != joints[j].matrices.end()) {
      const std::string prefix = joints[j].name.empty() ? "" : joints[j].name + ".";
      append(whole, matrix, local_matrix(joints[j], kind, spec->second), prefix, j, offset);
      present = true;
    }
    offset += joints[j].dofs.size();
  }
  if (!present) return;
  tidy(matrix.terms);
  tidy(matrix.known);
  whole.matrices.push_back(std::move(matrix));
}

const MatrixTerms* find(const Restriction& restriction, Kind kind) {
  const auto found = std::find_if(restriction.matrices.begin(), restriction.matrices.end(),
                                  [&](const MatrixTerms& matrix) { return matrix.kind == kind; });
  return found == restriction.matrices.end() ? nullptr : &*found;
}

/// True when every item has its mirror image with the same value.
template <class Item, class Value>
bool mirrored(const std::vector<Item>& items, Value value) {
  return std::all_of(items.begin(), items.end(), [&](const Item& item) {
    Item image = item;
    std::swap(image.row, image.column);
    const auto found = std::lower_bound(items.begin(), items.end(), image, [](const Item& a, const Item& b) {
      return position(a) < position(b);
    });
    return found != items.end() && position(*found) == position(image) && value(*found) == value(item);
  });
}

}  // namespace

bool Restriction::has(Kind kind) const { return find(*this, kind) != nullptr; }

bool Restriction::symmetric() const {
  return std::all_of(matrices.begin(), matrices.end(), [](const MatrixTerms& matrix) {
    return mirrored(matrix.terms, [](const Term& term) { return term.coefficient; }) &&
           mirrored(matrix.known, [](const Known& known) { return known.value; });
  });
}

std::vector<double> Restriction::matrix(Kind kind, const std::vector<double>& y) const {
  assert(y.size() == unknowns.size());
  const std::size_t size = dofs.size();
  std::vector<double> result(size * size, 0.0);
  const MatrixTerms* matrix = find(*this, kind);
  if (matrix == nullptr) return result;
  for (const Known& known : matrix->known) result[known.row * size + known.column] += known.value;
  for (const Term& term : matrix->terms) result[term.row * size + term.column] += term.coefficient * y[term.unknown];
  return result;
}

Restriction build(const std::vector<JointSpec>& joints) {
  check_names(joints);
  check_dofs(joints);
  Restriction restriction;
  for (const JointSpec& joint : joints) {
    restriction.dofs.insert(restriction.dofs.end(), joint.dofs.begin(), joint.dofs.end());
  }
  for (const Kind kind : all_kinds) add_kind(restriction, joints, kind);
  return restriction;
}

}  // namespace jointid::restrictions
