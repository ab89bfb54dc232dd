#include "ident/likelihood/elimination/elimination_flops.hpp"

namespace jointid::ident {
namespace {

double number(std::size_t i) { return static_cast<double>(i); }

/// Of a complex matrix product, half of a square, a Cholesky factor, and a solution by one of its sides.
double product_flops(double rows, double columns, double depth) { return 8.0 * rows * columns * depth; }
double factor_flops(double size) { return 4.0 / 3.0 * size * size * size; }
double solve_flops(double size, double columns) { return 4.0 * size * size * columns; }

double x_per_column(const LineLayout& layout) {
  return layout.others > 0 ? number(layout.sub_jn.size()) / number(layout.others) : 0.0;
}

/// Of Σ_k conj(g_k) g_kᵀ ⊗ T_k of so many terms, folded to the elements of Y.
double kronecker_flops(const LineLayout& layout, double terms) {
  double both = 0.0;  // elements of Y, those off the diagonal twice
  for (const Element& e : layout.sub_jj) both += e.row == e.column ? 1.0 : 2.0;
  return product_flops(both, both, terms) / 2.0;
}

double kronecker_terms(const LineLayout& layout) { return number(layout.others + (layout.asm_jj.empty() ? 0 : layout.joint)); }

}  // namespace

double flops_by_rows(const LineLayout& layout, std::size_t right_sides) {
  const double v = number(layout.variables()), p = number(right_sides), common = number(layout.sub_jj.size()) + p;
  const double column = x_per_column(layout);
  const auto rows = [](double count, double width) { return 4.0 * count * width * width; };
  return rows(number(layout.asm_jn.size()), column + common) + rows(number(layout.asm_jj.size()), common) +
         rows(number(layout.drop_nn.size()), 2.0 * column + common) + factor_flops(v) + 2.0 * solve_flops(v, p) + 4.0 * v * p * p;
}

double flops_by_elimination(const LineLayout& layout, std::size_t right_sides) {
  const double joint = number(layout.joint), others = number(layout.others), p = number(right_sides),
               y = number(layout.sub_jj.size());
  const double d = number(layout.drop_nn.size()), run = x_per_column(layout), terms = kronecker_terms(layout);
  const double squares = terms * product_flops(joint, joint, joint) / 2.0 + kronecker_flops(layout, terms);
  const double columns = others * (factor_flops(run) + solve_flops(run, 2.0 * (joint + p + others)) +
                                   product_flops(joint, joint, run) / 2.0 + product_flops(joint, others + 2.0 * p, run));
  const double sides = p * (product_flops(joint, joint, 2.0 * terms) + product_flops(joint, joint, 2.0 * others));
  const double of_y = factor_flops(y) + solve_flops(y, 2.0 * p + d) + product_flops(p, p, y) / 2.0;
  const double of_d =
      16.0 * d * y + product_flops(d, d, y) / 2.0 + factor_flops(d) + product_flops(d, 2.0 * p, y) + solve_flops(d, 2.0 * p);
  return squares + columns + sides + of_y + of_d;
}

double flops_by_arrow(const LineLayout& layout, const ArrowLayout& arrow, std::size_t right_sides) {
  const double joint = number(layout.joint), others = number(layout.others), p = number(right_sides), v = number(layout.variables());
  const double core = static_cast<double>(arrow.core_size()), lone = static_cast<double>(arrow.lone_size);
  const double y = number(layout.sub_jj.size()), terms = kronecker_terms(layout);
  const double elements = v + number(layout.asm_jn.size() + layout.asm_jj.size() + layout.drop_nn.size());
  const double squares = 2.0 * joint * joint * others * (joint + 2.0 * others) + kronecker_flops(layout, terms);
  const double blocks = 32.0 * y * (v - y) + 8.0 * number(layout.drop_nn.size()) * x_per_column(layout) * x_per_column(layout);
  const double sides = 4.0 * elements * p * p + p * (product_flops(joint, joint + others, terms) + product_flops(joint, others, others) +
                                                      product_flops(joint, joint, terms));
  const double arms = 4.0 * lone * (core + p) * (core + p) + product_flops(lone, core, p);
  return squares + blocks + sides + arms + factor_flops(core) + 2.0 * solve_flops(core, p) + 4.0 * core * p * p;
}

bool elimination_pays(const LineLayout& layout, std::size_t right_sides) {
  constexpr double share = 0.7;  // measured: its products are smaller ones
  return layout.is_large() &&
         flops_by_elimination(layout, right_sides) < share * flops_by_arrow(layout, ArrowLayout(layout), right_sides);
}

}  // namespace jointid::ident
