#include <algorithm>
#include <numeric>

#include "base/eigen.hpp"
#include "coupling/methods.hpp"
#include "dense/lu.hpp"

namespace jointid::coupling {
namespace {

using Bodies = std::vector<std::size_t>;

std::vector<Index> members(const Bodies& body, std::size_t wanted) {
  std::vector<Index> out;
  for (std::size_t i = 0; i < body.size(); ++i) {
    if (body[i] == wanted) out.push_back(at(i));
  }
  return out;
}

void replace(Bodies& body, std::size_t from, std::size_t to) { std::ranges::replace(body, from, to); }

/// The conditions between two structures, each as (coordinate of A, coordinate of B, sign).
struct Interface {
  std::vector<Index> a, b;
  std::vector<double> sign;
};

Interface interface_of(const Conditions& conditions, const Bodies& body, std::size_t a, std::size_t b) {
  Interface out;
  for (const Condition& condition : conditions) {
    const std::size_t one = body[static_cast<std::size_t>(condition.first)];
    const std::size_t two = body[static_cast<std::size_t>(*condition.second)];
    if (!(one == a && two == b) && !(one == b && two == a)) continue;
    out.a.push_back(one == a ? condition.first : *condition.second);
    out.b.push_back(one == a ? *condition.second : condition.first);
    out.sign.push_back(condition.sign);
  }
  return out;
}

/// Couples structures A and B of `h` in place by their own FRFs (docs/formulas.md §8; 5.20, appendix C).
void couple_two(ComplexMatrix& h, const Interface& at, const std::vector<Index>& a_rows, const std::vector<Index>& a_columns,
                const std::vector<Index>& b_rows, const std::vector<Index>& b_columns) {
  const auto m = jointid::at(at.a.size());
  const Eigen::VectorXcd sign = Eigen::Map<const Eigen::VectorXd>(at.sign.data(), m).cast<Complex>();
  const ComplexMatrix a_xm = h(a_rows, at.a), a_mx = h(at.a, a_columns);
  const ComplexMatrix b_xm = h(b_rows, at.b) * sign.asDiagonal(), b_mx = sign.asDiagonal() * ComplexMatrix(h(at.b, b_columns));
  const ComplexMatrix sum = ComplexMatrix(h(at.a, at.a)) + sign.asDiagonal() * ComplexMatrix(h(at.b, at.b)) * sign.asDiagonal();
  const dense::ComplexLu lu(sum);
  const ComplexMatrix of_a = lu.solve(a_mx), of_b = lu.solve(b_mx);
  h(a_rows, a_columns) -= a_xm * of_a;
  h(b_rows, b_columns) -= b_xm * of_b;
  h(a_rows, b_columns) = a_xm * of_b;
  h(b_rows, a_columns) = b_xm * of_a;
}

}  // namespace

std::optional<std::size_t> rc_lacks(const Conditions& conditions, const std::vector<std::size_t>& body) {
  for (std::size_t p = 0; p < conditions.size(); ++p) {
    const Condition& condition = conditions[p];
    if (!condition.second) return p;
    if (body[static_cast<std::size_t>(condition.first)] == body[static_cast<std::size_t>(*condition.second)]) return p;
  }
  return std::nullopt;
}

ComplexMatrix rc(const MatrixRef& h, const Conditions& conditions, const Wanted& wanted, const std::vector<std::size_t>& row_body,
                 const std::vector<std::size_t>& column_body) {
  ComplexMatrix out = h;
  Bodies rows = row_body, columns = column_body;
  for (const Condition& condition : conditions) {
    const std::size_t a = rows[static_cast<std::size_t>(condition.first)], b = rows[static_cast<std::size_t>(*condition.second)];
    if (a == b) continue;  // coupled with an earlier condition between the two
    couple_two(out, interface_of(conditions, rows, a, b), members(rows, a), members(columns, a), members(rows, b),
               members(columns, b));
    replace(rows, b, a);
    replace(columns, b, a);
  }
  return out(wanted.rows, wanted.columns);
}

}  // namespace jointid::coupling
