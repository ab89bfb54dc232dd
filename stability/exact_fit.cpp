#include "stability/exact_fit.hpp"

#include <boost/math/constants/constants.hpp>
#include <limits>
#include <memory>

#include "base/eigen.hpp"
#include "dense/svd.hpp"
#include "ident/likelihood/data/likelihood_plan.hpp"
#include "ident/likelihood/findings/bound_of.hpp"
#include "stability/exact_line.hpp"

namespace jointid::stability {
namespace {

using restrictions::Kind;
using Vector = Eigen::Matrix<Exact, Eigen::Dynamic, 1>;

/// Z_j(θ, ω) for θ in SI.
Pair<Exact> impedance(const restrictions::Restriction& restriction, const Exact& omega, const Vector& theta) {
  const Eigen::Index n = at(restriction.dofs.size());
  Pair<Exact> z(n, n);
  for (const restrictions::MatrixTerms& matrix : restriction.matrices) {
    const bool imaginary = matrix.kind == Kind::viscous_damping || matrix.kind == Kind::hysteretic_damping;
    Exact factor = 1;
    if (matrix.kind == Kind::mass) factor = -omega * omega;
    if (matrix.kind == Kind::viscous_damping) factor = omega;
    Real<Exact>& part = imaginary ? z.im : z.re;
    for (const restrictions::Term& term : matrix.terms)
      part(at(term.row), at(term.column)) += factor * Exact(term.coefficient) * theta[at(term.unknown)];
    for (const restrictions::Known& known : matrix.known) part(at(known.row), at(known.column)) += factor * Exact(known.value);
  }
  return z;
}

/// (1 + L)⁻¹ R.
Pair<Exact> solve_beside_one(Pair<Exact> left, const Pair<Exact>& right) {
  for (Eigen::Index i = 0; i < left.re.rows(); ++i) left.re(i, i) += 1;
  return solve_exactly(left, right);
}

/// Residuals of one line, of the unknowns of all lines and of its own.
class ExactLine {
 public:
  virtual ~ExactLine() = default;

  virtual Vector residuals(const Vector& theta, const Vector& own) const = 0;

  /// Where its own unknowns begin.
  virtual Vector begin() const { return Vector(0); }
};

/// (value − prediction)/σ of all measured numbers of a line, for X and Y of that line.
class LikelihoodLine final : public ExactLine {
 public:
  LikelihoodLine(const restrictions::Restriction& restriction, const ident::LineLayout& layout, const ident::LineData& data)
      : restriction_(restriction), layout_(layout), data_(data) {}

  Vector begin() const override {
    Vector out(at(2 * layout_.variables()));
    Eigen::Index next = 0;
    for (const ident::Channel* channel : {&data_.sub_jn, &data_.sub_jj}) {
      for (const Complex value : channel->value) {
        out[next++] = value.real();
        out[next++] = value.imag();
      }
    }
    return out;
  }

  Vector residuals(const Vector& theta, const Vector& own) const override {
    const Eigen::Index n = at(layout_.others), joint = at(layout_.joint);
    Pair<Exact> x(joint, n), y(joint, joint);
    Eigen::Index next = 0;
    for (const auto& [row, column] : layout_.sub_jn) {
      x.re(at(row), at(column)) = own[next++];
      x.im(at(row), at(column)) = own[next++];
    }
    for (const auto& [row, column] : layout_.sub_jj) {
      y.re(at(row), at(column)) = y.re(at(column), at(row)) = own[next++];
      y.im(at(row), at(column)) = y.im(at(column), at(row)) = own[next++];
    }
    const Pair<Exact> z = impedance(restriction_, Exact(data_.omega), theta), yz = y * z;
    const Pair<Exact> a = solve_beside_one(yz, x), b = solve_beside_one(yz, y);
    const Pair<Exact> d = Pair<Exact>(x.re.transpose(), x.im.transpose()) * (z * a);
    std::vector<Exact> out;
    add(layout_.sub_jn, data_.sub_jn, x, out);
    add(layout_.sub_jj, data_.sub_jj, y, out);
    add(layout_.asm_jn, data_.asm_jn, a, out);
    add(layout_.asm_jj, data_.asm_jj, b, out);
    add(layout_.drop_nn, data_.drop_nn, d, out);
    return Eigen::Map<const Vector>(out.data(), at(out.size()));
  }

