#pragma once

#include "base/eigen.hpp"
#include "coupling/condition.hpp"

namespace jointid::coupling {

/// H Bᵀ at the given rows, [rows, m]: columns h_i − s h_j (h_i alone for ground).
template <class Matrix>
Matrix column_jumps(const Matrix& h, const Conditions& conditions, const std::vector<Index>& rows) {
  Matrix out(at(rows.size()), at(conditions.size()));
  for (Index p = 0; p < out.cols(); ++p) {
    const Condition& c = conditions[static_cast<std::size_t>(p)];
    out.col(p) = h(rows, c.first);
    if (!c.second) continue;
    if (c.sign > 0.0) {
      out.col(p) -= h(rows, *c.second);
    } else {
      out.col(p) += h(rows, *c.second);
    }
  }
  return out;
}

/// B H at the given columns, [m, columns].
template <class Matrix>
Matrix row_jumps(const Matrix& h, const Conditions& conditions, const std::vector<Index>& columns) {
  Matrix out(at(conditions.size()), at(columns.size()));
  for (Index p = 0; p < out.rows(); ++p) {
    const Condition& c = conditions[static_cast<std::size_t>(p)];
    out.row(p) = h(c.first, columns);
    if (!c.second) continue;
    if (c.sign > 0.0) {
      out.row(p) -= h(*c.second, columns);
    } else {
      out.row(p) += h(*c.second, columns);
    }
  }
  return out;
}

/// S = B H Bᵀ, [m, m]: H_bb + H_cc − H_bc − H_cb of docs/formulas.md §8 (5.36).
template <class Matrix>
Matrix jump_receptance(const Matrix& h, const Conditions& conditions) {
  const auto m = at(conditions.size());
  Matrix out(m, m);
  for (Index p = 0; p < out.cols(); ++p) {
    const Condition& c = conditions[static_cast<std::size_t>(p)];
    for (Index q = 0; q < out.rows(); ++q) {
      const Condition& r = conditions[static_cast<std::size_t>(q)];
      auto value = h(r.first, c.first);
      const auto take = [&](Index row, Index column, double sign) {
        if (sign > 0.0) {
          value += h(row, column);
        } else {
          value -= h(row, column);
        }
      };
      if (c.second) take(r.first, *c.second, -c.sign);
      if (r.second) take(*r.second, c.first, -r.sign);
      if (c.second && r.second) take(*r.second, *c.second, c.sign * r.sign);
      out(q, p) = value;
    }
  }
  return out;
}

/// H − H Bᵀ S⁻¹ B H at the wanted rows and columns (5.36a, with ground 5.37); solve(S, Y) gives S⁻¹Y.
template <class Matrix, class Solve>
Matrix one_step(const Matrix& h, const Conditions& conditions, const Wanted& wanted, Solve solve) {
  const Matrix x = column_jumps(h, conditions, wanted.rows);
  const Matrix y = row_jumps(h, conditions, wanted.columns);
  Matrix out = h(wanted.rows, wanted.columns);
  if (!conditions.empty()) out.noalias() -= x * solve(jump_receptance(h, conditions), y);
  return out;
}

}  // namespace jointid::coupling
