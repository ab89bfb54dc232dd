#include "impedance/line/closed_forms.hpp"

#include <limits>

#include "dense/cholesky.hpp"
#include "dense/lu.hpp"
#include "dense/minimum_norm.hpp"
#include "dense/svd.hpp"

namespace jointid::impedance {
namespace {

using Matrix = Eigen::MatrixXcd;
using Index = Eigen::Index;
using Places = std::vector<Index>;

/// Of (10): both systems, over all coordinates of the line.
struct FirstOrder {
  Matrix a_sub, b_sub, a_asm, b_asm;  ///< [T' × S], [S × T']
};

std::size_t count(Index i) { return static_cast<std::size_t>(i); }

Places range(std::size_t first, std::size_t last) {
  Places out;
  for (std::size_t i = first; i < last; ++i) out.push_back(at(i));
  return out;
}
Places others_of(const LineBlocks& line) { return range(0, line.others); }
Places joint_of(const LineBlocks& line) { return range(line.others, line.others + line.joint); }

Matrix pick(const Matrix& from, const Places& rows, const Places& columns) {
  Matrix out(at(rows.size()), at(columns.size()));
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (std::size_t c = 0; c < columns.size(); ++c) out(at(r), at(c)) = from(rows[r], columns[c]);
  }
  return out;
}

/// M E_R: the columns of M at the places R of all coordinates.
Matrix at_places(const Matrix& m, const Places& places, const LineBlocks& line) {
  Matrix out = Matrix::Zero(m.rows(), line.substructures.cols());
  for (std::size_t i = 0; i < places.size(); ++i) out.col(places[i]) += m.col(at(i));
  return out;
}

/// (11): δz of every error of the line, then its covariance.
Eigen::MatrixXd covariance_of(const LineBlocks& line, const FirstOrder& d) {
  const Index size = d.a_sub.rows(), values = size * (size + 1) / 2;
  Matrix jacobian(values, at(line.frfs.size()));
  for (std::size_t e = 0; e < line.frfs.size(); ++e) {
    const auto& [p, q, of_assembly] = line.frfs[e];
    const Matrix &a = of_assembly ? d.a_asm : d.a_sub, &b = of_assembly ? d.b_asm : d.b_sub;
    Matrix change = a.col(p) * b.row(q);
    if (p != q) change += a.col(q) * b.row(p);
    if (of_assembly) change = -change;
    jacobian.col(at(e)) = triangle_of(0.5 * (change + change.transpose()));
  }
  const Matrix errors = errors_of(jacobian, line.errors);
  Eigen::MatrixXd parts(2 * values, errors.cols());
  parts << errors.real(), errors.imag();
  return parts * parts.transpose();
}

LineValue value_of(const LineBlocks& line, const Matrix& z, const FirstOrder& d) {
  LineValue out;
  out.z = triangle_of(0.5 * (z + z.transpose()));
  out.covariance = covariance_of(line, d);
  return out;
}

FirstOrder squares(Matrix a_sub, Matrix a_asm) {
  Matrix b_sub = a_sub.transpose(), b_asm = a_asm.transpose();
  return {std::move(a_sub), std::move(b_sub), std::move(a_asm), std::move(b_asm)};
}

bool has_jj(const LineBlocks& line) {
  const Places j = joint_of(line);
  return is_known(line.known_substructures, j, j) && is_known(line.known_assembly, j, j);
}

/// Coordinates away from the joint all of whose FRFs with `beside`, and with each other where `among`, both systems have.
Places complete_others(const LineBlocks& line, bool among) {
  const Places j = joint_of(line);
  Places out;
  for (const Index k : others_of(line)) {
    Places with = among ? out : Places();
    if (among) with.push_back(k);
    const bool jk = is_known(line.known_substructures, j, {k}) && is_known(line.known_assembly, j, {k});
    if (jk && is_known(line.known_substructures, with, {k})) out.push_back(k);
  }
  return out;
}

/// (6) over rows R and columns C.
std::optional<LineValue> extended_over(const LineBlocks& line, const Places& rows, const Places& columns) {
  const Places j = joint_of(line);
  if (rows.size() < j.size() || columns.size() < j.size()) return std::nullopt;
  const Matrix asm_rj = pick(line.assembly, rows, j), sub_jc = pick(line.substructures, j, columns);
  const Matrix p = dense::ComplexMinimumNorm(asm_rj).pseudo_inverse(), q = dense::ComplexMinimumNorm(sub_jc).pseudo_inverse();
  const Matrix found = p * (pick(line.substructures, rows, columns) - pick(line.assembly, rows, columns)) * q;
  const Matrix z = 0.5 * (found + found.transpose());
  FirstOrder d;
  d.a_sub = at_places(p, rows, line) - at_places(p * asm_rj * z, j, line);
  d.b_sub = at_places(q.transpose(), columns, line).transpose();
  d.a_asm = at_places(p, rows, line);
  d.b_asm = (at_places(q.transpose(), columns, line) + at_places((z * sub_jc * q).transpose(), j, line)).transpose();
  return value_of(line, z, d);
}

}  // namespace

