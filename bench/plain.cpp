#include "bench/plain.hpp"

#include <Eigen/QR>

namespace jointid::bench {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

constexpr Index joint = 4;

/// T of a symmetric K and D: 2·16 elements of {k, d} from 20 unknowns.
MatrixXd restriction() {
  MatrixXd t = MatrixXd::Zero(2 * joint * joint, joint * (joint + 1));
  Index unknown = 0;
  for (Index matrix = 0; matrix < 2; ++matrix) {
    for (Index i = 0; i < joint; ++i) {
      for (Index j = i; j < joint; ++j, ++unknown) {
        t(matrix * joint * joint + i * joint + j, unknown) = 1.0;
        t(matrix * joint * joint + j * joint + i, unknown) = 1.0;
      }
    }
  }
  return t;
}

MatrixXcd matrix_at(const frf::FrfSet& set, std::size_t line, const std::vector<frf::Dof>& rows,
                    const std::vector<frf::Dof>& columns) {
  MatrixXcd h = MatrixXcd::Zero(static_cast<Index>(rows.size()), static_cast<Index>(columns.size()));
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const std::size_t response = frf::find_coordinate(set.header.response, rows[r]);
    if (response == frf::npos) continue;
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const std::size_t reference = frf::find_coordinate(set.header.reference, columns[c]);
      if (reference == frf::npos) continue;
      h(static_cast<Index>(r), static_cast<Index>(c)) = set.values[set.index(line, response, reference)];
    }
  }
  return h;
}

}  // namespace

std::vector<double> solve_plainly(const problems::Measurement& measurement, DenseQr qr) {
  static const MatrixXd t = restriction();
  const frf::FrfSet& assembly = measurement.assembly;
  std::vector<frf::Dof> joint_dofs = {frf::Dof::parse("4:+Y"), frf::Dof::parse("4:+RZ"), frf::Dof::parse("5:+Y"),
                                      frf::Dof::parse("5:+RZ")};
  std::vector<frf::Dof> all;
  for (const frf::Dof& dof : assembly.header.response) {
    if (frf::find_coordinate(joint_dofs, dof) == frf::npos) all.push_back(dof);
  }
  const Index n = static_cast<Index>(all.size());
  all.insert(all.end(), joint_dofs.begin(), joint_dofs.end());
  const Index columns = n + joint, equations = n * columns;
  const Index lines = static_cast<Index>(assembly.header.lines());
  MatrixXd stacked(2 * equations * lines, t.cols());
  VectorXd right(2 * equations * lines);
  for (Index line = 0; line < lines; ++line) {
    const std::size_t at = static_cast<std::size_t>(line);
    MatrixXcd sub = MatrixXcd::Zero(columns, columns);
    for (const frf::FrfSet& set : measurement.substructures) sub += matrix_at(set, at, all, all);
    const MatrixXcd h = matrix_at(assembly, at, all, all);
    const MatrixXcd a = h.topRightCorner(n, joint), b = sub.bottomRows(joint), c = sub.topRows(n) - h.topRows(n);
    MatrixXcd e(equations, joint * joint);
    VectorXcd g(equations);
    for (Index m = 0; m < n; ++m) {
      for (Index l = 0; l < columns; ++l) {
        for (Index p = 0; p < joint; ++p) {
          for (Index q = 0; q < joint; ++q) e(m * columns + l, p * joint + q) = a(m, p) * b(q, l);
        }
        g[m * columns + l] = c(m, l);
      }
    }
    MatrixXcd et(equations, 2 * joint * joint);
    et << e, std::complex<double>(0.0, 1.0) * e;
    const MatrixXcd e1 = et * t;
    MatrixXd e0(2 * equations, t.cols());
    e0 << e1.real(), e1.imag();
    const double alpha = 1.0 / e0.colwise().norm().maxCoeff();
    stacked.middleRows(2 * equations * line, 2 * equations) = alpha * e0;
    right.segment(2 * equations * line, equations) = alpha * g.real();
    right.segment(2 * equations * line + equations, equations) = alpha * g.imag();
  }
  const VectorXd y = qr == DenseQr::pivoted ? VectorXd(stacked.colPivHouseholderQr().solve(right))
                                            : VectorXd(stacked.householderQr().solve(right));
  return {y.begin(), y.end()};
}

}  // namespace jointid::bench
