#include "ident/equations/supports.hpp"

#include <algorithm>
#include <numeric>
#include <set>

namespace jointid::ident {
namespace {

std::vector<std::size_t> all_indices(std::size_t count) {
  std::vector<std::size_t> indices(count);
  std::iota(indices.begin(), indices.end(), std::size_t{0});
  return indices;
}

Support everything(const restrictions::Restriction& restriction) {
  const std::vector<std::size_t> dofs = all_indices(restriction.dofs.size());
  return {dofs, dofs, all_indices(restriction.unknowns.size())};
}

/// What equations can touch whose B has non-zero rows only at the joint DOFs of one substructure.
Support on_source(const restrictions::Restriction& restriction, const std::vector<std::size_t>& joint_source,
                  std::size_t source) {
  std::set<std::size_t> a_dofs, b_dofs, unknowns;
  for (const restrictions::MatrixTerms& matrix : restriction.matrices) {
    for (const restrictions::Term& term : matrix.terms) {
      if (joint_source[term.column] != source) continue;
      a_dofs.insert(term.row);
      b_dofs.insert(term.column);
      unknowns.insert(term.unknown);
    }
    for (const restrictions::Known& known : matrix.known) {
      if (joint_source[known.column] != source) continue;
      a_dofs.insert(known.row);
      b_dofs.insert(known.column);
    }
  }
  return {{a_dofs.begin(), a_dofs.end()}, {b_dofs.begin(), b_dofs.end()}, {unknowns.begin(), unknowns.end()}};
}

}  // namespace

std::size_t compressed_rows(const AssemblySpec& spec, std::size_t a_rows) {
  std::size_t rows = 0;
  for (std::size_t s = 0; s < spec.supports.size(); ++s) {
    const auto columns = static_cast<std::size_t>(std::count(spec.column_support.begin(), spec.column_support.end(), s));
    rows += 2 * std::min(a_rows, spec.supports[s].a_dofs.size()) * std::min(columns, spec.supports[s].b_dofs.size());
  }
  return rows;
}

double reduction_flops(const AssemblySpec& spec, std::size_t a_rows) {
  double flops = 0.0;
  for (std::size_t s = 0; s < spec.supports.size(); ++s) {
    const auto columns = static_cast<std::size_t>(std::count(spec.column_support.begin(), spec.column_support.end(), s));
    const Support& support = spec.supports[s];
    const auto unknowns = static_cast<double>(support.unknowns.size() + 1);
    flops += 4.0 * static_cast<double>(std::min(a_rows, support.a_dofs.size())) *
             static_cast<double>(std::min(columns, support.b_dofs.size())) * unknowns * unknowns;
  }
  return flops;
}

void choose_supports(const restrictions::Restriction& restriction, const std::vector<std::size_t>& joint_source,
                     const std::vector<std::size_t>& column_source, std::size_t columns, AssemblySpec& spec) {
  spec.supports = {everything(restriction)};
  spec.column_support.assign(columns, 0);
  if (column_source.empty()) return;
  AssemblySpec split;
  std::vector<std::size_t> sources;
  for (const std::size_t source : column_source) {
    const auto found = std::find(sources.begin(), sources.end(), source);
    split.column_support.push_back(static_cast<std::size_t>(found - sources.begin()));
    if (found != sources.end()) continue;
    sources.push_back(source);
    split.supports.push_back(on_source(restriction, joint_source, source));
    // A substructure that no joint touches has no equations; leave such columns to the general case.
    if (split.supports.back().unknowns.empty()) return;
  }
  const std::size_t a_rows = restriction.dofs.size();
  if (reduction_flops(split, a_rows) >= reduction_flops(spec, a_rows)) return;
  spec.supports = std::move(split.supports);
  spec.column_support = std::move(split.column_support);
}

}  // namespace jointid::ident
