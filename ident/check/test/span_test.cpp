#include "ident/check/test/span_test.hpp"

#include <cmath>

#include "base/eigen.hpp"
#include "dense/blas.hpp"
#include "dense/minimum_norm.hpp"
#include "ident/check/test/slope_fit.hpp"

namespace jointid::ident {
namespace {

constexpr double least_square = 1e-6;  ///< residuals below 1e-3 of the FRFs count as that

using Indices = std::vector<Eigen::Index>;

Eigen::MatrixXcd block(const CheckedFile& file, std::size_t line, const Indices& rows, const Indices& columns, bool transposed) {
  const Eigen::MatrixXcd& all = file.frfs[line];
  if (transposed) return all(columns, rows).transpose();
  return all(rows, columns);
}

/// Orthonormal basis of the columns, by Gram and Schmidt, twice where half of a column is lost; columns that depend on those
/// before are left out.
Eigen::MatrixXcd basis_of(const Eigen::MatrixXcd& columns) {
  Eigen::MatrixXcd q(columns.rows(), columns.cols());
  Eigen::Index count = 0;
  for (Eigen::Index c = 0; c < columns.cols(); ++c) {
    Eigen::VectorXcd v = columns.col(c);
    const double before = v.norm();
    const auto take_out = [&] { v.noalias() -= q.leftCols(count) * (q.leftCols(count).adjoint() * v).eval(); };
    take_out();
    if (v.norm() < 0.5 * before) take_out();
    if (const double after = v.norm(); after > 1e-10 * before) q.col(count++) = v / after;
  }
  return q.leftCols(count);
}

/// The terms of one line.
struct SpanLine {
  Eigen::MatrixXcd assembly, part;  ///< R × C; the part is zero outside
  Eigen::MatrixXcd joint;           ///< R × J
  Eigen::MatrixXcd residual;        ///< after scaling; only where it is asked for
  Eigen::VectorXd row_scale, column_scale;
  double square = 0.0;  ///< of the residual's norm
  std::vector<Eigen::MatrixXcd> weights;  ///< [C] W, lower triangles; empty: I
  std::vector<Eigen::MatrixXcd> bases;    ///< of the joint's columns, scaled and weighed: [C], or the one of all columns

  bool is_complete() const { return assembly.allFinite() && part.allFinite() && joint.allFinite(); }

  void load(const SpanSetup& setup, const std::vector<CheckedFile>& files, std::size_t line) {
    const CheckedFile& of_part = files[setup.part];
    const CheckedFile& of_assembly = files[setup.assembly];
    const Indices columns = assembly_columns(setup);
    assembly = block(of_assembly, line, setup.assembly_rows, columns, setup.transposed);
    part = Eigen::MatrixXcd::Zero(assembly.rows(), assembly.cols());
    part.leftCols(at(setup.part_columns.size())) = block(of_part, line, setup.part_rows, setup.part_columns, setup.transposed);
    joint = block(of_part, line, setup.part_rows, setup.joint, setup.transposed);
  }

  /// Scales by the sizes of the terms and takes the span of the joint's columns out; the third term's size needs the forces,
  /// which the first scaling gives.
  void project(const SpanSetup& setup, const std::vector<CheckedFile>& files, std::size_t line, bool with_residual) {
    weights.clear();
    const Eigen::MatrixXcd difference = assembly - part;
    Eigen::MatrixXd size = assembly.cwiseAbs2() + part.cwiseAbs2();
    scale_to(size);
    const Eigen::MatrixXcd& basis = bases.front();
    size += (row_scale.asDiagonal() * (basis * (basis.adjoint() * scale(difference))) * column_scale.asDiagonal()).cwiseAbs2();
    scale_to(size);
    if (setup.weighed) weigh(setup, files, line);
    residual = weigh(scale(difference));
    if (!with_residual && weights.empty()) {
      square = residual.squaredNorm() - (bases.front().adjoint() * residual).squaredNorm();
      return;
    }
    const Eigen::MatrixXcd explained = spanned(residual);
    if (with_residual) {
      residual -= explained;
      square = residual.squaredNorm();
    } else {
      square = residual.squaredNorm() - explained.squaredNorm();
    }
  }

