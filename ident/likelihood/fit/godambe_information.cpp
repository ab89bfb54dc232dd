#include "ident/likelihood/fit/godambe_information.hpp"

#include <cmath>
#include <cstdint>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "dense/cholesky.hpp"
#include "dense/eigen.hpp"
#include "minimise/linear/covariance.hpp"

namespace jointid::ident {
namespace {

constexpr double way = 0.3;        // standard deviations to either side
constexpr double noticed = 0.02;   // a relative difference that is worth knowing
constexpr double least_curvature = 0.1, most_curvature = 3.0;  // of the information's curvature: else differences tell none

/// Offsets of one standard deviation: the information is the identity there. Empty where it does not fix all unknowns.
std::optional<Eigen::MatrixXd> unit_of(const Eigen::MatrixXd& information) {
  if (minimise::null_space_of(information).cols() > 0) return std::nullopt;
  return dense::cholesky(minimise::covariance_of(information));
}

std::vector<Eigen::VectorXd> probes_of(Eigen::Index size) {
  std::mt19937_64 random(static_cast<std::uint64_t>(size));
  std::vector<Eigen::VectorXd> probes(3, Eigen::VectorXd(size));
  for (Eigen::VectorXd& direction : probes) {
    for (double& value : direction) value = (random() & 1u) != 0 ? 1.0 : -1.0;
    direction /= std::sqrt(static_cast<double>(size));
  }
  return probes;
}

/// To either side of each direction.
std::vector<Eigen::VectorXd> offsets_along(const std::vector<Eigen::VectorXd>& directions, const Eigen::MatrixXd& unit) {
  std::vector<Eigen::VectorXd> out;
  for (const Eigen::VectorXd& direction : directions) {
    for (const double side : {-1.0, 1.0}) out.emplace_back(unit * (side * way * direction));
  }
  return out;
}

}  // namespace

std::vector<Eigen::VectorXd> first_offsets(const Eigen::MatrixXd& information) {
  const auto unit = unit_of(information);
  return unit ? offsets_along(probes_of(information.rows()), *unit) : std::vector<Eigen::VectorXd>();
}

GradientsAt one_by_one(GradientAt gradient) {
  return [gradient = std::move(gradient)](const std::vector<Eigen::VectorXd>& offsets) {
    std::vector<Eigen::VectorXd> out;
    for (const Eigen::VectorXd& offset : offsets) out.push_back(gradient(offset));
    return out;
  };
}

Eigen::MatrixXd godambe_information(const GradientsAt& gradients, const Eigen::MatrixXd& information, const GradientAt& quick) {
  const auto root = unit_of(information);
  if (!root) return information;
  const Eigen::MatrixXd& unit = *root;
  const auto by_differences = [&unit](const GradientsAt& of, const std::vector<Eigen::VectorXd>& directions) {
    const std::vector<Eigen::VectorXd> there = of(offsets_along(directions, unit));
    std::vector<Eigen::VectorXd> out;
    for (std::size_t k = 0; k < directions.size(); ++k) {
      out.emplace_back(unit.transpose() * (there[2 * k] - there[2 * k + 1]) / (2.0 * way));
    }
    return out;
  };
  const Eigen::Index size = information.rows();
  const std::vector<Eigen::VectorXd> probes = probes_of(size);
  const auto differs = [&probes](double least, const std::vector<Eigen::VectorXd>& differences) {
    for (std::size_t k = 0; k < probes.size(); ++k) {
      if (!(std::abs(probes[k].dot(differences[k]) - 1.0) < least)) return true;
    }
    return false;
  };
  const GradientsAt quick_ones = one_by_one(quick);
  if (quick) {
    const Eigen::VectorXd here = quick(Eigen::VectorXd::Zero(size));
    std::vector<Eigen::VectorXd> to_one_side;
    for (const Eigen::VectorXd& probe : probes) to_one_side.emplace_back(unit.transpose() * (here - quick(unit * (way * probe))) / way);
    if (!differs(0.25 * noticed, to_one_side)) return information;
  }
  if (!differs(noticed, by_differences(quick ? quick_ones : gradients, probes))) return information;
  std::vector<Eigen::VectorXd> units;
  for (Eigen::Index c = 0; c < size; ++c) units.emplace_back(Eigen::VectorXd::Unit(size, c));
  const std::vector<Eigen::VectorXd> columns = by_differences(gradients, units);
  Eigen::MatrixXd curvature(size, size);
  for (Eigen::Index c = 0; c < size; ++c) curvature.col(c) = columns[static_cast<std::size_t>(c)];
  if (!curvature.allFinite()) return information;
  curvature = 0.5 * (curvature + curvature.transpose()).eval();
  const Eigen::VectorXd values = dense::symmetric_eigenvalues(curvature);
  if (!(values[0] > least_curvature && values[size - 1] < most_curvature)) return information;
  Eigen::MatrixXd half = Eigen::MatrixXd::Identity(size, size);
  dense::solve_lower(unit, half);  // unit⁻¹
  return half.transpose() * (curvature * curvature) * half;
}

}  // namespace jointid::ident