 private:
  static void add(const std::vector<ident::Element>& elements, const ident::Channel& channel, const Pair<Exact>& block,
                  std::vector<Exact>& out) {
    for (std::size_t i = 0; i < elements.size(); ++i) {
      const Eigen::Index row = at(elements[i].row), column = at(elements[i].column);
      const Complex value = channel.value[i], weight = channel.weight[i];
      if (weight.real() != 0.0) out.push_back(Exact(weight.real()) * (Exact(value.real()) - block.re(row, column)));
      if (weight.imag() != 0.0) out.push_back(Exact(weight.imag()) * (Exact(value.imag()) - block.im(row, column)));
    }
  }

  const restrictions::Restriction& restriction_;
  const ident::LineLayout& layout_;
  const ident::LineData& data_;
};

/// H_nn − [H_aa − H_ab (I + Z_j H_bb)⁻¹ Z_j H_ba] of a line.
class ResponseLine final : public ExactLine {
 public:
  ResponseLine(const ident::Plan& plan, const Sets& sets, const ident::Line& line)
      : restriction_(plan.restriction), omega_(2 * boost::math::constants::pi<Exact>() * Exact(line.frequency_hz)) {
    const ident::Coordinates& c = plan.coordinates;
    const auto sub = [&](const ident::Dofs& rows, const ident::Dofs& columns) {
      return frfs<Exact>(sets.substructures, line.substructures, rows, columns);
    };
    ab_ = sub(c.responses, c.joint);
    ba_ = sub(c.joint, c.references);
    bb_ = sub(c.joint, c.joint);
    difference_ = frfs<Exact>(sets.assembly, line.assembly, c.responses, c.references) - sub(c.responses, c.references);
  }

  Vector residuals(const Vector& theta, const Vector&) const override {
    const Pair<Exact> z = impedance(restriction_, omega_, theta);
    const Pair<Exact> f = difference_ + ab_ * (z * solve_beside_one(bb_ * z, ba_));
    Vector out(2 * f.re.size());
    out << f.re.reshaped(), f.im.reshaped();
    return weight_ * out;
  }

  /// Makes ‖J diag θ‖ one.
  void weigh(const Real<Exact>& jacobian, const Vector& theta) { weight_ /= Real<Exact>(jacobian * theta.asDiagonal()).norm(); }

 private:
  const restrictions::Restriction& restriction_;
  Exact omega_, weight_ = 1;
  Pair<Exact> ab_, ba_, bb_, difference_;
};

/// ∂r/∂(own, θ), and r in the last column.
Real<Exact> linearised(const ExactLine& line, const Vector& theta, const Vector& own) {
  const Exact difference("1e-25");
  const Vector r = line.residuals(theta, own);
  Real<Exact> out(r.size(), own.size() + theta.size() + 1);
  const Exact own_size = own.size() > 0 ? Exact(own.cwiseAbs().maxCoeff()) : Exact(0), theta_size = theta.cwiseAbs().maxCoeff();
  for (Eigen::Index j = 0; j < own.size() + theta.size(); ++j) {
    Vector moved_own = own, moved_theta = theta;
    const bool is_own = j < own.size();
    Exact& number = is_own ? moved_own[j] : moved_theta[j - own.size()];
    const Exact size = number == 0 ? (is_own ? own_size : theta_size) : Exact(abs(number)), step = difference * size;
    number += step;
    out.col(j) = (line.residuals(moved_theta, moved_own) - r) / step;
  }
  out.col(out.cols() - 1) = r;
  return out;
}

class ExactProblem {
 public:
  ExactProblem(std::vector<std::unique_ptr<ExactLine>> lines, std::size_t unknowns) : lines_(std::move(lines)), unknowns_(at(unknowns)) {
    for (const auto& line : lines_) own_.push_back(line->begin());
  }

