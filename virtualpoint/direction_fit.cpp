#include "virtualpoint/direction_fit.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "base/eigen.hpp"
#include "dense/minimum_norm.hpp"
#include "dense/svd.hpp"
#include "virtualpoint/mixture.hpp"

namespace jointid::virtualpoint {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::Vector3d;

constexpr double worth_saying_deg = 5.0;
constexpr double healed = 0.5;

using Rows = std::vector<Index>;

/// FRFs of all lines side by side, each line of norm 1.
MatrixXcd side_by_side(const std::vector<MatrixXcd>& y) {
  Index columns = 0;
  for (const MatrixXcd& line : y) columns += line.cols();
  MatrixXcd all(y.front().rows(), columns);
  Index next = 0;
  for (const MatrixXcd& line : y) {
    const double norm = line.norm();
    all.middleCols(next, line.cols()) = line / (norm > 0.0 ? norm : 1.0);
    next += line.cols();
  }
  return all;
}

bool sees_all(const MatrixXd& modes) {
  constexpr double smallest = 1e-3;
  const MatrixXd scaled = modes * modes.colwise().norm().cwiseMax(1e-300).cwiseInverse().asDiagonal();
  const Eigen::VectorXd sigma = dense::jacobi_svd(scaled, dense::Vectors::none, dense::Vectors::none).sigma;
  return sigma[sigma.size() - 1] > smallest * sigma[0];
}

/// The fit of the modes to some rows.
struct Fit {
  MatrixXd to_virtual;
  double mean_square = 0.0;
};

/// Empty where the rows do not see all modes with one to spare.
std::optional<Fit> fit(const MatrixXd& modes, const MatrixXcd& y, const Rows& rows) {
  const Index spare = static_cast<Index>(rows.size()) - modes.cols();
  const MatrixXd some = modes(rows, Eigen::all);
  if (spare < 1 || !sees_all(some)) return std::nullopt;
  Fit out{weighted_inverse(some, Eigen::VectorXd::Ones(some.rows())), 0.0};
  const MatrixXcd of_rows = y(rows, Eigen::all);
  const MatrixXd filter = some * out.to_virtual;
  out.mean_square = (of_rows - filter.cast<Complex>() * of_rows).squaredNorm() / static_cast<double>(spare);
  return out;
}

/// The direction that makes the motion of the interface at a channel its FRFs.
Vector3d direction_from(const VirtualPoint& point, const Vector3d& r, bool rotational, const MatrixXcd& q, const MatrixXcd& own) {
  MatrixXd of_axes(3, at(point.modes.size()));
  for (Index k = 0; k < 3; ++k) {
    Vector unit{};
    unit[static_cast<std::size_t>(k)] = 1.0;
    of_axes.row(k) = mode_row(point.modes, {r[0], r[1], r[2]}, unit, rotational);
  }
  const MatrixXcd motion = of_axes.cast<Complex>() * q;
  const MatrixXd normal = (motion * motion.adjoint()).real(), right = (motion * own.adjoint()).real();
  return dense::RealMinimumNorm(normal, 1e-12).solve(right);
}

struct Candidate {
  Index row = 0;
  double ratio = 1.0;
  Vector3d direction{};
};

std::optional<Candidate> worst(const VirtualPoint& point, const Transformation& channels, const MatrixXcd& y, const Rows& rows) {
  const auto whole = fit(channels.modes, y, rows);
  if (!whole) return std::nullopt;
  std::optional<Candidate> found;
  for (const Index row : rows) {
    Rows others = rows;
    std::erase(others, row);
    const auto without = fit(channels.modes, y, others);
    if (!without || !(without->mean_square < healed * whole->mean_square)) continue;
    const double ratio = without->mean_square / whole->mean_square;
    if (found && ratio >= found->ratio) continue;
    const MatrixXcd of_others = y(others, Eigen::all);
    const MatrixXcd q = without->to_virtual.cast<Complex>() * of_others;
    const bool rotational = channels.dofs[static_cast<std::size_t>(row)].is_rotation();
    found = Candidate{row, ratio, direction_from(point, channels.positions.row(row).transpose(), rotational, q, y.row(row))};
  }
  return found;
}

Vector unit(const Vector3d& v) {
  const Vector3d of_length_one = v.normalized();
  return {of_length_one[0], of_length_one[1], of_length_one[2]};
}

}  // namespace

std::vector<WrongDirection> wrong_directions(const VirtualPoint& point, Side side, const Transformation& channels,
                                             const std::vector<MatrixXcd>& lines) {
  const MatrixXcd y = side_by_side(lines);
  Rows rows(channels.channels.size());
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = at(i);
  std::vector<WrongDirection> out;
  while (const auto candidate = worst(point, channels, y, rows)) {
    std::erase(rows, candidate->row);
    const Vector3d stated = channels.directions.row(candidate->row).transpose();
    const Vector3d found = channels.signs[candidate->row] * candidate->direction;
    const double cosine = stated.dot(found) / found.norm();
    if (!(std::acos(std::clamp(cosine, -1.0, 1.0)) * 180.0 / std::numbers::pi >= worth_saying_deg)) continue;
    const frf::Dof& dof = channels.dofs[static_cast<std::size_t>(candidate->row)];
    out.push_back({side, dof, unit(stated), unit(found), candidate->ratio});
  }
  return out;
}

}  // namespace jointid::virtualpoint