  Eigen::Index freedom() const {
    Eigen::Index sum = 0;
    for (Eigen::Index c = 0; c < residual.cols(); ++c) sum += residual.rows() - basis_of_column(c).cols();
    return sum;
  }

  const Eigen::MatrixXcd& basis_of_column(Eigen::Index c) const { return bases[weights.empty() ? 0 : static_cast<std::size_t>(c)]; }

  Eigen::MatrixXcd scale(const Eigen::MatrixXcd& terms) const {
    return row_scale.cwiseInverse().asDiagonal() * terms * column_scale.cwiseInverse().asDiagonal();
  }
  /// W⁻¹ of scaled terms, of the first columns.
  Eigen::MatrixXcd weigh(Eigen::MatrixXcd terms) const {
    for (std::size_t c = 0; c < weights.size() && at(c) < terms.cols(); ++c) dense::solve_lower(weights[c], terms.middleCols(at(c), 1));
    return terms;
  }
  /// What the joint's columns explain of weighed terms, and what they do not.
  Eigen::MatrixXcd spanned(const Eigen::MatrixXcd& terms) const {
    if (weights.empty()) return bases.front() * (bases.front().adjoint() * terms);
    Eigen::MatrixXcd out(terms.rows(), terms.cols());
    for (Eigen::Index c = 0; c < terms.cols(); ++c) out.col(c) = basis_of_column(c) * (basis_of_column(c).adjoint() * terms.col(c));
    return out;
  }
  Eigen::MatrixXcd projected(const Eigen::MatrixXcd& terms) const { return terms - spanned(terms); }

 private:
  static Indices assembly_columns(const SpanSetup& setup) {
    Indices columns = setup.assembly_columns;
    columns.insert(columns.end(), setup.outer_columns.begin(), setup.outer_columns.end());
    return columns;
  }

  /// Row and column scales from squared sizes of the elements, and the basis of the joint's columns in them.
  void scale_to(const Eigen::MatrixXd& size) {
    column_scale = (size.colwise().mean().array() + 1e-300).sqrt().transpose();
    row_scale = ((size * column_scale.cwiseAbs2().cwiseInverse()).array() / static_cast<double>(size.cols()) + 1e-300).sqrt();
    bases = {basis_of(row_scale.cwiseInverse().asDiagonal() * joint)};
  }

  /// W of every column: what the errors of the assembly's FRFs, of the part's own and of those to the joint's coordinates, times the
  /// forces there, make of the difference. No weights where some column's are no covariance.
  void weigh(const SpanSetup& setup, const std::vector<CheckedFile>& files, std::size_t line) {
    const Eigen::VectorXcd row = row_scale.cwiseInverse().cast<std::complex<double>>();
    const auto scaled = [&](const CheckedFile& file, const Indices& rows, Eigen::Index column) -> Eigen::MatrixXcd {
      return row.asDiagonal() * file.covariance(line, rows, column) * row.asDiagonal();
    };
    const Eigen::MatrixXcd of_joint = row.asDiagonal() * joint;
    const Eigen::MatrixXd forces = dense::ComplexMinimumNorm(of_joint).solve(scale(assembly - part)).cwiseAbs2();
    std::vector<Eigen::MatrixXcd> joint_errors, found;
    for (const Eigen::Index j : setup.joint) joint_errors.push_back(scaled(files[setup.part], setup.part_rows, j));
    const Indices columns = assembly_columns(setup);
    for (std::size_t c = 0; c < columns.size(); ++c) {
      Eigen::MatrixXcd sum = scaled(files[setup.assembly], setup.assembly_rows, columns[c]);
      if (c < setup.part_columns.size()) sum += scaled(files[setup.part], setup.part_rows, setup.part_columns[c]);
      sum /= column_scale[at(c)] * column_scale[at(c)];
      for (std::size_t j = 0; j < joint_errors.size(); ++j) sum += forces(at(j), at(c)) * joint_errors[j];
      sum.diagonal().array() += least_square;
      if (!dense::cholesky_in_place(sum)) return;
      const double mean = sum.diagonal().real().array().log().mean();
      if (!std::isfinite(mean)) return;
      found.emplace_back(sum.triangularView<Eigen::Lower>());
      found.back() /= std::exp(mean);
    }
    weights = std::move(found);
    bases.clear();
    for (const Eigen::MatrixXcd& weight : weights) {
      Eigen::MatrixXcd weighed = of_joint;
      dense::solve_lower(weight, weighed);
      bases.push_back(basis_of(weighed));
    }
  }
};

/// Collects what SpanTest says of rows.
class RowSums {
 public:
  explicit RowSums(std::size_t rows) : freed_(rows), excess_(rows) {}

