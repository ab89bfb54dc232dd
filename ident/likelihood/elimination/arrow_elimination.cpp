#include "ident/likelihood/elimination/arrow_elimination.hpp"

#include "base/eigen.hpp"
#include "base/kernel.hpp"
#include "dense/blas.hpp"
#include "ident/likelihood/elimination/shared_reduction.hpp"

namespace jointid::ident {

ArrowElimination::ArrowElimination(const LineLayout& layout)
    : layout_(layout), arrow_(layout), of_y_(layout), lowers_(arrow_.lone.size()) {}

Eigen::Index ArrowElimination::count_of(std::size_t k) const { return at(layout_.sub_jn_first[k + 1] - layout_.sub_jn_first[k]); }

void ArrowElimination::linearise(const LineData& data, const LineState& state, const LineFactors& factors, const JointImpedance* joint,
                                 const SystematicTerms* terms) {
  weights_.take(layout_, data, state);
  take_right_sides(layout_, data, state, factors, joint, terms, sides_);
  normal_sides_.take(layout_, weights_, sides_, factors, true);
  squares_.take(layout_, weights_.all, factors);
  g_ = factors.za;
  h_ = factors.h;
  c_ = factors.c;
  const Eigen::Index size = arrow_.core_size() + sides_.values.cols();
  normal_.setZero(size, size);
  add_core_columns();
  add_core_pairs(data);
  take_y();
  put_right_sides();
}

/// Blocks of a column X_k by Y: the conjugates of −(S δY G_k + R δY h_k) of one row of it, by the columns of S and R.
void ArrowElimination::add_by_y(const Complex* s, const Complex* r, std::size_t k, Complex* out) const {
  const Complex* const g = g_.col(at(k)).data();
  const Complex* const h = h_.col(at(k)).data();
  for (const auto [i, j] : layout_.sub_jj) {
    Complex sum = conjugate_product(g[j], s[i]) + conjugate_product(h[j], r[i]);
    if (i != j) sum += conjugate_product(g[i], s[j]) + conjugate_product(h[i], r[j]);
    *out++ -= sum;
  }
}

void ArrowElimination::add_core_columns() {
  for (const std::size_t k : arrow_.core) {
    const Eigen::Index first = arrow_.core_first[k], count = count_of(k);
    const RowSquares::Square s = squares_.s(k), r = squares_.r(k);
    for (Eigen::Index e = 0; e < count; ++e) {
      const Eigen::Index row = at(layout_.sub_jn[layout_.sub_jn_first[k] + static_cast<std::size_t>(e)].row);
      Complex* const column = normal_.col(first + e).data();
      for (Eigen::Index f = e; f < count; ++f) {
        const Eigen::Index other = at(layout_.sub_jn[layout_.sub_jn_first[k] + static_cast<std::size_t>(f)].row);
        column[first + f] += s(other, row) + r(other, row);
      }
      add_by_y(s.col(row).data(), r.col(row).data(), k, column + arrow_.core_x);
    }
  }
}

/// The element (r, k) of D is G_kᵀ δX_r + h_r δX_k and what touches Y.
void ArrowElimination::add_core_pairs(const LineData& data) {
  for (const std::size_t i : arrow_.core_pairs) {
    const auto [r, k] = layout_.drop_nn[i];
    const double squared = std::norm(data.drop_nn.weight[i].real());
    const Complex* const g = g_.col(at(k)).data();
    const Complex* const h = h_.col(at(r)).data();
    const Eigen::Index first_r = arrow_.core_first[r], first_k = arrow_.core_first[k];
    const Element* const of_r = layout_.sub_jn.data() + layout_.sub_jn_first[r];
    const Element* const of_k = layout_.sub_jn.data() + layout_.sub_jn_first[k];
    for (Eigen::Index e = 0; e < count_of(r); ++e) {
      const Complex by = squared * g[of_r[e].row];
      Complex* const column = normal_.col(first_r + e).data() + first_k;
      for (Eigen::Index f = r == k ? e : 0; f < count_of(k); ++f) {
        column[f] += conjugate_product(h[of_k[f].row], by);
        if (r == k) column[f] += squared * conjugate_product(g[of_k[f].row], h[of_r[e].row]);
      }
    }
  }
}

void ArrowElimination::take_y() {
  const std::size_t of_b = layout_.asm_jj.empty() ? 0 : layout_.joint;
  of_y_.reset(layout_.others + of_b);
  for (std::size_t k = 0; k < layout_.others; ++k) of_y_.put(squares_.s(k), g_.col(at(k)));
  for (std::size_t q = 0; q < of_b; ++q) of_y_.put(squares_.b(q), c_.col(at(q)));
  y_normal_.setZero(arrow_.y, arrow_.y);
  of_y_.add_to(y_normal_);
  normal_.block(arrow_.core_x, arrow_.core_x, arrow_.y, arrow_.y) = y_normal_;
}

void ArrowElimination::put_right_sides() {
  const ComplexMatrix& values = normal_sides_.values();
  const Eigen::Index size = arrow_.core_size(), sides = values.cols();
  auto below = normal_.bottomRows(sides);
  for (const std::size_t k : arrow_.core) {
    const Eigen::Index count = count_of(k);
    below.middleCols(arrow_.core_first[k], count) = values.middleRows(at(layout_.sub_jn_first[k]), count).adjoint();
  }
  below.middleCols(arrow_.core_x, arrow_.y) = values.bottomRows(arrow_.y).adjoint();
  below.rightCols(normal_.cols() - size) = normal_sides_.square();
}

/// L_k, and the arms of the column.
bool ArrowElimination::eliminate(const ArrowLayout::Lone& lone, double damping) {
  const std::size_t k = lone.column, first = layout_.sub_jn_first[k];
  const Eigen::Index n = at(layout_.joint), count = count_of(k), touches = at(lone.touches.size()), sides = sides_.values.cols();
  const RowSquares::Square s = squares_.s(k), r = squares_.r(k);
  ComplexMatrix& lower = lowers_[static_cast<std::size_t>(&lone - arrow_.lone.data())];
  lower.resize(count, count);
  small_.resize(2 * n + touches + sides, count);
  for (Eigen::Index e = 0; e < count; ++e) {
    const Eigen::Index row = at(layout_.sub_jn[first + static_cast<std::size_t>(e)].row);
    for (Eigen::Index f = e; f < count; ++f) {
      const Eigen::Index other = at(layout_.sub_jn[first + static_cast<std::size_t>(f)].row);
      lower(f, e) = s(other, row) + r(other, row);
    }
    lower(e, e) += weights_.own_squared[at(first) + e] * (1.0 + damping);
    small_.col(e).head(n) = s.col(row);
    small_.col(e).segment(n, n) = r.col(row);
    for (Eigen::Index t = 0; t < touches; ++t) {
      const auto [core, element, lone_is_second] = lone.touches[static_cast<std::size_t>(t)];
      const double weight = weights_.all[weights_.all.size() - at(layout_.drop_nn.size() - element)];
      small_(2 * n + t, e) = weight * weight * (lone_is_second ? h_(row, at(core)) : g_(row, at(core)));
    }
  }
  small_.bottomRows(sides) = normal_sides_.values().middleRows(at(first), count).adjoint();
  if (!dense::cholesky_in_place(lower)) return false;
  for (Eigen::Index e = 0; e < count; ++e) {
    for (Eigen::Index f = 0; f < e; ++f) small_.col(e) -= std::conj(lower(e, f)) * small_.col(f);
    small_.col(e) /= lower(e, e).real();
    Complex* const arm = arms_.col(lone.first + e).data();
    const Complex* const from = small_.col(e).data();
    std::fill_n(arm, arrow_.core_size(), Complex(0.0));
    for (Eigen::Index t = 0; t < touches; ++t) {
      const auto [core, element, lone_is_second] = lone.touches[static_cast<std::size_t>(t)];
      const Complex* const along = (lone_is_second ? g_ : h_).col(at(k)).data();
      const Element* const rows = layout_.sub_jn.data() + layout_.sub_jn_first[core];
      Complex* const out = arm + arrow_.core_first[core];
      for (Eigen::Index f = 0; f < count_of(core); ++f) out[f] = conjugate_product(along[rows[f].row], from[2 * n + t]);
    }
    add_by_y(from, from + n, k, arm + arrow_.core_x);
    std::copy_n(from + 2 * n + touches, sides, arm + arrow_.core_size());
  }
  return true;
}

bool ArrowElimination::factor(double damping) {
  const Eigen::Index core = arrow_.core_size(), sides = sides_.values.cols();
  arms_.resize(core + sides, arrow_.lone_size);
  for (const ArrowLayout::Lone& lone : arrow_.lone) {
    if (!eliminate(lone, damping)) return false;
  }
  factor_ = normal_;
  for (const std::size_t k : arrow_.core) {
    for (Eigen::Index e = 0; e < count_of(k); ++e)
      factor_.diagonal()[arrow_.core_first[k] + e] += weights_.own_squared[at(layout_.sub_jn_first[k]) + e] * (1.0 + damping);
  }
  factor_.diagonal().segment(arrow_.core_x, arrow_.y) += weights_.own_squared.tail(arrow_.y) * (1.0 + damping);
  if (arrow_.lone_size > 0) dense::subtract_square(arms_, factor_);
  right_ = factor_.bottomLeftCorner(sides, core).adjoint();
  square_ = factor_.bottomRightCorner(sides, sides);
  if (!dense::cholesky_in_place(factor_.topLeftCorner(core, core))) return false;
  dense::solve_lower(factor_.topLeftCorner(core, core), right_);
  dense::subtract_square(right_.adjoint(), square_);
  return true;
}

/// From L_k⁻¹ of the right-hand sides of lone columns to their steps, by those of the core.
void ArrowElimination::solve_lone(const ComplexMatrix& core, ComplexMatrix& lone) const {
  dense::subtract_adjoint_product(arms_.topRows(core.rows()), core, lone);
  for (std::size_t i = 0; i < arrow_.lone.size(); ++i)
    dense::solve_lower_adjoint(lowers_[i], lone.middleRows(arrow_.lone[i].first, lowers_[i].rows()));
}

/// X and Y in the order of the layout.
ComplexMatrix ArrowElimination::in_order(const ComplexMatrix& core, const ComplexMatrix& lone) const {
  ComplexMatrix out(arrow_.core_size() + arrow_.lone_size, core.cols());
  for (const std::size_t k : arrow_.core)
    out.middleRows(at(layout_.sub_jn_first[k]), count_of(k)) = core.middleRows(arrow_.core_first[k], count_of(k));
  for (const ArrowLayout::Lone& each : arrow_.lone)
    out.middleRows(at(layout_.sub_jn_first[each.column]), count_of(each.column)) = lone.middleRows(each.first, count_of(each.column));
  out.bottomRows(arrow_.y) = core.bottomRows(arrow_.y);
  return out;
}

std::optional<ReducedLine> ArrowElimination::reduce(double damping, bool answer) {
  if (!factor(damping)) return std::nullopt;
  if (!answer) return shared_reduction(sides_, square_, nullptr);
  const Eigen::Index core = arrow_.core_size();
  dense::solve_lower_adjoint(factor_.topLeftCorner(core, core), right_);
  ComplexMatrix lone = arms_.bottomRows(right_.cols()).adjoint();
  solve_lone(right_, lone);
  const ComplexMatrix steps = in_order(right_, lone);
  return shared_reduction(sides_, square_, &steps);
}

LineStep ArrowElimination::own_step(const LineStep& gradient) const {
  const Eigen::Index v = gradient.size() / 2, size = arrow_.core_size();
  const Eigen::Map<const Eigen::VectorXcd> given(reinterpret_cast<const Complex*>(gradient.data()), v);
  ComplexMatrix core(size, 1), lone(arrow_.lone_size, 1);
  for (const std::size_t k : arrow_.core)
    core.middleRows(arrow_.core_first[k], count_of(k)) = given.segment(at(layout_.sub_jn_first[k]), count_of(k));
  core.bottomRows(arrow_.y) = given.tail(arrow_.y);
  for (std::size_t i = 0; i < arrow_.lone.size(); ++i) {
    const auto& [column, first, touches] = arrow_.lone[i];
    lone.middleRows(first, count_of(column)) = given.segment(at(layout_.sub_jn_first[column]), count_of(column));
    dense::solve_lower(lowers_[i], lone.middleRows(first, count_of(column)));
  }
  core.noalias() -= arms_.topRows(size) * lone;
  dense::solve_lower(factor_.topLeftCorner(size, size), core);
  dense::solve_lower_adjoint(factor_.topLeftCorner(size, size), core);
  solve_lone(core, lone);
  LineStep out(gradient.size());
  Eigen::Map<Eigen::VectorXcd>(reinterpret_cast<Complex*>(out.data()), v) = in_order(core, lone).col(0);
  return out;
}

}  // namespace jointid::ident
