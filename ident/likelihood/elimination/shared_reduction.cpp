#include "ident/likelihood/elimination/shared_reduction.hpp"

#include <cmath>

#include "base/eigen.hpp"

namespace jointid::ident {

std::optional<ReducedLine> shared_reduction(const RightSides& sides, const ComplexMatrix& square, const ComplexMatrix* steps) {
  const Eigen::Index last = square.cols() - 1, p = at(sides.unknowns.size());
  const auto element = [&square](Eigen::Index i, Eigen::Index j) { return i >= j ? square(i, j) : std::conj(square(j, i)); };
  ReducedLine out;
  out.cost = square(last, last).real();
  if (!std::isfinite(out.cost)) return std::nullopt;
  out.information.resize(p, p);
  out.gradient.resize(p);
  for (Eigen::Index i = 0; i < p; ++i) {
    const auto [column, factor] = sides.unknowns[static_cast<std::size_t>(i)];
    for (Eigen::Index j = 0; j < p; ++j) {
      const auto [other, other_factor] = sides.unknowns[static_cast<std::size_t>(j)];
      out.information(i, j) = (std::conj(factor) * other_factor * element(column, other)).real();
    }
    out.gradient[i] = (std::conj(factor) * element(column, last)).real();
  }
  if (steps == nullptr) return out;
  const Eigen::Index v = steps->rows();
  out.back = std::make_shared<WayBack>(steps->leftCols(last), sides.unknowns);
  out.own.resize(2 * v);
  Eigen::Map<Eigen::VectorXcd>(reinterpret_cast<Complex*>(out.own.data()), v) = steps->col(last);
  return out;
}

}  // namespace jointid::ident
