#include "ident/likelihood/elimination/line_elimination.hpp"

#include <cmath>

#include "base/eigen.hpp"
#include "dense/blas.hpp"

namespace jointid::ident {

LineElimination::LineElimination(const LineLayout& layout)
    : layout_(layout),
      columns_(layout),
      squares_(layout),
      differences_(layout),
      b_squares_(layout.asm_jj.empty() ? 0 : layout.joint) {}

void LineElimination::take_weights(const LineData& data, const LineState& state) {
  const std::size_t v = layout_.variables();
  weights_.resize(at(v + layout_.asm_jn.size() + layout_.asm_jj.size() + layout_.drop_nn.size()));
  Eigen::Index i = 0;
  for (const Channel* channel : {&data.sub_jn, &data.sub_jj, &data.asm_jn, &data.asm_jj, &data.drop_nn}) {
    for (const Complex weight : channel->weight) weights_[i++] = weight.real();
  }
  guesses_ = weights_.head(at(v));
  const double x_guess = guessed_weight(state.sub_jn), y_guess = guessed_weight(state.sub_jj);
  for (std::size_t k = 0; k < v; ++k) {
    if (guesses_[at(k)] == 0.0) guesses_[at(k)] = k < layout_.sub_jn.size() ? x_guess : y_guess;
  }
  guesses_ = guesses_.cwiseAbs2();
}

/// Of a symmetric change of Y by its elements.
void LineElimination::fold(const Complex* matrix, Complex* out) const {
  const std::size_t n = layout_.joint;
  for (const auto [i, j] : layout_.sub_jj) *out++ += i == j ? matrix[i + i * n] : matrix[i + j * n] + matrix[j + i * n];
}

bool LineElimination::linearise(const LineData& data, const LineState& state, const LineFactors& factors,
                                const JointImpedance* joint, const SystematicTerms* terms) {
  take_weights(data, state);
  take_right_sides(layout_, data, state, factors, joint, terms, sides_);
  p_ = factors.p;
  g_ = factors.za;
  columns_.take(data, p_);
  for (std::size_t q = 0; q < b_squares_.size(); ++q) {
    weighed_rows_.clear();
    for (std::size_t i = 0; i < layout_.asm_jj.size(); ++i) {
      const double weight = data.asm_jj.weight[i].real();
      if (layout_.asm_jj[i].column == q && weight > 0.0) weighed_rows_.push_back({layout_.asm_jj[i].row, weight});
    }
    take_square(p_, weighed_rows_, room_, b_squares_[q]);
  }
  if (!layout_.asm_jj.empty()) c_ = factors.c;
  differences_.take(data, factors);
  off_ = differences_.pick(sides_.values.bottomRows(at(layout_.drop_nn.size())));
  take_normal_right_sides(factors);
  return factor(0.0);
}

/// By A and B, column by column of these: Pᴴ W² of their right-hand sides is that of X, and times −Gᴴ and (I − Z B)ᴴ that of Y.
void LineElimination::take_normal_right_sides(const LineFactors& factors) {
  const auto joint = at(layout_.joint), others = at(layout_.others), sides = sides_.values.cols();
  const Eigen::Index first_b = others, width = others + (layout_.asm_jj.empty() ? 0 : joint);
  const Eigen::Index x = at(layout_.sub_jn.size()), v = at(layout_.variables()), a = at(layout_.asm_jn.size()),
                     b = at(layout_.asm_jj.size());
  const Eigen::VectorXd squared = weights_.cwiseAbs2();
  const Eigen::Index without_d = sides_.values.rows() - at(layout_.drop_nn.size());
  room_ = (weights_.head(without_d).asDiagonal() * sides_.values.topRows(without_d)).adjoint();
  square_.setZero(sides, sides);
  dense::add_square(room_, square_);
  right_ = squared.head(v).asDiagonal() * sides_.values.topRows(v);
  ComplexMatrix given = ComplexMatrix::Zero(width * sides, joint);  // adjoint
  for (Eigen::Index s = 0; s < sides; ++s) {
    for (Eigen::Index i = 0; i < a; ++i) {
      const auto [p, k] = layout_.asm_jn[static_cast<std::size_t>(i)];
      given(s * width + at(k), at(p)) = squared[v + i] * std::conj(sides_.values(v + i, s));
    }
    for (Eigen::Index i = 0; i < b; ++i) {
      const auto [p, q] = layout_.asm_jj[static_cast<std::size_t>(i)];
      given(s * width + first_b + at(q), at(p)) = squared[v + a + i] * std::conj(sides_.values(v + a + i, s));
    }
  }
  ComplexMatrix told = ComplexMatrix::Zero(joint, width * sides);
  dense::add_product(p_.adjoint().eval(), given, told);
  ComplexMatrix by(joint, width), of_y(joint, joint);
  by.leftCols(others) = -factors.za;
  if (!layout_.asm_jj.empty()) by.rightCols(joint) = factors.c;
  for (Eigen::Index s = 0; s < sides; ++s) {
    of_y.setZero();
    dense::add_product(told.middleCols(s * width, width), by, of_y);
    fold(of_y.data(), right_.col(s).data() + x);
    for (Eigen::Index i = 0; i < x; ++i) {
      const auto [p, k] = layout_.sub_jn[static_cast<std::size_t>(i)];
      right_(i, s) += told(at(p), s * width + at(k));
    }
  }
}

bool LineElimination::factor(double damping) {
  const Eigen::Index x = at(layout_.sub_jn.size()), y = at(layout_.sub_jj.size());
  damping_ = -1.0;  // none, should it fail
  const Eigen::VectorXd damped = guesses_ * (1.0 + damping);
  if (!columns_.factor(damped.head(x))) return false;
  squares_.reset(layout_.others + b_squares_.size());
  for (std::size_t k = 0; k < layout_.others; ++k) squares_.put(columns_.columns()[k].left, g_.col(at(k)));
  for (std::size_t q = 0; q < b_squares_.size(); ++q) squares_.put(b_squares_[q], c_.col(at(q)));
  y_lower_.setZero(y, y);
  squares_.add_to(y_lower_);
  y_lower_.diagonal().real() += damped.tail(y);
  if (!dense::cholesky_in_place(y_lower_) || !differences_.factor(columns_, y_lower_)) return false;
  damping_ = damping;
  return true;
}

/// U⁻¹ of right-hand sides, `right` those without D and `differences` the rows of D as they are off. What the elimination takes
/// off their squares is added to `square`, the lower triangle.
ComplexMatrix LineElimination::solve(const ComplexMatrix& right, ComplexMatrix differences, ComplexMatrix& square) const {
  const auto joint = at(layout_.joint), others = at(layout_.others), sides = right.cols();
  const Eigen::Index x_size = at(layout_.sub_jn.size()), y_size = at(layout_.sub_jj.size());
  ComplexMatrix x = right.topRows(x_size), y = right.bottomRows(y_size);
  ComplexMatrix taken = ComplexMatrix::Zero(sides, sides), pulled(joint, others * sides);
  ComplexMatrix half(x_size, sides);
  for (Eigen::Index k = 0; k < others; ++k) {
    const EliminatedColumns::Column& column = columns_.columns()[static_cast<std::size_t>(k)];
    auto block = x.middleRows(column.first, column.count);
    if (column.count > 0) {
      dense::solve_lower(column.lower, block);
      half.middleRows(column.first, column.count) = block;
      dense::solve_lower_adjoint(column.lower, block);
    }
    const ComplexMatrix of_column = column.pulled * block;
    for (Eigen::Index s = 0; s < sides; ++s) pulled.col(s * others + k) = of_column.col(s);
  }
  ComplexMatrix of_y(joint, joint);
  for (Eigen::Index s = 0; s < sides && others > 0; ++s) {
    of_y.setZero();
    dense::add_product(pulled.middleCols(s * others, others), g_, of_y);
    fold(of_y.data(), y.col(s).data());
  }
  dense::solve_lower(y_lower_, y);
  dense::add_square(half.adjoint().eval(), taken);
  dense::add_square(y.adjoint().eval(), taken);
  square -= taken;
  if (differences_.size() > 0) {
    differences_.answer(columns_, x, y, differences, square);
    differences_.add_forces(columns_, differences, x, y);
  }
  dense::solve_lower_adjoint(y_lower_, y);
  if (others > 0) {
    const ComplexMatrix g_adjoint = g_.adjoint();
    ComplexMatrix moved(joint, others * sides), change = ComplexMatrix::Zero(joint, joint);
    moved.setZero();
    for (Eigen::Index s = 0; s < sides; ++s) {
      for (Eigen::Index i = 0; i < y_size; ++i) {
        const auto [p, q] = layout_.sub_jj[static_cast<std::size_t>(i)];
        change(at(p), at(q)) = change(at(q), at(p)) = y(i, s);
      }
      dense::add_product(change, g_adjoint, moved.middleCols(s * others, others));
    }
    ComplexMatrix of_column(joint, sides);
    for (Eigen::Index k = 0; k < others; ++k) {
      const EliminatedColumns::Column& column = columns_.columns()[static_cast<std::size_t>(k)];
      for (Eigen::Index s = 0; s < sides; ++s) of_column.col(s) = moved.col(s * others + k);
      x.middleRows(column.first, column.count).noalias() += column.answer * of_column;
    }
  }
  ComplexMatrix out(x_size + y_size, sides);
  out << x, y;
  return out;
}

std::optional<ReducedLine> LineElimination::reduce(double damping) {
  if (damping != damping_ && !factor(damping)) return std::nullopt;
  ComplexMatrix square = square_;
  const ComplexMatrix steps = solve(right_, off_, square);
  square.triangularView<Eigen::StrictlyUpper>() = square.adjoint();
  const Eigen::Index last = square.cols() - 1, p = at(sides_.unknowns.size()), v = steps.rows();
  ReducedLine out;
  out.cost = square(last, last).real();
  if (!std::isfinite(out.cost)) return std::nullopt;
  out.information.resize(p, p);
  out.gradient.resize(p);
  Eigen::MatrixXd back(2 * v, p);
  for (Eigen::Index i = 0; i < p; ++i) {
    const auto [column, factor] = sides_.unknowns[static_cast<std::size_t>(i)];
    for (Eigen::Index j = 0; j < p; ++j) {
      const auto [other, other_factor] = sides_.unknowns[static_cast<std::size_t>(j)];
      out.information(i, j) = (std::conj(factor) * other_factor * square(column, other)).real();
    }
    out.gradient[i] = (std::conj(factor) * square(column, last)).real();
    Eigen::Map<Eigen::VectorXcd>(reinterpret_cast<Complex*>(back.col(i).data()), v) = factor * steps.col(column);
  }
  out.back = std::make_shared<Eigen::MatrixXd>(std::move(back));
  out.own.resize(2 * v);
  Eigen::Map<Eigen::VectorXcd>(reinterpret_cast<Complex*>(out.own.data()), v) = steps.col(last);
  return out;
}

LineStep LineElimination::own_step(const LineStep& gradient) const {
  const Eigen::Index v = gradient.size() / 2;
  const Eigen::Map<const Eigen::VectorXcd> right(reinterpret_cast<const Complex*>(gradient.data()), v);
  ComplexMatrix square = ComplexMatrix::Zero(1, 1);
  LineStep out(gradient.size());
  Eigen::Map<Eigen::VectorXcd>(reinterpret_cast<Complex*>(out.data()), v) =
      solve(right, ComplexMatrix::Zero(differences_.size(), 1), square);
  return out;
}

}  // namespace jointid::ident
