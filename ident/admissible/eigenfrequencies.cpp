#include "ident/admissible/eigenfrequencies.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "base/complex.hpp"
#include "base/eigen.hpp"
#include "base/error.hpp"
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

/// Re H_bb⁻¹ of some lines of the substructures.
std::vector<MatrixXd> stiffnesses_at(const Plan& plan, const std::vector<std::size_t>& lines, double hz) {
  const std::vector<frf::Dof>& joint = plan.coordinates.joint;
  frf::FrfSystem& parts = *plan.substructures;
  const Index n = at(joint.size());
  std::vector<Complex> values(lines.size() * joint.size() * joint.size());
  frf::BlockReader(parts, joint, joint).read(lines, values);
  std::vector<MatrixXd> out;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const Eigen::Map<const RowMatrixXc> h(values.data() + i * joint.size() * joint.size(), n, n);
    out.push_back(h.allFinite() ? MatrixXd(dense::ComplexLu(h).inverse().real()) : MatrixXd::Constant(1, 1, NAN));
    if (out.back().allFinite()) continue;
    fail(plan.scene, frequencies_key,
         "the substructures have no invertible FRFs between all joint coordinates at " +
             plain_number(parts.frequency_hz()[lines[i]]) + " Hz, near " + plain_number(hz) + " Hz",
         "measure them there, or leave that frequency out");
  }
  return out;
}

/// Of Lagrange's polynomial over ω² through some lines, their weights at a frequency.
std::vector<double> weights_at(double hz, const std::vector<std::size_t>& lines, const std::vector<double>& axis) {
  std::vector<double> out;
  for (const std::size_t line : lines) {
    double weight = 1.0;
    for (const std::size_t other : lines) {
      const double own = axis[line], there = axis[other];
      if (other != line) weight *= (hz * hz - there * there) / (own * own - there * there);
    }
    out.push_back(weight);
  }
  return out;
}

MatrixXd symmetric_sum(const std::vector<double>& weights, const std::vector<MatrixXd>& of) {
  MatrixXd sum = MatrixXd::Zero(of.front().rows(), of.front().cols());
  for (std::size_t i = 0; i < weights.size(); ++i) sum += weights[i] * of[i];
  return 0.5 * (sum + sum.transpose());
}

}  // namespace

bool frequencies_are_data(const Scene& scene) {
  const MethodTraits& method = traits(scene.identify.method);
  return scene.identify.loose && !scene.identify.frequencies_hz.empty() && method.iterates && !method.joint_on_assembly;
}

void require_frequencies(const Plan& plan) {
  const std::vector<double>& stated = plan.scene.identify.frequencies_hz;
  if (stated.empty() || frequencies_are_data(plan.scene)) return;
  if (traits(plan.scene.identify.method).iterates) {
    fail(plan.scene, frequencies_key,
         "eigenfrequencies of the assembly are conditions of the linear methods, not of " +
             traits(plan.scene.identify.method).phrase,
         "use method \"one\", \"two\" or \"direct\", \"newton\" with loose = true, or leave frequencies out");
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

Eigenfrequencies::PartStiffness Eigenfrequencies::part_stiffness(const Plan& plan, double hz) {
  constexpr double slightly = 1e-3;  // axes are no better
  const std::vector<double>& axis = plan.substructures->frequency_hz();
  PartStiffness out{.value = {}, .doubts = {}, .lines = nearest_lines(axis, hz), .weights = {}};
  const std::vector<MatrixXd> values = stiffnesses_at(plan, out.lines, hz);
  out.weights = weights_at(hz, out.lines, axis);
  out.value = symmetric_sum(out.weights, values);
  out.doubts.push_back(symmetric_sum(weights_at((1.0 + slightly) * hz, out.lines, axis), values) - out.value);
  if (out.lines.size() < 3) return out;
  const std::size_t first = hz > axis[out.lines[1]] ? 1 : 0;
  const std::vector<std::size_t> two(out.lines.begin() + std::ptrdiff_t(first), out.lines.begin() + std::ptrdiff_t(first + 2));
  out.doubts.push_back(symmetric_sum(weights_at(hz, two, axis), {values[first], values[first + 1]}) - out.value);
  return out;
}

Eigenfrequencies::Eigenfrequencies(const Plan& plan) {
  for (const double hz : plan.scene.identify.frequencies_hz)
    modes_.push_back({hz, part_stiffness(plan, hz), joint_at(plan.restriction, *plan.columns, plan.omega0, angular(hz))});
}

namespace {

/// Empty where conditions contradict each other: two frequencies that a joint on the way has the same motion at.
std::optional<TiedUnknowns> eliminated(std::vector<Tie> ties, Index unknowns) {
  try {
    return eliminate(std::move(ties), unknowns);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace

/// Of the motion nearest to an eigenvector.
FrequencyCondition Eigenfrequencies::condition(const Mode& mode, const VectorXd& theta) {
  const MatrixXd z = mode.joint.at({theta.data(), static_cast<std::size_t>(theta.size())}).real();
  const MatrixXd whole = mode.stiffness.value + 0.5 * (z + z.transpose());
  const VectorXd scale = whole.diagonal().cwiseAbs().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const dense::SymmetricEigen eigen = dense::symmetric_eigen(scale.asDiagonal() * whole * scale.asDiagonal());
  Index nearest = 0;
  eigen.values.cwiseAbs().minCoeff(&nearest);
  FrequencyCondition out{.frequency_hz = mode.frequency_hz,
                         .coefficients = VectorXd::Zero(theta.size()),
                         .motion = scale.cwiseProduct(eigen.vectors.col(nearest)),
                         .lines = mode.stiffness.lines,
                         .weights = mode.stiffness.weights};
  const Eigen::VectorXcd complex = out.motion.cast<Complex>();
  std::vector<Complex> slopes(mode.joint.columns().size());
  mode.joint.sensitivity(complex.data(), complex.data(), slopes.data());
  for (std::size_t t = 0; t < slopes.size(); ++t) out.coefficients[at(mode.joint.columns()[t])] = slopes[t].real();
  out.value = out.coefficients.dot(theta) - out.motion.dot(whole * out.motion);
  for (const MatrixXd& doubt : mode.stiffness.doubts) out.rough = std::hypot(out.rough, out.motion.dot(doubt * out.motion));
  return out;
}

std::vector<FrequencyCondition> Eigenfrequencies::conditions_at(const VectorXd& theta) const {
  std::vector<FrequencyCondition> out;
  for (const Mode& mode : modes_) out.push_back(condition(mode, theta));
  return out;
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
    std::vector<Tie> ties;
    for (const FrequencyCondition& each : conditions_at(out.theta))
      ties.push_back({directions.transpose() * each.coefficients, each.value - each.coefficients.dot(offset)});
    const std::optional<TiedUnknowns> left = eliminated(std::move(ties), directions.cols());
    if (!left) {
      within = base;
      out = nearest_admissible(base, theta, root, unit);
      out.converged = false;
      return out;
    }
    within = base;
    within.offset = offset + directions * left->offset;
    within.directions = directions * left->directions;
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
