#include "ident/judgement/noisy_lines.hpp"

#include <algorithm>
#include <cmath>

#include "base/eigen.hpp"
#include "base/error.hpp"
#include "dense/blas.hpp"
#include "ident/judgement/measured_rectangle.hpp"
#include "ident/plan/coordinates.hpp"
#include "ident/variance/frf_covariances.hpp"

namespace jointid::ident {
namespace {

/// Covariances of the columns of a rectangle of the substructures, where files have them.
class ColumnErrors {
 public:
  ColumnErrors(frf::FrfSystem& system, const Dofs& rows, const Dofs& columns, const Scene& scene, const std::vector<std::size_t>& lines)
      : coordinates_(rows), columns_(join(columns)), covariances_(system, scene, coordinates_, {rectangle(rows.size())}) {
    if (!covariances_.any()) return;
    covariances_.prepare(lines);
    covariances_.read(lines);
  }

  /// F of the covariance F Fᴴ of some rows of a column; empty where the file has none.
  Eigen::MatrixXcd factor(std::size_t line, const std::vector<std::size_t>& rows, std::size_t column, const MeasuredRectangle& of) const {
    if (!covariances_.any()) return {};
    const auto n = at(rows.size());
    Eigen::MatrixXcd s = Eigen::MatrixXcd::Zero(n, n);
    bool shared = false;
    for (Eigen::Index i = 0; i < n; ++i) {
      const std::size_t row = rows[static_cast<std::size_t>(i)];
      s(i, i) = of.variance(line, row, column);
      const StoredError one = covariances_.error(line, row, columns_[column]);
      if (!one.is_known()) continue;
      const Eigen::MatrixXcd& stored = covariances_.covariances(line)[one.group];
      const auto value = [&](std::size_t a, std::size_t b) { return stored(at(a), at(b)); };
      if (!std::isfinite(value(one.member, one.member).real())) continue;
      s(i, i) = value(one.member, one.member);
      for (Eigen::Index k = 0; k < i; ++k) {
        const StoredError other = covariances_.error(line, rows[static_cast<std::size_t>(k)], columns_[column]);
        if (other.group != one.group || !std::isfinite(value(other.member, other.member).real())) continue;
        s(i, k) = one.sign * other.sign * value(one.member, other.member);
        shared = true;
      }
    }
    return shared ? factor_of(s) : Eigen::MatrixXcd();
  }

 private:
  /// L of L Lᴴ, the lower triangle of s but for rounding; empty where there is none. Exact FRFs, and those not measured, have a row of 0.
  static Eigen::MatrixXcd factor_of(Eigen::MatrixXcd s) {
    std::vector<Eigen::Index> exact;
    for (Eigen::Index i = 0; i < s.rows(); ++i) {
      if (s(i, i).real() > 0.0 && std::isfinite(s(i, i).real())) continue;
      exact.push_back(i);
      s.row(i).setZero();
      s.col(i).setZero();
      s(i, i) = 1.0;
    }
    s.diagonal() *= 1.0 + 1e-9;
    if (!dense::cholesky_in_place(s)) return {};
    Eigen::MatrixXcd out = s.triangularView<Eigen::Lower>();
    for (const Eigen::Index i : exact) out(i, i) = 0.0;
    return out;
  }

  /// Adds the columns to the coordinates; their places there.
  std::vector<std::size_t> join(const Dofs& columns) {
    std::vector<std::size_t> out;
    for (const frf::Dof& dof : columns) {
      const std::size_t found = frf::find_coordinate(coordinates_, dof);
      out.push_back(found == frf::npos ? coordinates_.size() : found);
      if (found == frf::npos) coordinates_.push_back(dof);
    }
    return out;
  }
  FrfCovariances::Rectangle rectangle(std::size_t rows) const {
    FrfCovariances::Rectangle out{{}, columns_};
    for (std::size_t r = 0; r < rows; ++r) out.rows.push_back(r);
    return out;
  }

