#include "ident/admissible/eigenfrequencies.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/complex.hpp"
#include "base/eigen.hpp"
#include "dense/eigen.hpp"
#include "dense/lu.hpp"
#include "ident/admissible/passive_band.hpp"
#include "ident/admissible/tie.hpp"
#include "ident/scene/scene_failure.hpp"

namespace jointid::ident {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr const char* frequencies_key = "[identify] frequencies";

/// The three lines nearest to a frequency, ascending; fewer where there are not so many.
std::vector<std::size_t> nearest_lines(const std::vector<double>& axis, double hz) {
  std::vector<std::size_t> lines(axis.size());
  std::iota(lines.begin(), lines.end(), std::size_t{0});
  const std::size_t count = std::min<std::size_t>(3, lines.size());
  std::ranges::partial_sort(lines, lines.begin() + std::ptrdiff_t(count),
                            [&](std::size_t a, std::size_t b) { return std::abs(axis[a] - hz) < std::abs(axis[b] - hz); });
  lines.resize(count);
  std::ranges::sort(lines);
  return lines;
}

/// Re H_bb⁻¹ at a frequency: Lagrange's polynomial over ω² through the lines nearest to it.
MatrixXd part_stiffness(const Plan& plan, double hz) {
  const std::vector<frf::Dof>& joint = plan.coordinates.joint;
  frf::FrfSystem& parts = *plan.substructures;
  const std::vector<std::size_t> lines = nearest_lines(parts.frequency_hz(), hz);
  const Index n = at(joint.size());
  std::vector<Complex> values(lines.size() * joint.size() * joint.size());
  frf::BlockReader(parts, joint, joint).read(lines, values);
  MatrixXd out = MatrixXd::Zero(n, n);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const Eigen::Map<const RowMatrixXc> h(values.data() + i * joint.size() * joint.size(), n, n);
    const double own = parts.frequency_hz()[lines[i]];
    const MatrixXd stiffness = h.allFinite() ? MatrixXd(dense::ComplexLu(h).inverse().real()) : MatrixXd::Constant(1, 1, NAN);
    if (!stiffness.allFinite()) {
      fail(plan.scene, frequencies_key,
           "the substructures have no invertible FRFs between all joint coordinates at " + plain_number(own) + " Hz, near " +
               plain_number(hz) + " Hz",
           "measure them there, or leave that frequency out");
    }
    double weight = 1.0;
    for (const std::size_t other : lines) {
      const double there = parts.frequency_hz()[other];
      if (other != lines[i]) weight *= (hz * hz - there * there) / (own * own - there * there);
    }
    out += weight * stiffness;
  }
  return 0.5 * (out + out.transpose());
}

}  // namespace

void require_frequencies(const Plan& plan) {
  const std::vector<double>& stated = plan.scene.identify.frequencies_hz;
  if (stated.empty()) return;
  if (traits(plan.scene.identify.method).iterates) {
    fail(plan.scene, frequencies_key,
         "eigenfrequencies of the assembly are conditions of the linear methods, not of " +
             traits(plan.scene.identify.method).phrase,
         "use method \"one\", \"two\" or \"direct\", or leave frequencies out");
  }
  const std::vector<double>& axis = plan.substructures->frequency_hz();
  for (const double hz : stated) {
    if (hz >= axis.front() && hz <= axis.back()) continue;
    fail(plan.scene, frequencies_key,
         plain_number(hz) + " Hz is outside the lines of the substructures, " + frf::range_text(axis),
         "leave that frequency out");
  }
  for (const frf::Dof& dof : plan.coordinates.joint) {
    for (const auto* role : {&plan.substructures->responses(), &plan.substructures->references()}) {
      if (frf::find_coordinate(*role, dof) != frf::npos) continue;
      fail(plan.scene, frequencies_key,
           dof.name() + " is no " + (role == &plan.substructures->responses() ? "response" : "reference") +
               " of the substructures, whose FRFs between all joint DOFs are needed",
           "measure there, or leave frequencies out");
    }
  }
}

Eigenfrequencies::Eigenfrequencies(const Plan& plan) {
  for (const double hz : plan.scene.identify.frequencies_hz)
    modes_.push_back({hz, part_stiffness(plan, hz), joint_at(plan.restriction, *plan.columns, plan.omega0, angular(hz))});
}

void Eigenfrequencies::add_condition(const Mode& mode, const VectorXd& theta, MatrixXd& rows, VectorXd& values, Index row) const {
  const MatrixXd z = mode.joint.at({theta.data(), static_cast<std::size_t>(theta.size())}).real();
  const MatrixXd whole = mode.stiffness + 0.5 * (z + z.transpose());
  const VectorXd scale = whole.diagonal().cwiseAbs().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const dense::SymmetricEigen eigen = dense::symmetric_eigen(scale.asDiagonal() * whole * scale.asDiagonal());
  Index nearest = 0;
  eigen.values.cwiseAbs().minCoeff(&nearest);
  const VectorXd motion = scale.cwiseProduct(eigen.vectors.col(nearest));
  const Eigen::VectorXcd complex = motion.cast<Complex>();
  std::vector<Complex> slopes(mode.joint.columns().size());
  mode.joint.sensitivity(complex.data(), complex.data(), slopes.data());
  for (std::size_t t = 0; t < slopes.size(); ++t) rows(row, at(mode.joint.columns()[t])) = slopes[t].real();
  values[row] = rows.row(row).dot(theta) - motion.dot(whole * motion);
}

AdmissibleFit Eigenfrequencies::nearest(const AdmissibleSet* set, const VectorXd& theta, const MatrixXd& root, double unit,
                                        AdmissibleSet& within) const {
  constexpr int most = 50;
  const AdmissibleSet base = set != nullptr ? *set : AdmissibleSet();
  const Index n = theta.size();
  const VectorXd offset = base.offset.size() > 0 ? base.offset : VectorXd(VectorXd::Zero(n));
  const MatrixXd directions = base.directions.size() > 0 ? base.directions : MatrixXd(MatrixXd::Identity(n, n));
  AdmissibleFit out;
  out.theta = theta;
  bool settled = false;
  for (int turn = 0; turn < most && !settled; ++turn) {
    MatrixXd rows = MatrixXd::Zero(at(modes_.size()), n);
    VectorXd values(at(modes_.size()));
    std::vector<Tie> ties;
    for (std::size_t k = 0; k < modes_.size(); ++k) {
      add_condition(modes_[k], out.theta, rows, values, at(k));
      ties.push_back({(rows.row(at(k)) * directions).transpose(), values[at(k)] - rows.row(at(k)).dot(offset)});
    }
    const TiedUnknowns left = eliminate(std::move(ties), directions.cols());
    within = base;
    within.offset = offset + directions * left.offset;
    within.directions = directions * left.directions;
    for (const Mode& mode : modes_) within.ties.push_back(plain_number(mode.frequency_hz) + " Hz is an eigenfrequency");
    const VectorXd before = out.theta;
    out = nearest_admissible(within, theta, root, unit);
    settled = (out.theta - before).cwiseAbs().maxCoeff() <= 1e-10 * out.theta.cwiseAbs().maxCoeff() ||
              (root * (out.theta - before)).norm() <= 1e-5 * unit;
  }
  out.converged = out.converged && settled;
  return out;
}

}  // namespace jointid::ident
