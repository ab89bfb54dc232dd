#pragma once

#include <map>
#include <numbers>
#include <optional>
#include <tuple>

#include "dense/pivoted_qr.hpp"
#include "ident/plan/plan.hpp"
#include "tests/ident/memory_systems.hpp"

namespace jointid::ident {

/// Method One the plain way, as an independent route: every equation written out with its N² coefficients, multiplied by a
/// dense T_f and T, filtered, weighted, stacked over all lines, one dense QR. No band of any joint.
class PlainEstimate {
 public:
  PlainEstimate(const Plan& plan, const std::vector<frf::FrfSet>& substructures,
                const std::vector<frf::FrfSet>& assembly)
      : plan_(plan), sub_(substructures), asm_(assembly), n_(plan.coordinates.joint.size()) {
    for (const Line& line : plan.lines) add(line);
  }

  /// Values of the unknowns in SI units.
  std::vector<double> solve() const {
    Eigen::VectorXd scale = stacked_.colwise().norm().cwiseInverse().transpose();
    Eigen::VectorXd y = scale.asDiagonal() *
                        dense::RealPivotedQr(stacked_ * scale.asDiagonal()).solve(right_);
    std::vector<double> values;
    for (std::size_t u = 0; u < plan_.restriction.unknowns.size(); ++u) {
      const restrictions::Kind kind = plan_.restriction.unknowns[u].kind;
      const double omega0 = plan_.omega0;
      const double unit = kind == restrictions::Kind::mass              ? omega0 * omega0
                          : kind == restrictions::Kind::viscous_damping ? omega0
                                                                        : 1.0;
      values.push_back(y[static_cast<Eigen::Index>(u)] / unit);
    }
    return values;
  }

  std::size_t used() const { return used_; }
  std::size_t dropped() const { return dropped_; }

 private:
  struct Row {
    Equation equation;
    std::size_t m, l;
    Eigen::VectorXcd coefficients;  ///< of z = row-major vec(Z_j)
    Complex c1, c2;
  };

  static Eigen::Index index(std::size_t i) { return static_cast<Eigen::Index>(i); }

  Complex sub(const Line& line, const frf::Dof& r, const frf::Dof& c) const {
    const bool apart = source(r) != source(c);
    return apart ? Complex(0.0) : frf_at(sub_, line.substructures, r, c);
  }
  std::size_t source(const frf::Dof& dof) const {
    for (std::size_t s = 0; s < sub_.size(); ++s) {
      if (frf::find_coordinate(sub_[s].header.response, dof) != frf::npos ||
          frf::find_coordinate(sub_[s].header.reference, dof) != frf::npos) {
        return s;
      }
    }
    return sub_.size();
  }
  Complex assembly(const Line& line, const frf::Dof& r, const frf::Dof& c) const {
    return frf_at(asm_, line.assembly, r, c);
  }

  /// A(m,:) ⊗ B(:,l) for every (m, l) of the named equation.
  void write_out(const Line& line, Equation equation, std::vector<Row>& rows) const {
    const Coordinates& at = plan_.coordinates;
    const bool n_rows = equation == Equation::nn || equation == Equation::nj;
    const bool n_columns = equation == Equation::nn || equation == Equation::jn;
    const Dofs& left = n_rows ? at.responses : at.joint;
    const Dofs& right = n_columns ? at.references : at.joint;
    for (std::size_t m = 0; m < left.size(); ++m) {
      for (std::size_t l = 0; l < right.size(); ++l) {
        Row row{equation, m, l, Eigen::VectorXcd(index(n_ * n_)), sub(line, left[m], right[l]),
                assembly(line, left[m], right[l])};
        for (std::size_t p = 0; p < n_; ++p) {
          for (std::size_t q = 0; q < n_; ++q) {
            row.coefficients[index(p * n_ + q)] = assembly(line, left[m], at.joint[p]) * sub(line, at.joint[q], right[l]);
          }
        }
        rows.push_back(std::move(row));
      }
    }
  }

  bool in_use(const Row& row) const {
    const auto finite = [](const Complex& c) { return std::isfinite(c.real()) && std::isfinite(c.imag()); };
    if (!row.coefficients.allFinite() || row.coefficients.cwiseAbs().maxCoeff() == 0.0) return false;
    if (!finite(row.c1) || !finite(row.c2)) return false;
    const double delta = plan_.scene.identify.delta;
    return delta == 0.0 || 2.0 * std::abs(row.c1 - row.c2) > delta * (std::abs(row.c1) + std::abs(row.c2));
  }