  Dofs coordinates_;                  ///< the rows, then columns that are none
  std::vector<std::size_t> columns_;  ///< among them
  FrfCovariances covariances_;
};

/// What Method One reads: rows and columns of both systems.
struct Reads {
  EquationSet use;
  Dofs n_rows, n_columns, rows, columns;
};

/// The equations of the plan, or for other methods those that Method One has on its data.
std::vector<Equation> equations_of(const Plan& plan) {
  if (takes_frfs_as_measured(plan.scene.identify.method)) return plan.equations;
  Scene scene = plan.scene;
  scene.identify.method = Method::one;
  scene.identify.equations.clear();
  return choose_equations(scene, plan.coordinates, *plan.substructures, *plan.assembly);
}

Reads reads_of(const Plan& plan) {
  const Coordinates& at = plan.coordinates;
  const EquationSet use(equations_of(plan));
  const Dofs n_rows = only_if(use.nn || use.nj, at.responses), n_columns = only_if(use.nn || use.jn, at.references);
  return {use, n_rows, n_columns, joined(n_rows, only_if(use.jj || use.jn, at.joint)),
          joined(n_columns, only_if(use.nj || use.jj, at.joint))};
}

std::vector<Eigen::Index> joint_numbers(std::size_t others, std::size_t all) {
  std::vector<Eigen::Index> out(all, -1);
  for (std::size_t i = others; i < all; ++i) out[i] = at(i - others);
  return out;
}

/// One line: the rows of the substructures' rectangle are those of A's rows that are no joint coordinates, then all joint ones.
NoisyLine line_of(const NoisyLines& form, const MeasuredRectangle& sub, const ColumnErrors& errors, const MeasuredRectangle& whole,
                  std::size_t line, std::size_t joint) {
  const std::size_t m = form.rows.size(), l = form.columns.size(), others = whole.columns - joint, n_rows = sub.rows - joint;
  NoisyLine out;
  out.a = Eigen::MatrixXcd(at(m), at(joint));
  out.b = Eigen::MatrixXcd(at(joint), at(l));
  out.c = Eigen::MatrixXcd(at(m), at(l));
  out.a_variance = Eigen::MatrixXd(at(m), at(joint));
  out.b_variance = Eigen::MatrixXd(at(joint), at(l));
  out.c_variance = Eigen::MatrixXd(at(m), at(l));
  for (std::size_t j = 0; j < joint; ++j) {
    for (std::size_t r = 0; r < m; ++r) {
      out.a(at(r), at(j)) = whole.value(line, r, others + j);
      out.a_variance(at(r), at(j)) = whole.variance(line, r, others + j);
    }
    for (std::size_t c = 0; c < l; ++c) {
      out.b(at(j), at(c)) = sub.value(line, n_rows + j, c);
      out.b_variance(at(j), at(c)) = sub.variance(line, n_rows + j, c);
    }
  }
  std::vector<std::size_t> part_rows;  // of the substructures' rectangle
  for (std::size_t j = 0; j < joint; ++j) part_rows.push_back(n_rows + j);
  for (std::size_t r = 0; r < n_rows; ++r) part_rows.push_back(r);
  for (std::size_t c = 0; c < l; ++c) out.part_errors.push_back(errors.factor(line, part_rows, c, sub));
  for (std::size_t r = 0; r < m; ++r) {
    for (std::size_t c = 0; c < l; ++c) {
      const bool of_b = form.row_joint[r] >= 0 || out.part_errors[c].size() > 0, of_a = form.column_joint[c] >= 0;
      out.c(at(r), at(c)) = sub.value(line, r, c) - whole.value(line, r, c);
      out.c_variance(at(r), at(c)) = (of_b ? 0.0 : sub.variance(line, r, c)) + (of_a ? 0.0 : whole.variance(line, r, c));
    }
  }
  return out;
}

std::optional<NoisyLines> read_form(const Plan& plan, std::size_t most) {
  const Reads reads = reads_of(plan);
  const Dofs& joint = plan.coordinates.joint;
  const std::vector<Line> chosen = spread_lines(plan.lines, most);
  const std::vector<std::size_t> sub_lines = lines_of(chosen, &Line::substructures), asm_lines = lines_of(chosen, &Line::assembly);
  const std::optional<Scene> scene = scene_with_noise(plan, {joint, reads.columns, sub_lines}, {reads.rows, joint, asm_lines});
  if (!scene) return std::nullopt;
  NoisyLines out{.lines = {}, .row_joint = joint_numbers(reads.n_rows.size(), reads.rows.size()),
                 .column_joint = joint_numbers(reads.n_columns.size(), reads.columns.size()), .rows = reads.rows, .columns = reads.columns};
  out.wanted[0][0] = reads.use.nn;
  out.wanted[0][1] = reads.use.nj;
  out.wanted[1][0] = reads.use.jn;
  out.wanted[1][1] = reads.use.jj;
  out.from_knowledge = knows_noise(plan);
  const Dofs sub_rows = joined(reads.n_rows, joint);
  const MeasuredRectangle sub = read_rectangle(*plan.substructures, sub_rows, reads.columns, *scene, sub_lines);
  const ColumnErrors errors(*plan.substructures, sub_rows, reads.columns, *scene, sub_lines);
  const MeasuredRectangle whole = read_rectangle(*plan.assembly, reads.rows, joined(reads.n_columns, joint), *scene, asm_lines);
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    out.lines.push_back(line_of(out, sub, errors, whole, i, joint.size()));
    out.lines.back().frequency_hz = chosen[i].frequency_hz;
  }
  return out;
}

}  // namespace

std::optional<NoisyLines> read_noisy_lines(const Plan& plan, std::size_t most) {
  try {
    return read_form(plan, most);
  } catch (const InputError&) {
    return std::nullopt;  // no equation of Method One, or no variances
  }
}

}  // namespace jointid::ident
