#include "ident/likelihood/elimination/line_elimination.hpp"

#include "base/eigen.hpp"
#include "dense/blas.hpp"
#include "ident/likelihood/elimination/shared_reduction.hpp"

namespace jointid::ident {

LineElimination::LineElimination(const LineLayout& layout)
    : layout_(layout),
      columns_(layout),
      squares_(layout),
      differences_(layout),
      b_squares_(layout.asm_jj.empty() ? 0 : layout.joint) {}

bool LineElimination::linearise(const LineData& data, const LineState& state, const LineFactors& factors,
                                const JointImpedance* joint, const SystematicTerms* terms) {
  weights_.take(layout_, data, state);
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
  normal_sides_.take(layout_, weights_, sides_, factors, false);
  return factor(0.0);
}

bool LineElimination::factor(double damping) {
  const Eigen::Index x = at(layout_.sub_jn.size()), y = at(layout_.sub_jj.size());
  damping_ = -1.0;  // none, should it fail
  const Eigen::VectorXd damped = weights_.own_squared * (1.0 + damping);
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
    fold(layout_, of_y.data(), y.col(s).data());
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

std::optional<ReducedLine> LineElimination::reduce(double damping, bool answer) {
  if (damping != damping_ && !factor(damping)) return std::nullopt;
  ComplexMatrix square = normal_sides_.square();
  const ComplexMatrix steps = solve(normal_sides_.values(), off_, square);
  return shared_reduction(sides_, square, answer ? &steps : nullptr);
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
