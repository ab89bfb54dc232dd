#include "ident/equations/system_pattern.hpp"

#include <algorithm>
#include <set>

#include "ident/equations/linear_plan.hpp"
#include "minimise/linear/sparse_qr.hpp"

namespace jointid::ident {
namespace {

/// A positive definite matrix where the columns of each support are coupled.
minimise::SparseSymmetric coupled_columns(const std::vector<std::set<std::size_t>>& supports, std::size_t columns) {
  std::vector<std::set<std::size_t>> below(columns);
  for (const std::set<std::size_t>& support : supports) {
    for (auto column = support.begin(); column != support.end(); ++column) below[*column].insert(column, support.end());
  }
  minimise::SparseSymmetric out;
  out.start.push_back(0);
  for (std::size_t column = 0; column < columns; ++column) {
    below[column].insert(column);
    for (const std::size_t row : below[column]) {
      out.row.push_back(static_cast<std::int64_t>(row));
      out.value.push_back(row == column ? static_cast<double>(columns) : 1.0);
    }
    out.start.push_back(static_cast<std::int64_t>(out.row.size()));
  }
  return out;
}

}  // namespace

double SystemPattern::share_of_dense() const {
  const auto n = static_cast<double>(unknowns);
  return static_cast<double>(factor_entries) / (0.5 * n * (n + 1.0));
}

std::vector<std::string> SystemPattern::picture(std::size_t most) const {
  const std::size_t size = std::min(joints, most);
  std::vector<std::vector<bool>> full(size, std::vector<bool>(size));
  for (const std::vector<std::size_t>& of : joints_of) {
    for (const std::size_t a : of) {
      for (const std::size_t b : of) full[a * size / joints][b * size / joints] = true;
    }
  }
  std::vector<std::string> lines;
  for (const std::vector<bool>& row : full) {
    std::string& line = lines.emplace_back();
    for (const bool each : row) line += each ? "■" : "·";
  }
  return lines;
}

SystemPattern pattern_of(const Plan& plan, const std::vector<RowGroup>& groups) {
  SystemPattern out;
  out.unknowns = plan.columns->size();
  out.supports = groups.size();
  std::vector<std::vector<std::size_t>> columns(plan.restriction.unknowns.size());
  for (std::size_t column = 0; column < out.unknowns; ++column) columns[plan.columns->unknown_of(column)].push_back(column);
  std::vector<std::set<std::size_t>> touched;
  std::set<std::pair<std::size_t, std::size_t>> pairs;
  std::set<std::size_t> all;
  for (const RowGroup& group : groups) {
    std::set<std::size_t> joints;
    std::set<std::size_t>& own_columns = touched.emplace_back();
    for (const std::size_t unknown : group.unknowns) {
      joints.insert(plan.restriction.unknowns[unknown].joint);
      own_columns.insert(columns[unknown].begin(), columns[unknown].end());
    }
    for (const std::size_t a : joints) {
      for (const std::size_t b : joints) pairs.emplace(a, b);
    }
    all.insert(joints.begin(), joints.end());
    out.joints_of.emplace_back(joints.begin(), joints.end());
    const std::size_t width = group.unknowns.size();
    if (2 * width > out.unknowns && !group.files.empty()) out.wide_files.push_back(group.files);
    if (width <= out.widest) continue;
    out.widest = width;
    out.widest_file = group.files;
  }
  out.joints = all.empty() ? 0 : *all.rbegin() + 1;
  out.joint_pairs = pairs.size();
  if (2 * out.widest > out.unknowns) {
    out.factor_entries = out.unknowns * (out.unknowns + 1) / 2;
    return out;
  }
  const auto factor = minimise::ldlt_cholesky();
  if (factor->factorize(coupled_columns(touched, out.unknowns))) out.factor_entries = factor->entries();
  return out;
}

std::optional<SystemPattern> system_pattern(const Plan& plan, std::size_t least) {
  const LinearPlan* const own = linear_plan(plan);
  if (own == nullptr || plan.columns->size() < least) return std::nullopt;
  std::vector<RowGroup> groups;
  for (std::size_t s = 0; s < own->spec.supports.size(); ++s) {
    const bool by_parts = !own->parts.empty();
    groups.push_back({own->spec.supports[s].unknowns,
                      by_parts ? plan.substructures->source(own->parts[s].source).header().file : std::string()});
  }
  return pattern_of(plan, groups);
}

}  // namespace jointid::ident
