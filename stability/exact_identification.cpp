#include "stability/exact_identification.hpp"

#include <boost/math/constants/constants.hpp>
#include <limits>

#include "base/eigen.hpp"
#include "dense/svd.hpp"
#include "ident/equations/row_expander.hpp"
#include "restrictions/impedance_factor.hpp"
#include "stability/exact_line.hpp"
#include "weighting/line_weights.hpp"

namespace jointid::stability {
namespace {

using ident::Dofs;
using restrictions::Kind;

/// A Z_j B = C of one line, rows and columns of the two classes one after the other.
template <class Scalar>
struct Equations {
  Pair<Scalar> a, b, c;
  std::size_t n_rows = 0, n_columns = 0;  ///< of class 0
  bool wanted[2][2] = {};
  bool a_is_unit = false;
};

template <class Scalar>
class Stack {
 public:
  Stack(const ident::Plan& plan, const Sets& sets) : plan_(plan), sets_(sets), unknowns_(plan.restriction.unknowns.size()) {
    for (const ident::Line& line : plan.lines) add(line);
    reduce();
  }

  ExactEstimate solve() const {
    const auto n = at(unknowns_);
    const Real<Scalar> r = rows_.topLeftCorner(n, n);
    const Real<Scalar> y = r.template triangularView<Eigen::Upper>().solve(Real<Scalar>(rows_.col(n).head(n)));
    ExactEstimate out;
    Eigen::MatrixXd unit(n, n);
    for (Eigen::Index j = 0; j < n; ++j) {
      const Scalar norm = r.col(j).norm();
      unit.col(j) = Real<Scalar>(r.col(j) / norm).template cast<double>();
      const auto kind = plan_.restriction.unknowns[static_cast<std::size_t>(j)].kind;
      const double unscale = restrictions::unscale(kind, plan_.omega0);
      out.values.push_back(static_cast<double>(Scalar(y(j, 0) * Scalar(unscale))));
      out.column_norms.push_back(static_cast<double>(norm) / unscale);
    }
    const Eigen::VectorXd sigma = dense::jacobi_svd(unit, dense::Vectors::none, dense::Vectors::none).sigma;
    const double least = sigma[n - 1];
    out.condition = least > 0.0 ? sigma[0] / least : std::numeric_limits<double>::infinity();
    return out;
  }

 private:
  Pair<Scalar> sub(const ident::Line& line, const Dofs& rows, const Dofs& columns) const {
    return frfs<Scalar>(sets_.substructures, line.substructures, rows, columns);
  }
  Pair<Scalar> assembly(const ident::Line& line, const Dofs& rows, const Dofs& columns) const {
    return frfs<Scalar>(sets_.assembly, line.assembly, rows, columns);
  }

  Equations<Scalar> method_one(const ident::Line& line) const {
    const ident::Coordinates& at = plan_.coordinates;
    const ident::EquationSet use(plan_.equations);
    const Dofs n_rows = use.nn || use.nj ? at.responses : Dofs(), n_columns = use.nn || use.jn ? at.references : Dofs();
    const Dofs rows = ident::joined(n_rows, use.jj || use.jn ? at.joint : Dofs());
    const Dofs columns = ident::joined(n_columns, use.nj || use.jj ? at.joint : Dofs());
    return {assembly(line, rows, at.joint), sub(line, at.joint, columns), sub(line, rows, columns) - assembly(line, rows, columns),
            n_rows.size(), n_columns.size(), {{use.nn, use.nj}, {use.jn, use.jj}}, false};
  }

