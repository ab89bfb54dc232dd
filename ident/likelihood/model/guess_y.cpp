#include "ident/likelihood/model/guess_y.hpp"

#include "base/eigen.hpp"
#include "dense/minimum_norm.hpp"

namespace jointid::ident {
namespace {

bool is_measured(const Channel& channel, std::size_t i) { return channel.weight[i] != Complex(0.0); }

/// Y Z A = X − A in the unmeasured elements of Y, one row per measured (p, k).
struct Equations {
  std::vector<Eigen::VectorXcd> rows;
  std::vector<Complex> right;
};

/// Which elements of X (j,n) were not measured although they are not zero by construction.
Eigen::MatrixX<bool> unmeasured_x(const LineLayout& layout, const LineData& data) {
  Eigen::MatrixX<bool> out = Eigen::MatrixX<bool>::Constant(at(layout.joint), at(layout.others), false);
  for (std::size_t i = 0; i < layout.sub_jn.size(); ++i)
    out(at(layout.sub_jn[i].row), at(layout.sub_jn[i].column)) = !is_measured(data.sub_jn, i);
  return out;
}

/// The measured A, and in `complete` which of its columns are measured as a whole.
ComplexMatrix measured_a(const LineLayout& layout, const LineData& data, std::vector<bool>& complete) {
  ComplexMatrix a = ComplexMatrix::Zero(at(layout.joint), at(layout.others));
  std::vector<std::size_t> count(layout.others, 0);
  for (std::size_t i = 0; i < layout.asm_jn.size(); ++i) {
    if (!is_measured(data.asm_jn, i)) continue;
    a(at(layout.asm_jn[i].row), at(layout.asm_jn[i].column)) = data.asm_jn.value[i];
    ++count[layout.asm_jn[i].column];
  }
  for (const std::size_t measured : count) complete.push_back(measured == layout.joint);
  return a;
}

Equations equations(const LineLayout& layout, const LineData& data, const ComplexMatrix& z, const LineState& state,
                    const std::vector<std::size_t>& wanted) {
  std::vector<bool> complete;
  const ComplexMatrix a = measured_a(layout, data, complete), za = z * a, rest = state.sub_jn - a - state.sub_jj * za;
  const auto no_x = unmeasured_x(layout, data);
  Equations out;
  for (Eigen::Index k = 0; k < a.cols(); ++k) {
    for (Eigen::Index p = 0; p < a.rows(); ++p) {
      const double size = std::abs(state.sub_jn(p, k)) + std::abs(a(p, k));
      if (!complete[static_cast<std::size_t>(k)] || no_x(p, k) || size == 0.0) continue;
      Eigen::VectorXcd row = Eigen::VectorXcd::Zero(at(wanted.size()));
      for (std::size_t i = 0; i < wanted.size(); ++i) {
        const auto [first, second] = layout.sub_jj[wanted[i]];
        if (at(first) == p) row[at(i)] += za(at(second), k) / size;
        if (at(second) == p && first != second) row[at(i)] += za(at(first), k) / size;
      }
      out.rows.push_back(std::move(row));
      out.right.push_back(rest(p, k) / size);
    }
  }
  return out;
}

/// The least-squares solution of smallest norm in columns of unit length.
Eigen::VectorXcd solve(const Equations& equations, Eigen::Index unknowns) {
  ComplexMatrix matrix(at(equations.rows.size()), unknowns);
  for (std::size_t i = 0; i < equations.rows.size(); ++i) matrix.row(at(i)) = equations.rows[i].transpose();
  const Eigen::Map<const Eigen::VectorXcd> right(equations.right.data(), at(equations.right.size()));
  const Eigen::VectorXd scale = matrix.colwise().norm().transpose().cwiseMax(1e-300).cwiseInverse();
  return scale.asDiagonal() * dense::ComplexMinimumNorm(matrix * scale.asDiagonal()).solve(right);
}

}  // namespace

void guess_y(const LineLayout& layout, const LineData& data, const ComplexMatrix& z, LineState& state) {
  std::vector<std::size_t> wanted;
  for (std::size_t i = 0; i < layout.sub_jj.size(); ++i) {
    if (is_measured(data.sub_jj, i)) continue;
    wanted.push_back(i);
    state.sub_jj(at(layout.sub_jj[i].row), at(layout.sub_jj[i].column)) =
        state.sub_jj(at(layout.sub_jj[i].column), at(layout.sub_jj[i].row)) = 0.0;
  }
  if (wanted.empty()) return;
  const Equations system = equations(layout, data, z, state, wanted);
  if (system.rows.empty()) return;
  const Eigen::VectorXcd values = solve(system, at(wanted.size()));
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const auto [p, q] = layout.sub_jj[wanted[i]];
    state.sub_jj(at(p), at(q)) = state.sub_jj(at(q), at(p)) = values[at(i)];
  }
}

}  // namespace jointid::ident