  void add(const SpanLine& line, double weight) {
    const Eigen::MatrixXcd assembly = line.scale(line.assembly);
    total_ += weight * line.residual.squaredNorm();
    if (columns_.size() == 0) columns_ = Eigen::VectorXd::Zero(line.residual.cols());
    columns_ += weight * line.residual.colwise().squaredNorm().transpose();
    for (std::size_t k = 0; k < freed_.size(); ++k) {
      const auto r = at(k);
      double slope = 0.0, square = 0.0;
      for (Eigen::Index c = 0; c < assembly.cols(); ++c) {
        const auto [moved, left] = freed(line, r, c);
        freed_[k] += weight * std::norm(moved) / left;
        slope -= weight * (std::conj(moved) * assembly(r, c)).real();
        square += weight * left * std::norm(assembly(r, c));
      }
      excess_[k].add(slope, square);
    }
  }

  void finish(SpanTest& out) const {
    out.column.assign(columns_.begin(), columns_.end());
    for (std::size_t k = 0; k < freed_.size(); ++k) {
      const SlopeFit& excess = excess_[k];
      out.share.push_back(total_ > 0.0 ? freed_[k] / total_ : 0.0);
      out.gain.push_back(excess.is_told() ? 1.0 + excess.value() : 1.0);
      out.deviation.push_back(excess.is_told() ? excess.scatter() / excess.square() : 0.0);
      out.freedom.push_back(excess.freedom());
    }
  }

 private:
  struct Freed {
    std::complex<double> moved;  ///< uᴴ times the residual
    double left;                 ///< |u|²
  };

  /// u: what is left of row r alone, weighed and with the joint's columns taken out.
  static Freed freed(const SpanLine& line, Eigen::Index r, Eigen::Index c) {
    const Eigen::MatrixXcd& basis = line.basis_of_column(c);
    if (line.weights.empty()) return {line.residual(r, c), std::max(1.0 - basis.row(r).squaredNorm(), 1e-9)};
    Eigen::MatrixXcd u = Eigen::MatrixXcd::Zero(line.residual.rows(), 1);
    u(r, 0) = 1.0;
    dense::solve_lower(line.weights[static_cast<std::size_t>(c)], u);
    const double whole = u.squaredNorm();
    u -= (basis * (basis.adjoint() * u)).eval();
    return {u.col(0).dot(line.residual.col(c)), std::max(u.squaredNorm(), 1e-9 * whole)};
  }