  /// One Gauss–Newton step of all unknowns; its length in parts of θ, both weighted by the columns.
  Exact step(Vector& theta) {
    std::vector<Real<Exact>> triangles;
    Real<Exact> rest = Real<Exact>::Zero(0, unknowns_ + 1);
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      const Real<Exact> all = exact_triangle(linearised(*lines_[i], theta, own_[i]));
      const Eigen::Index own = own_[i].size(), left = std::max<Eigen::Index>(0, all.rows() - own);
      Real<Exact> stacked(rest.rows() + left, unknowns_ + 1);
      stacked << rest, all.bottomRightCorner(left, unknowns_ + 1);
      rest = exact_triangle(stacked);
      triangles.push_back(all.topRows(own));
    }
    r_ = rest.topLeftCorner(unknowns_, unknowns_);
    const Vector move = -r_.triangularView<Eigen::Upper>().solve(Vector(rest.col(unknowns_).head(unknowns_)));
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      const Eigen::Index own = own_[i].size();
      if (own == 0) continue;
      const Vector right = triangles[i].col(own + unknowns_) + Vector(triangles[i].middleCols(own, unknowns_) * move);
      own_[i] -= triangles[i].leftCols(own).triangularView<Eigen::Upper>().solve(right);
    }
    const Vector norms = r_.colwise().norm();
    const Exact size = Vector(norms.cwiseProduct(theta)).norm();
    theta += move;
    return Vector(norms.cwiseProduct(move)).norm() / size;
  }

  ExactEstimate estimate(const Vector& theta) const {
    ExactEstimate out;
    Eigen::MatrixXd unit(unknowns_, unknowns_);
    for (Eigen::Index j = 0; j < unknowns_; ++j) {
      const Exact norm = r_.col(j).norm();
      unit.col(j) = Vector(r_.col(j) / norm).cast<double>();
      out.values.push_back(static_cast<double>(theta[j]));
      out.column_norms.push_back(static_cast<double>(norm));
    }
    const Eigen::VectorXd sigma = dense::jacobi_svd(unit, dense::Vectors::none, dense::Vectors::none).sigma;
    const double least = sigma[unknowns_ - 1];
    out.condition = least > 0.0 ? sigma[0] / least : std::numeric_limits<double>::infinity();
    return out;
  }

 private:
  std::vector<std::unique_ptr<ExactLine>> lines_;
  std::vector<Vector> own_;  ///< X and Y of every line
  Eigen::Index unknowns_;
  Real<Exact> r_;            ///< RᵀR: the information on θ
};

std::vector<std::unique_ptr<ExactLine>> likelihood_lines(const ident::Plan& plan) {
  ident::read_observations(plan, ident::Control());
  ident::Observations& observations = *ident::likelihood_plan(plan)->observations;
  observations.weigh_as_measured();
  std::vector<std::unique_ptr<ExactLine>> lines;
  for (const ident::LineData& data : observations.lines()) {
    lines.push_back(std::make_unique<LikelihoodLine>(plan.restriction, observations.layout(), data));
  }
  return lines;
}

std::vector<std::unique_ptr<ExactLine>> response_lines(const ident::Plan& plan, const Sets& sets, const Vector& start) {
  std::vector<std::unique_ptr<ExactLine>> lines;
  for (const ident::Line& line : plan.lines) {
    auto each = std::make_unique<ResponseLine>(plan, sets, line);
    each->weigh(linearised(*each, start, Vector(0)).leftCols(start.size()), start);
    lines.push_back(std::move(each));
  }
  return lines;
}

}  // namespace

ExactEstimate fit_exactly(const ident::Plan& plan, const Sets& sets, const std::vector<double>& start) {
  Vector theta = Eigen::Map<const Eigen::VectorXd>(start.data(), at(start.size())).cast<Exact>();
  ExactProblem problem(ident::likelihood_plan(plan) != nullptr ? likelihood_lines(plan) : response_lines(plan, sets, theta), start.size());
  for (int iteration = 0; iteration < 12; ++iteration) {
    if (problem.step(theta) < 1e-20) break;
  }
  return problem.estimate(theta);
}

}  // namespace jointid::stability
