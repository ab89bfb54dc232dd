#include "ident/likelihood/elimination/right_sides.hpp"

#include <algorithm>

#include "base/eigen.hpp"
#include "base/kernel.hpp"

namespace jointid::ident {
namespace {

/// The places of all elements, one after the other.
struct ElementPlaces {
  const LineLayout& layout;

  Eigen::Index a() const { return at(layout.variables()); }
  Eigen::Index b() const { return a() + at(layout.asm_jn.size()); }
  Eigen::Index d() const { return b() + at(layout.asm_jj.size()); }
  Eigen::Index end() const { return d() + at(layout.drop_nn.size()); }
};

void take_residuals(const LineLayout& layout, const LineData& data, const LineState& state, const LineFactors& f, Complex* out) {
  const auto put = [&out](const std::vector<Element>& elements, const Channel& channel, const auto& predicted) {
    for (std::size_t i = 0; i < elements.size(); ++i) {
      const bool measured = channel.weight[i] != Complex(0.0);
      *out++ = measured ? channel.value[i] - predicted(at(elements[i].row), at(elements[i].column)) : Complex(0.0);
    }
  };
  put(layout.sub_jn, data.sub_jn, state.sub_jn);
  put(layout.sub_jj, data.sub_jj, state.sub_jj);
  put(layout.asm_jn, data.asm_jn, ComplexMatrix(state.asm_jn + f.p * f.r));
  if (!layout.asm_jj.empty()) put(layout.asm_jj, data.asm_jj, ComplexMatrix(state.asm_jj + f.p * f.rest_b));
  put(layout.drop_nn, data.drop_nn, ComplexMatrix(state.sub_jn.transpose() * f.za + f.h.transpose() * f.r));
}

/// left(row)ᵀ S right(column) of elements, S the matrix of a shape: S right once for all columns, its rows that are not zero.
class ShapeProducts {
 public:
  ShapeProducts(std::span<const ImpedanceTerm> terms, const ComplexMatrix& right) {
    for (const ImpedanceTerm& term : terms) {
      if (std::ranges::find(rows_, term.row) == rows_.end()) rows_.push_back(term.row);
    }
    moved_.setZero(at(rows_.size()), right.cols());
    for (const ImpedanceTerm& term : terms) {
      const auto place = std::ranges::find(rows_, term.row) - rows_.begin();
      for (Eigen::Index k = 0; k < right.cols(); ++k) moved_(place, k) += term.coefficient * right(at(term.column), k);
    }
  }

  void add_to(const std::vector<Element>& elements, const RowMatrixXc& left, Complex* out) const {
    for (const Element& e : elements) {
      const Complex* const l = left.data() + at(e.row) * left.cols();
      const Complex* const moved = moved_.col(at(e.column)).data();
      Complex sum = 0.0;
      for (std::size_t i = 0; i < rows_.size(); ++i) sum += product(l[rows_[i]], moved[i]);
      *out++ = sum;
    }
  }

 private:
  std::vector<std::size_t> rows_;
  ComplexMatrix moved_;
};

}  // namespace

void take_right_sides(const LineLayout& layout, const LineData& data, const LineState& state, const LineFactors& factors,
                      const JointImpedance* joint, const SystematicTerms* terms, RightSides& out) {
  const ElementPlaces places{layout};
  const std::size_t shapes = joint ? joint->shapes().size() : 0, parts = joint ? joint->parts().size() : 0;
  const std::size_t errors = terms ? terms->unknowns : 0;
  out.unknowns.resize(parts + errors);
  out.values.setZero(places.end(), at(shapes + errors + 1));
  out.first_error = at(shapes);
  out.errors = at(errors);
  const Eigen::Index last = out.values.cols() - 1;
  take_residuals(layout, data, state, factors, out.values.col(last).data());
  const RowMatrixXc of_rows = -factors.py, of_d = factors.yh.transpose();
  for (std::size_t s = 0; s < shapes; ++s) {
    const ImpedanceShape& shape = joint->shapes()[s];
    const auto matrix = joint->terms().subspan(shape.first_term, shape.last_term - shape.first_term);
    Complex* const column = out.values.col(at(s)).data();
    const ShapeProducts by_a(matrix, state.asm_jn);
    by_a.add_to(layout.asm_jn, of_rows, column + places.a());
    if (!layout.asm_jj.empty()) ShapeProducts(matrix, state.asm_jj).add_to(layout.asm_jj, of_rows, column + places.b());
    by_a.add_to(layout.drop_nn, of_d, column + places.d());
    for (std::size_t i = shape.first_part; i < shape.last_part; ++i) {
      out.unknowns[joint->parts()[i].unknown] = {at(s), joint->parts()[i].factor};
    }
  }
  for (std::size_t u = 0; u < errors; ++u) out.unknowns[parts + u] = {at(shapes + u), 1.0};
  for (std::size_t e = 0; errors > 0 && e + 1 < terms->first.size(); ++e) {
    for (std::size_t t = terms->first[e]; t < terms->first[e + 1]; ++t) {
      out.values(at(e), at(shapes + terms->terms[t].unknown)) -= terms->terms[t].derivative(out.values(at(e), last));
    }
  }
}

}  // namespace jointid::ident