  std::vector<double> freed_;
  std::vector<SlopeFit> excess_;
  Eigen::VectorXd columns_;
  double total_ = 0.0;
};

void add_ratio(const SpanLine& line, const SpanSetup& setup, double frequency_hz, SpanTest& out) {
  const auto inner = at(setup.part_columns.size());
  if (inner == 0) return;
  const Eigen::MatrixXcd a = line.projected(line.weigh(line.scale(line.assembly).leftCols(inner)));
  const Eigen::MatrixXcd p = line.projected(line.weigh(line.scale(line.part).leftCols(inner)));
  const std::complex<double> cross = p.conjugate().cwiseProduct(a).sum();
  const double of_a = a.squaredNorm(), of_p = p.squaredNorm();
  if (!(of_a > 0.0 && of_p > 0.0)) return;
  out.ratio.push_back(cross / std::abs(cross) * std::sqrt(of_a / of_p));
  out.coherence.push_back(std::norm(cross) / (of_a * of_p));
  out.ratio_hz.push_back(frequency_hz);
}

struct Roles {
  const Dofs& rows;
  const Dofs& columns;
};

Roles roles(const CheckedFile& file, bool transposed) {
  return transposed ? Roles{file.references, file.responses} : Roles{file.responses, file.references};
}

bool other_part_has(const std::vector<CheckedFile>& files, const frf::Dof& dof, bool transposed) {
  for (const CheckedFile& file : files) {
    if (!file.assembly && place_of(roles(file, transposed).columns, dof) != frf::npos) return true;
  }
  return false;
}

std::optional<SpanSetup> span_setup(const std::vector<CheckedFile>& files, std::size_t part, std::size_t assembly,
                                    bool transposed, const Dofs& joint, const Dofs& elsewhere) {
  SpanSetup setup{.part = part,
                  .assembly = assembly,
                  .transposed = transposed,
                  .rows = {},
                  .part_rows = {},
                  .assembly_rows = {},
                  .part_columns = {},
                  .assembly_columns = {},
                  .outer_columns = {},
                  .joint = {},
                  .weighed = !transposed && files[part].errors && files[assembly].errors};
  const Roles p = roles(files[part], transposed), a = roles(files[assembly], transposed);
  for (const frf::Dof& dof : joint) {
    const std::size_t at = place_of(p.columns, dof);
    if (at != frf::npos) {
      setup.joint.push_back(jointid::at(at));
    } else if (place_of(p.rows, dof) != frf::npos) {
      return std::nullopt;  // forces at the joint whose FRFs were not measured
    }
  }
  for (std::size_t i = 0; i < a.rows.size(); ++i) {
    const std::size_t at = place_of(p.rows, a.rows[i]);
    if (at == frf::npos) continue;
    setup.rows.push_back(a.rows[i]);
    setup.part_rows.push_back(jointid::at(at));
    setup.assembly_rows.push_back(jointid::at(i));
  }
  for (std::size_t i = 0; i < a.columns.size(); ++i) {
    const std::size_t at = place_of(p.columns, a.columns[i]);
    if (at != frf::npos) {
      setup.part_columns.push_back(jointid::at(at));
      setup.assembly_columns.push_back(jointid::at(i));
    } else if (place_of(p.rows, a.columns[i]) == frf::npos &&
               (place_of(elsewhere, a.columns[i]) != frf::npos || other_part_has(files, a.columns[i], transposed))) {
      setup.outer_columns.push_back(jointid::at(i));
    }
  }
  const bool is_test = !setup.joint.empty() && setup.rows.size() > setup.joint.size() &&
                       setup.part_columns.size() + setup.outer_columns.size() > 0;
  return is_test ? std::optional(setup) : std::nullopt;
}

}  // namespace

std::vector<SpanSetup> span_setups(const std::vector<CheckedFile>& files, const Dofs& joint, const Dofs& elsewhere) {
  std::vector<SpanSetup> setups;
  for (std::size_t p = 0; p < files.size(); ++p) {
    for (std::size_t a = 0; a < files.size(); ++a) {
      if (files[p].assembly || !files[a].assembly) continue;
      for (const bool transposed : {false, true}) {
        if (auto setup = span_setup(files, p, a, transposed, joint, elsewhere)) setups.push_back(std::move(*setup));
      }
    }
  }
  return setups;
}

SpanTest span_test(const SpanSetup& setup, const std::vector<CheckedFile>& files, SpanDetail detail) {
  SpanTest out;
  SpanLine line;
  RowSums sums(setup.rows.size());
  double logs = 0.0;
  for (std::size_t l = 0; l < files[setup.part].frfs.size(); ++l) {
    if (detail == SpanDetail::residuals) out.residuals.emplace_back();
    line.load(setup, files, l);
    if (!line.is_complete()) continue;
    line.project(setup, files, l, detail != SpanDetail::level);
    const auto freedom = static_cast<double>(line.freedom());
    const double square = line.square / freedom + least_square;
    logs += std::log(square);
    ++out.lines;
    if (detail == SpanDetail::rows) {
      sums.add(line, 1.0 / square);
      add_ratio(line, setup, files[setup.part].frequency_hz[l], out);
    }
    if (detail == SpanDetail::residuals) out.residuals.back() = line.residual / std::sqrt(square);
  }
  out.level = out.lines > 0 ? std::exp(0.5 * logs / static_cast<double>(out.lines)) : 0.0;
  if (detail == SpanDetail::rows) sums.finish(out);
  return out;
}

}  // namespace jointid::ident
