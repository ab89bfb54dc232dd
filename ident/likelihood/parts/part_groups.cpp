#include "ident/likelihood/parts/part_groups.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "ident/equations/part_rows.hpp"

namespace jointid::ident {
namespace {

/// Which substructures go together: from the first that is free on, the neighbours of those that are in already.
std::vector<std::vector<std::size_t>> joined_parts(const std::vector<PartOfRows>& parts, std::size_t size) {
  std::vector<std::vector<std::size_t>> groups;
  std::vector<bool> taken(parts.size(), false);
  const auto are_joined = [&](std::size_t a, std::size_t b) {
    return std::ranges::any_of(parts[a].support.a_dofs, [&](std::size_t dof) {
      return std::ranges::binary_search(parts[b].support.b_dofs, dof);
    });
  };
  for (std::size_t first = 0; first < parts.size(); ++first) {
    if (taken[first]) continue;
    std::vector<std::size_t> group = {first};
    taken[first] = true;
    for (std::size_t i = 0; i < group.size(); ++i) {
      for (std::size_t other = first + 1; other < parts.size() && group.size() < size; ++other) {
        if (taken[other] || !are_joined(group[i], other)) continue;
        taken[other] = true;
        group.push_back(other);
      }
    }
    groups.push_back(std::move(group));
  }
  return groups;
}

class GroupBuilder {
 public:
  GroupBuilder(const Plan& plan, const PartGroups& all) : plan_(plan), all_(all) {}

  void add(const PartOfRows& part) {
    const Dofs& joint = plan_.coordinates.joint;
    GroupMember& to = out_.members.emplace_back();
    to.source = part.source;
    to.rows = joined(part.n_rows, part.j_rows);
    to.at_joint.assign(part.n_rows.size(), false);
    to.at_joint.resize(to.rows.size(), true);
    to.first_row = out_.rows;
    out_.rows += to.rows.size();
    for (const frf::Dof& dof : to.rows) to.motions.push_back(place_of(dof));
    for (const std::size_t j : part.support.a_dofs) {
      to.columns.push_back(joint[j]);
      to.forces.push_back(place_of(joint[j]));
      force_rows_.insert(j);
    }
    for (const std::size_t j : part.support.b_dofs) place_of(joint[j]);
    for (std::size_t l = 0; l < all_.references.size(); ++l) {
      if (plan_.substructures->source_of(all_.references[l]) != part.source) continue;
      std::size_t column = frf::find_coordinate(to.columns, all_.references[l]);
      if (column == frf::npos) {
        column = to.columns.size();
        to.columns.push_back(all_.references[l]);
      }
      to.references.emplace_back(l, column);
    }
    unknowns_.insert(part.support.unknowns.begin(), part.support.unknowns.end());
  }

  PartGroup built() {
    out_.unknowns.assign(unknowns_.begin(), unknowns_.end());
    const Dofs& joint = plan_.coordinates.joint;
    for (const restrictions::MatrixTerms& matrix : plan_.restriction.matrices) {
      restrictions::MatrixTerms own;
      own.kind = matrix.kind;
      for (restrictions::Term term : matrix.terms) {
        if (!force_rows_.contains(term.row)) continue;
        term.row = place_of(joint[term.row]);
        term.column = place_of(joint[term.column]);
        term.unknown = static_cast<std::size_t>(std::ranges::lower_bound(out_.unknowns, term.unknown) - out_.unknowns.begin());
        own.terms.push_back(term);
      }
      for (const restrictions::Known& known : matrix.known) {
        if (force_rows_.contains(known.row)) own.known.push_back({place_of(joint[known.row]), place_of(joint[known.column]), known.value});
      }
      out_.matrices.push_back(std::move(own));
    }
    return std::move(out_);
  }

 private:
  std::size_t place_of(const frf::Dof& dof) {
    const auto [found, is_new] = places_.try_emplace(frf::coordinate_key(dof), out_.motions.size());
    if (is_new) out_.motions.push_back(dof);
    return found->second;
  }

  const Plan& plan_;
  const PartGroups& all_;
  PartGroup out_;
  std::map<std::int64_t, std::size_t> places_;
  std::set<std::size_t> unknowns_, force_rows_;
};

Dofs all_motions(const std::vector<PartGroup>& groups) {
  Dofs out;
  std::set<std::int64_t> known;
  for (const PartGroup& group : groups) {
    for (const frf::Dof& dof : group.motions) {
      if (known.insert(frf::coordinate_key(dof)).second) out.push_back(dof);
    }
  }
  return out;
}

}  // namespace

std::size_t PartGroup::frfs() const {
  std::size_t count = 0;
  for (const GroupMember& member : members) count += member.rows.size() * member.columns.size();
  return count;
}

PartGroups part_groups(const Plan& plan, const std::vector<Equation>& equations, std::size_t size) {
  const EquationSet use(equations);
  PartGroups out;
  out.references = part_columns(plan.coordinates, use, *plan.assembly);
  for (const frf::Dof& dof : out.references) out.at_joint.push_back(frf::has(plan.coordinates.joint, dof));
  const bool wanted[2][2] = {{use.nn, use.nj}, {use.jn, use.jj}};
  std::copy_n(&wanted[0][0], 4, &out.wanted[0][0]);
  const std::vector<PartOfRows> parts = parts_of_rows(plan.coordinates, use, plan.restriction, *plan.substructures);
  for (const std::vector<std::size_t>& members : joined_parts(parts, size)) {
    GroupBuilder builder(plan, out);
    for (const std::size_t part : members) builder.add(parts[part]);
    out.groups.push_back(builder.built());
  }
  out.motions = all_motions(out.groups);
  return out;
}

double linearisation_flops(const PartGroups& all) {
  double flops = 0.0;
  const auto references = static_cast<double>(all.references.size());
  for (const PartGroup& group : all.groups) {
    const auto n = static_cast<double>(group.rows), q = static_cast<double>(group.motions.size()),
               p = static_cast<double>(group.unknowns.size()), k = static_cast<double>(group.frfs());
    flops += 8.0 * (references * (n * n * (n + q + p) + 0.5 * k * k + k * p + n * p * p) + k * k * k / 3.0 + k * k * p);
  }
  return flops;
}

}  // namespace jointid::ident
