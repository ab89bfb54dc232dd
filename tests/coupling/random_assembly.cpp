#include "random_assembly.hpp"

#include <algorithm>
#include <numeric>

#include "coupling/groups.hpp"
#include "dense/lu.hpp"
#include "dense/svd.hpp"

namespace jointid::coupling {
namespace {

double number() { return *rc::gen::inRange(-1000, 1001) / 1000.0; }

/// −ω²M + K(1+iη) of a structure with unit-size numbers, well inside its range of frequencies.
ComplexMatrix dynamic_stiffness(Index n, bool symmetric) {
  ComplexMatrix z(n, n);
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < n; ++j) z(i, j) = Complex(number(), 0.1 * number());
  }
  if (symmetric) z = (0.5 * (z + z.transpose())).eval();
  // Damping keeps it away from singular.
  z.diagonal().array() += Complex(0.0, 1.5);
  return z;
}

/// T of the conditions, which are independent, from the null space of B itself.
Eigen::MatrixXd null_space(Index n, const Conditions& conditions) {
  Eigen::MatrixXd b = Eigen::MatrixXd::Zero(static_cast<Index>(conditions.size()), n);
  for (std::size_t p = 0; p < conditions.size(); ++p) {
    b(static_cast<Index>(p), conditions[p].first) = 1.0;
    if (conditions[p].second) b(static_cast<Index>(p), *conditions[p].second) = -conditions[p].sign;
  }
  return dense::svd(b, dense::Vectors::none, dense::Vectors::full).v.rightCols(n - b.rows());
}

}  // namespace

RandomAssembly random_assembly(const Shape& shape) {
  RandomAssembly out;
  const auto structures = *rc::gen::inRange<std::size_t>(2, 7);
  std::vector<ComplexMatrix> z;
  Index n = 0;
  for (std::size_t s = 0; s < structures; ++s) {
    const auto size = *rc::gen::inRange<Index>(2, 6);
    z.push_back(dynamic_stiffness(size, shape.symmetric));
    out.body.insert(out.body.end(), static_cast<std::size_t>(size), s);
    n += size;
  }
  ComplexMatrix all = ComplexMatrix::Zero(n, n);
  Index at = 0;
  for (const ComplexMatrix& part : z) {
    all.block(at, at, part.rows(), part.cols()) = part;
    at += part.rows();
  }
  Groups groups(static_cast<std::size_t>(n));
  std::vector<bool> used(static_cast<std::size_t>(n), false);
  const auto attempts = *rc::gen::inRange<Index>(1, n);
  for (Index k = 0; k < attempts; ++k) {
    Condition c{*rc::gen::inRange<Index>(0, n), *rc::gen::inRange<Index>(0, n), *rc::gen::element(-1.0, 1.0)};
    const bool ground = !shape.across_only && *rc::gen::inRange(0, 6) == 0;
    if (ground) c.second.reset();
    const auto first = static_cast<std::size_t>(c.first), second = static_cast<std::size_t>(c.second.value_or(c.first));
    if (shape.across_only && out.body[first] == out.body[second]) continue;
    if (shape.pairs_only && (used[first] || used[second])) continue;
    if (c.second && *c.second == c.first) continue;
    if (groups.join(c) != Groups::Outcome::joined) continue;
    used[first] = used[second] = true;
    out.conditions.push_back(c);
  }
  if (out.conditions.empty()) out.conditions.push_back({0, z.front().rows(), 1.0});
  RC_PRE(static_cast<Index>(out.conditions.size()) < n);
  const ComplexMatrix t = null_space(n, out.conditions).cast<Complex>();
  out.h = ComplexMatrix::Zero(n, n);
  at = 0;
  for (const ComplexMatrix& part : z) {
    out.h.block(at, at, part.rows(), part.cols()) = dense::inverse(part);
    at += part.rows();
  }
  out.assembled = t * dense::solve(t.transpose() * all * t, t.transpose());
  return out;
}

}  // namespace jointid::coupling