Basis symmetric_basis(std::size_t size) {
  Basis out;
  const Index n = at(size);
  for (Index r = 0; r < n; ++r) {
    for (Index c = r; c < n; ++c) {
      out.push_back(Eigen::MatrixXd::Zero(n, n));
      out.back()(r, c) = out.back()(c, r) = 1.0;
    }
  }
  return out;
}

Matrix matrix_of(const Basis& basis, const Eigen::VectorXcd& z) {
  Matrix out = Matrix::Zero(basis.front().rows(), basis.front().cols());
  for (std::size_t t = 0; t < basis.size(); ++t) out += z(at(t)) * basis[t];
  return out;
}

Eigen::VectorXcd triangle_of(const Matrix& z) {
  Eigen::VectorXcd out(z.rows() * (z.rows() + 1) / 2);
  Index t = 0;
  for (Index r = 0; r < z.rows(); ++r) {
    for (Index c = r; c < z.cols(); ++c) out(t++) = z(r, c);
  }
  return out;
}

std::optional<LineValue> primal(const LineBlocks& line) {
  if (!has_jj(line)) return std::nullopt;
  const Places j = joint_of(line);
  const Matrix zs = dense::inverse(line.y_substructures()), za = dense::inverse(line.y_assembly());
  return value_of(line, za - zs, squares(at_places(zs, j, line), at_places(za, j, line)));
}

std::optional<LineValue> average(const LineBlocks& line, const Eigen::MatrixXd& t) {
  if (!has_jj(line)) return std::nullopt;
  const Places j = joint_of(line);
  const Matrix half = (0.5 * t.transpose()).cast<Complex>();
  const Matrix zs = half * dense::inverse(line.y_substructures()), za = half * dense::inverse(line.y_assembly());
  return value_of(line, (za - zs) * half.transpose(), squares(at_places(zs, j, line), at_places(za, j, line)));
}

std::optional<LineValue> off_diagonal(const LineBlocks& line, const Eigen::MatrixXd& t) {
  const Places j = joint_of(line);
  if (!is_known(line.known_assembly, j, j)) return std::nullopt;
  const Matrix za = dense::inverse(line.y_assembly());
  const Matrix first = t.cwiseMax(0.0).transpose().cast<Complex>(), second = (-t).cwiseMax(0.0).cast<Complex>();
  FirstOrder d;
  d.a_asm = at_places(-(first * za), j, line);
  d.b_asm = at_places((za * second).transpose(), j, line).transpose();
  d.a_sub = Matrix::Zero(d.a_asm.rows(), d.a_asm.cols());
  d.b_sub = Matrix::Zero(d.b_asm.rows(), d.b_asm.cols());
  return value_of(line, -(first * za * second), d);
}

std::optional<LineValue> relative(const LineBlocks& line, const Eigen::MatrixXd& t) {
  if (!has_jj(line)) return std::nullopt;
  const Places j = joint_of(line);
  const Matrix tc = t.cast<Complex>();
  const Matrix rs = dense::inverse(tc.transpose() * line.y_substructures() * tc);
  const Matrix ra = dense::inverse(tc.transpose() * line.y_assembly() * tc);
  return value_of(line, ra - rs, squares(at_places(rs * tc.transpose(), j, line), at_places(ra * tc.transpose(), j, line)));
}

std::optional<LineValue> extended(const LineBlocks& line) {
  if (!has_jj(line)) return std::nullopt;
  Places all = complete_others(line, true);
  for (const Index place : joint_of(line)) all.push_back(place);
  return extended_over(line, all, all);
}