  /// Dense T_f(ω)·T over the scaled unknowns, known part last.
  Eigen::MatrixXcd restriction(double omega) const {
    const std::size_t unknowns = plan_.restriction.unknowns.size();
    const double omega0 = plan_.omega0;
    Eigen::MatrixXcd t = Eigen::MatrixXcd::Zero(index(n_ * n_), index(unknowns + 1));
    const std::vector<double> none(unknowns, 0.0);
    for (const restrictions::Kind kind : restrictions::all_kinds) {
      const Complex scaled = kind == restrictions::Kind::stiffness         ? Complex(1.0)
                             : kind == restrictions::Kind::mass            ? Complex(-omega * omega / (omega0 * omega0))
                             : kind == restrictions::Kind::viscous_damping ? Complex(0.0, omega / omega0)
                                                                           : Complex(0.0, 1.0);
      const Complex plain = kind == restrictions::Kind::stiffness         ? Complex(1.0)
                            : kind == restrictions::Kind::mass            ? Complex(-omega * omega)
                            : kind == restrictions::Kind::viscous_damping ? Complex(0.0, omega)
                                                                          : Complex(0.0, 1.0);
      const std::vector<double> known = plan_.restriction.matrix(kind, none);
      for (std::size_t u = 0; u < unknowns; ++u) {
        std::vector<double> unit = none;
        unit[u] = 1.0;
        const std::vector<double> with = plan_.restriction.matrix(kind, unit);
        for (std::size_t e = 0; e < n_ * n_; ++e) t(index(e), index(u)) += scaled * (with[e] - known[e]);
      }
      for (std::size_t e = 0; e < n_ * n_; ++e) t(index(e), index(unknowns)) += plain * known[e];
    }
    return t;
  }

  /// Equations that share a weight (before T_f and T).
  std::tuple<int, std::size_t, std::size_t> group(const Row& row) const {
    switch (plan_.scene.identify.weighting) {
      case weighting::Weighting::wbg:
        return {static_cast<int>(row.equation), row.m, 0};
      case weighting::Weighting::wbs:
        return {static_cast<int>(row.equation), row.m, row.l};
      default:
        return {0, 0, 0};
    }
  }

  void add(const Line& line) {
    std::vector<Row> all, rows;
    for (const Equation equation : plan_.equations) write_out(line, equation, all);
    for (Row& row : all) {
      if (in_use(row)) rows.push_back(std::move(row));
    }
    used_ += rows.size();
    dropped_ += all.size() - rows.size();
    if (rows.empty()) return;
    std::map<std::tuple<int, std::size_t, std::size_t>, double> largest;
    for (const Row& row : rows) {
      double& value = largest[group(row)];
      value = std::max(value, row.coefficients.cwiseAbs().maxCoeff());
    }
    const weighting::Weighting weighting = plan_.scene.identify.weighting;
    const bool before = weighting != weighting::Weighting::none && weighting != weighting::Weighting::wa;
    const Eigen::MatrixXcd t = restriction(2.0 * std::numbers::pi * line.frequency_hz);
    const Eigen::Index unknowns = t.cols() - 1, count = index(rows.size());
    Eigen::MatrixXd e(2 * count, unknowns);
    Eigen::VectorXd p(2 * count);
    for (Eigen::Index i = 0; i < count; ++i) {
      const Row& row = rows[static_cast<std::size_t>(i)];
      const double weight = before ? 1.0 / largest[group(row)] : 1.0;
      const Eigen::RowVectorXcd full = weight * row.coefficients.transpose() * t;
      const Complex right = weight * (row.c1 - row.c2) - full[unknowns];
      e.row(i) = full.head(unknowns).real();
      e.row(count + i) = full.head(unknowns).imag();
      p[i] = right.real();
      p[count + i] = right.imag();
    }
    if (weighting == weighting::Weighting::wa) {
      const double factor = 1.0 / std::sqrt(Eigen::MatrixXd(e.transpose() * e).cwiseAbs().maxCoeff());
      e *= factor;
      p *= factor;
    }
    append(e, p);
  }

  void append(const Eigen::MatrixXd& e, const Eigen::VectorXd& p) {
    const Eigen::Index before = stacked_.rows();
    stacked_.conservativeResize(before + e.rows(), e.cols());
    right_.conservativeResize(before + e.rows());
    stacked_.bottomRows(e.rows()) = e;
    right_.tail(e.rows()) = p;
  }

  const Plan& plan_;
  const std::vector<frf::FrfSet>& sub_;
  const std::vector<frf::FrfSet>& asm_;
  std::size_t n_;
  std::size_t used_ = 0, dropped_ = 0;
  Eigen::MatrixXd stacked_;
  Eigen::VectorXd right_;
};

}  // namespace jointid::ident
