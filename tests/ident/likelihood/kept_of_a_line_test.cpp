// What is kept of a line: FRFs without those that were not measured, and the way back to its FRFs with shared columns.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <random>

#include "base/eigen.hpp"
#include "base/statistics.hpp"
#include "ident/likelihood/data/measured_frfs.hpp"
#include "ident/likelihood/line/way_back.hpp"

namespace jointid::ident {
namespace {

using Random = std::mt19937_64;

Complex any(Random& random) {
  std::normal_distribution<double> normal;
  return {normal(random), normal(random)};
}

/// A third not measured, a third zero.
MeasuredFrfs any_frfs(std::size_t size, const std::vector<int>& kinds, Random& random) {
  MeasuredFrfs out(size);
  for (std::size_t r = 0; r < size; ++r) {
    for (std::size_t c = 0; c <= r; ++c) {
      const int kind = kinds[triangle_place(r, c)];
      if (kind == 0) out.at(r, c) = {{nan, nan}, {nan, nan}};
      if (kind == 1) out.at(r, c) = {0.0, 0.0};
      if (kind == 2) out.at(r, c) = {any(random), {1.0, 2.0}, r != c};
    }
  }
  return out;
}

RC_GTEST_PROP(MeasuredFrfs, AreTheSameOncePacked, (unsigned seed)) {
  Random random(seed);
  const std::size_t size = std::uniform_int_distribution<std::size_t>(1, 7)(random);
  std::vector<int> kinds(triangle_size(size));
  for (int& kind : kinds) kind = std::uniform_int_distribution<int>(0, 2)(random);
  const MeasuredFrfs first = any_frfs(size, kinds, random), second = any_frfs(size, kinds, random);
  MeasuredFrfs packed = first, next = second;
  packed.pack(size, nullptr);
  next.pack(size, &packed);
  RC_ASSERT(packed.bytes() <= (2 + kinds.size()) * sizeof(Measured));
  for (const auto& [all, kept] : {std::pair(&first, &std::as_const(packed)), std::pair(&second, &std::as_const(next))}) {
    for (std::size_t r = 0; r < size; ++r) {
      for (std::size_t c = 0; c < size; ++c) {
        const Measured &one = all->at(r, c), &other = kept->at(r, c);
        RC_ASSERT(one.known() == other.known() && one.averaged == other.averaged);
        RC_ASSERT(!one.known() || (one.value == other.value && one.variance == other.variance));
      }
    }
  }
}

/// Against the matrix that it stands for, element by element.
RC_GTEST_PROP(WayBack, IsItsMatrix, (unsigned seed)) {
  Random random(seed);
  const auto up_to = [&](Eigen::Index most) { return std::uniform_int_distribution<Eigen::Index>(1, most)(random); };
  const Eigen::Index v = up_to(6), columns = up_to(4), p = up_to(5);
  const Eigen::MatrixXcd shared = Eigen::MatrixXcd::NullaryExpr(v, columns, [&] { return any(random); });
  std::vector<SharedColumn> unknowns;
  Eigen::MatrixXd expected(2 * v, p);
  for (Eigen::Index i = 0; i < p; ++i) {
    unknowns.push_back({up_to(columns) - 1, any(random)});
    for (Eigen::Index k = 0; k < v; ++k) {
      const Complex value = unknowns.back().factor * shared(k, unknowns.back().column);
      expected(2 * k, i) = value.real();
      expected(2 * k + 1, i) = value.imag();
    }
  }
  const WayBack back(shared, unknowns), real(expected);
  const Eigen::VectorXd step = Eigen::VectorXd::NullaryExpr(p, [&] { return any(random).real(); });
  const LineStep own = LineStep::NullaryExpr(2 * v, [&] { return any(random).real(); });
  RC_ASSERT(back.matrix().isApprox(expected, 1e-13));
  for (const WayBack* each : {&back, &real}) {
    RC_ASSERT((each->times(step) - expected * step).norm() <= 1e-12 * (1.0 + expected.norm() * step.norm()));
    RC_ASSERT((each->transpose_times(own) - expected.transpose() * own).norm() <= 1e-12 * (1.0 + expected.norm() * own.norm()));
  }
}

}  // namespace
}  // namespace jointid::ident