std::optional<LineValue> from_nj(const LineBlocks& line) {
  const Places j = joint_of(line);
  if (!is_known(line.known_substructures, j, j)) return std::nullopt;
  return extended_over(line, complete_others(line, false), j);
}

std::optional<LineValue> from_nn(const LineBlocks& line, const Eigen::MatrixXd& t) {
  const Places j = joint_of(line), n = others_of(line);
  if (n.size() < count(t.cols()) || !is_known(line.known_substructures, n, n) || !is_known(line.known_substructures, j, n) ||
      !is_known(line.known_substructures, j, j)) {
    return std::nullopt;
  }
  const Matrix tc = t.cast<Complex>();
  const Matrix u = pick(line.substructures, n, j) * tc, h = tc.transpose() * line.y_substructures() * tc;
  const dense::ComplexMinimumNorm factors(u);
  if (factors.rank() < u.cols()) return std::nullopt;
  const Matrix p = factors.pseudo_inverse(), identity = Matrix::Identity(h.rows(), h.cols());
  const Matrix w = p * pick(line.substructures, n, n) * p.transpose();  // H_sub − H_asm there
  const Matrix z = w * dense::inverse(identity - h * w), f = identity + z * h;
  const Matrix difference = at_places(f * p, n, line);
  return value_of(line, z, squares(difference - at_places(f * p * u * w * tc.transpose(), j, line), difference));
}

std::optional<Matrix> joint_receptance(const LineBlocks& line) {
  if (!has_jj(line)) return std::nullopt;
  const Matrix ya = line.y_assembly();
  return ya - ya * dense::solve(ya - line.y_substructures(), ya);
}

std::optional<LineValue> weighed(const LineValue& from, const Basis& basis) {
  const Index rows = from.z.size(), t = at(basis.size());
  Eigen::MatrixXd design(rows, t);
  for (Index k = 0; k < t; ++k) design.col(k) = triangle_of(basis[count(k)].cast<Complex>()).real();
  const Eigen::VectorXd scale = from.covariance.diagonal().cwiseSqrt();
  if (!(scale.minCoeff() > 0.0) || !scale.allFinite()) return std::nullopt;
  const Eigen::MatrixXd unit = scale.cwiseInverse().asDiagonal() * from.covariance * scale.cwiseInverse().asDiagonal();
  const auto lower = dense::cholesky(unit);
  if (!lower) return std::nullopt;
  Eigen::MatrixXd d = Eigen::MatrixXd::Zero(2 * rows, 2 * t), r(2 * rows, 1);
  d.topLeftCorner(rows, t) = d.bottomRightCorner(rows, t) = design;
  r << from.z.real(), from.z.imag();
  d = scale.cwiseInverse().asDiagonal() * d;
  r = scale.cwiseInverse().asDiagonal() * r;
  dense::solve_lower(*lower, d);
  dense::solve_lower(*lower, r);
  const Eigen::VectorXd size = d.colwise().norm();
  const Eigen::MatrixXd scaled = d * size.cwiseInverse().asDiagonal();
  const Eigen::MatrixXd normal = scaled.transpose() * scaled;
  const auto solved = dense::solve_definite(normal, scaled.transpose() * r.col(0));
  if (!solved) return std::nullopt;
  const Eigen::VectorXd x = size.cwiseInverse().asDiagonal() * solved->x;
  LineValue out;
  out.z = x.head(t) + Complex(0.0, 1.0) * x.tail(t);
  const Eigen::MatrixXd inverse = dense::solve_positive(normal, Eigen::MatrixXd::Identity(2 * t, 2 * t));
  out.covariance = size.cwiseInverse().asDiagonal() * inverse * size.cwiseInverse().asDiagonal();
  out.chi_square = (r.col(0) - d * x).squaredNorm();
  out.freedom = 2.0 * static_cast<double>(rows - t);
  return out;
}

double condition_of(const Matrix& matrix) {
  const Eigen::VectorXd sigma = dense::svd(matrix, dense::Vectors::none, dense::Vectors::none).sigma;
  const double least = sigma(sigma.size() - 1);
  return least > 0.0 ? sigma(0) / least : std::numeric_limits<double>::infinity();
}

}  // namespace jointid::impedance