  Equations<Scalar> method_two(const ident::Line& line) const {
    const ident::Coordinates& at = plan_.coordinates;
    const ident::EquationSet use(plan_.equations);
    const Dofs all = ident::joined(at.responses, at.joint), n_columns = use.jn ? at.references : Dofs();
    const Dofs columns = ident::joined(n_columns, use.jj ? at.joint : Dofs());
    const auto joint = jointid::at(at.joint.size());
    // Z H_asm − I over all coordinates; its rows b are −(C₁ − C₂) up to sign.
    const Pair<Scalar> z_h = solve_exactly(sub(line, all, all), assembly(line, all, columns));
    Pair<Scalar> c{Real<Scalar>(-z_h.re.bottomRows(joint)), Real<Scalar>(-z_h.im.bottomRows(joint))};
    for (Eigen::Index k = 0; k < joint && use.jj; ++k) c.re(k, c.re.cols() - joint + k) += 1;
    return {Pair<Scalar>(), assembly(line, at.joint, columns), c, 0, n_columns.size(), {{false, false}, {use.jn, use.jj}}, true};
  }

  Equations<Scalar> direct(const ident::Line& line) const {
    const ident::Coordinates& at = plan_.coordinates;
    const Pair<Scalar> h_ba = sub(line, at.joint, at.references);
    const Pair<Scalar> c = sub(line, at.responses, at.references) - assembly(line, at.responses, at.references);
    // H_ba⁺ = H_baᴴ (H_ba H_baᴴ)⁻¹: the digits last for the square of the condition.
    const Pair<Scalar> carried = h_ba.adjoint() * solve_exactly(h_ba * h_ba.adjoint(), sub(line, at.joint, at.joint));
    return {sub(line, at.responses, at.joint) - c * carried, h_ba, c, at.responses.size(), at.references.size(),
            {{true, false}, {false, false}}, false};
  }

  Equations<Scalar> equations(const ident::Line& line) const {
    switch (plan_.scene.identify.method) {
      case ident::Method::two:
        return method_two(line);
      case ident::Method::direct:
        return direct(line);
      default:
        return method_one(line);
    }
  }

  /// The weights of the program itself, from what it sees: the elements in double precision.
  static weighting::LineWeights weights(weighting::Weighting weighting, const Equations<Scalar>& e, Eigen::Index rows) {
    const auto moduli = [](const Pair<Scalar>& m) {
      return Eigen::MatrixXd((m.re.template cast<double>().array().square() + m.im.template cast<double>().array().square()).sqrt());
    };
    std::vector<double> row_max(static_cast<std::size_t>(rows), 1.0), column_max;
    if (!e.a_is_unit) {
      const Eigen::VectorXd largest = moduli(e.a).rowwise().maxCoeff();
      row_max.assign(largest.begin(), largest.end());
    }
    const Eigen::VectorXd largest = moduli(e.b).colwise().maxCoeff();
    column_max.assign(largest.begin(), largest.end());
    std::vector<std::uint8_t> column_class(column_max.size(), 1), keep;
    std::fill_n(column_class.begin(), e.n_columns, std::uint8_t{0});
    for (std::size_t m = 0; m < row_max.size(); ++m) {
      for (std::size_t l = 0; l < column_max.size(); ++l) {
        keep.push_back(e.wanted[e.a_is_unit || m >= e.n_rows][l >= e.n_columns] && row_max[m] > 0.0 && column_max[l] > 0.0);
      }
    }
    weighting::LineWeights out;
    weighting::line_weights(weighting, {row_max, column_max, column_class, keep}, out);
    return out;
  }

  /// T_f and T: coefficient of the scaled unknown of a kind, as a pure real or imaginary factor.
  struct Factor {
    Scalar value;
    bool imaginary;
  };
  Factor factor(Kind kind, const Scalar& ratio) const {
    switch (kind) {
      case Kind::mass:
        return {-ratio * ratio, false};
      case Kind::viscous_damping:
        return {ratio, true};
      case Kind::hysteretic_damping:
        return {Scalar(1), true};
      case Kind::stiffness:
        break;
    }
    return {Scalar(1), false};
  }

