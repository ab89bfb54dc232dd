#include "ident/likelihood/data/estimated_frfs.hpp"

#include "base/eigen.hpp"
#include "base/statistics.hpp"

namespace jointid::ident {
namespace {

/// Values of the measured ones of some elements of a block, whose first row and column are those of `origin`.
void put(const std::vector<Element>& elements, Element origin, const ComplexMatrix& values, const MeasuredFrfs& measured,
         Symmetric<Complex>& out) {
  for (const auto [r, c] : elements) {
    const std::size_t row = origin.row + r, column = origin.column + c;
    if (measured.at(row, column).known()) out.at(row, column) = values(at(r), at(c));
  }
}

double share(double residual, double own, double other) { return own > 0.0 ? residual * own / (own + other) : 0.0; }

Complex share(const Complex& residual, const Complex& own, const Complex& other) {
  return {share(residual.real(), own.real(), other.real()), share(residual.imag(), own.imag(), other.imag())};
}

}  // namespace

BothSystems<Complex> estimated_frfs(const LineLayout& layout, const BothMeasured& measured, const Channel& difference,
                                    const LineState& state, const ComplexMatrix& z) {
  const std::size_t n = layout.others, size = n + layout.joint;
  BothSystems<Complex> out{Symmetric<Complex>(size, nan), Symmetric<Complex>(size, nan)};
  put(layout.sub_jn, {n, 0}, state.sub_jn, measured.substructures, out.substructures);
  put(layout.sub_jj, {n, n}, state.sub_jj, measured.substructures, out.substructures);
  put(layout.asm_jn, {n, 0}, state.asm_jn, measured.assembly, out.assembly);
  put(layout.asm_jj, {n, n}, state.asm_jj, measured.assembly, out.assembly);
  const ComplexMatrix za = z * state.asm_jn;
  for (std::size_t i = 0; i < layout.drop_nn.size(); ++i) {
    const auto [r, k] = layout.drop_nn[i];
    const Measured &sub = measured.substructures.at(r, k), &whole = measured.assembly.at(r, k);
    if (!sub.known() || !whole.known()) continue;
    const Complex residual = difference.value[i] - predicted_difference(state, za, layout.drop_nn[i]);
    out.substructures.at(r, k) = sub.value - share(residual, sub.variance, whole.variance);
    out.assembly.at(r, k) = whole.value + share(residual, whole.variance, sub.variance);
  }
  return out;
}

}  // namespace jointid::ident