  void add(const ident::Line& line) {
    const Equations<Scalar> e = equations(line);
    const Eigen::Index rows = e.c.re.rows(), columns = e.c.re.cols(), n = at(unknowns_);
    const weighting::Weighting weighting = plan_.scene.identify.weighting;
    const weighting::LineWeights weight = weights(weighting, e, rows);
    const Scalar ratio = 2 * boost::math::constants::pi<Scalar>() * Scalar(line.frequency_hz) / Scalar(plan_.omega0);
    Real<Scalar> block = Real<Scalar>::Zero(2 * rows * columns, n + 1);
    Eigen::Index used = 0;
    for (Eigen::Index m = 0; m < rows; ++m) {
      for (Eigen::Index l = 0; l < columns; ++l) {
        const bool j_column = l >= at(e.n_columns);
        if (!e.wanted[e.a_is_unit || m >= at(e.n_rows)][j_column]) continue;
        const Scalar w = Scalar(weight.row[static_cast<std::size_t>((j_column ? rows : 0) + m)]) *
                         Scalar(weight.column[static_cast<std::size_t>(l)]);
        write(e, m, l, w, ratio, block.middleRows(used, 2));
        used += 2;
      }
    }
    if (weighting == weighting::Weighting::wa) {
      const Scalar largest = block.topRows(used).leftCols(n).colwise().norm().maxCoeff();
      block /= largest;
    }
    append(block.topRows(used));
  }

  void write(const Equations<Scalar>& e, Eigen::Index m, Eigen::Index l, const Scalar& w, const Scalar& ratio,
             Eigen::Ref<Real<Scalar>> to) const {
    const Eigen::Index n = at(unknowns_);
    to(0, n) = w * e.c.re(m, l);
    to(1, n) = w * e.c.im(m, l);
    for (const restrictions::MatrixTerms& matrix : plan_.restriction.matrices) {
      const Factor f = factor(matrix.kind, ratio);
      const auto put = [&](std::size_t p, std::size_t q, const Scalar& value, Eigen::Index column) {
        const auto b_row = at(q), a_column = at(p);
        Scalar re = e.b.re(b_row, l), im = e.b.im(b_row, l);
        if (e.a_is_unit) {
          if (a_column != m) return;
        } else {
          const Scalar a_re = e.a.re(m, a_column), a_im = e.a.im(m, a_column), b_re = re;
          re = a_re * b_re - a_im * im;
          im = a_re * im + a_im * b_re;
        }
        const Scalar size = w * value * f.value;
        to(0, column) += f.imaginary ? Scalar(-size * im) : Scalar(size * re);
        to(1, column) += f.imaginary ? Scalar(size * re) : Scalar(size * im);
      };
      for (const restrictions::Term& term : matrix.terms) {
        put(term.row, term.column, Scalar(term.coefficient), at(term.unknown));
      }
      const Scalar scale = Scalar(restrictions::unscale(matrix.kind, plan_.omega0));
      for (const restrictions::Known& known : matrix.known) put(known.row, known.column, Scalar(-known.value) / scale, n);
    }
  }

  void append(const Real<Scalar>& block) {
    if (filled_ + block.rows() > rows_.rows())
      rows_.conservativeResize(std::max<Eigen::Index>(1024, filled_ + 4 * block.rows()), block.cols());
    rows_.middleRows(filled_, block.rows()) = block;
    filled_ += block.rows();
    if (filled_ > 1000) reduce();
  }

  void reduce() {
    const Real<Scalar> r = exact_triangle(Real<Scalar>(rows_.topRows(filled_)));
    filled_ = r.rows();
    rows_.topRows(filled_) = r;
  }

  const ident::Plan& plan_;
  const Sets& sets_;
  std::size_t unknowns_;
  Real<Scalar> rows_;
  Eigen::Index filled_ = 0;
};

}  // namespace

ExactEstimate identify_exactly(const ident::Plan& plan, const Sets& sets) {
  if (plan.lines.size() > most_exact_lines) return Stack<long double>(plan, sets).solve();
  return Stack<Exact>(plan, sets).solve();
}

}  // namespace jointid::stability
