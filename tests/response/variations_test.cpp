// What golden/response.json holds, at other laws, parameters, levels, frequencies and structures: each answer by a second route
// that shares no code with the first.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "frf/set/frf_system.hpp"
#include "friction/path/masing_path.hpp"
#include "response/continuation/response_curve.hpp"
#include "response/equivalent/equivalent_mode.hpp"
#include "response/orbit/orbit_figures.hpp"
#include "response/structure/frf_receptance.hpp"
#include "response/structure/matrix_receptance.hpp"
#include "response/time/algorithm_one.hpp"
#include "response/time/algorithm_two.hpp"
#include "response/time/exact_march.hpp"
#include "tests/response/any_joint.hpp"

namespace jointid::response {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Masses in a chain, the first to ground, with eigenfrequencies about those of the golden cases; joints anywhere.
struct AnyAssembly {
  MatrixStructure matrices;
  MatrixXd w;
  std::vector<std::shared_ptr<const friction::Element>> laws;

  explicit AnyAssembly(std::size_t most_joints) {
    const Eigen::Index n = 2 + at(any_of(3));
    matrices = {MatrixXd::Zero(n, n), {}, MatrixXd::Zero(n, n)};
    for (Eigen::Index i = 0; i < n; ++i) {
      matrices.mass(i, i) = any_in(0.7, 1.5);
      const double spring = any_in(150.0, 400.0);
      matrices.stiffness(i, i) += spring;
      if (i == 0) continue;
      matrices.stiffness(i - 1, i - 1) += spring;
      matrices.stiffness(i, i - 1) = matrices.stiffness(i - 1, i) = -spring;
    }
    matrices.damping = any_in(1e-3, 4e-3) * matrices.stiffness;
    w = MatrixXd::Zero(n, 1 + at(any_of(most_joints)));
    for (Eigen::Index j = 0; j < w.cols(); ++j) {
      const Eigen::Index from = j, to = at(any_of(static_cast<std::size_t>(n)));
      w(from, j) = 1.0;
      if (to != from) w(to, j) = -1.0;
      laws.push_back(any_joint());
    }
  }

  /// For what RapidCheck says of a failure.
  std::string text() const {
    std::string all;
    for (const auto& law : laws) all += friction::describe(*law) + "\n";
    return all;
  }

  Eigen::Index size() const { return w.rows(); }
  JointedStructure jointed() const { return {matrices, w, laws}; }
  std::vector<Joint> joints() const {
    std::vector<Joint> all;
    for (const auto& law : laws) all.push_back({.name = "joint", .friction = law});
    return all;
  }
  HarmonicBalance balance(const Excitation& force, std::vector<int> harmonics) const {
    const MatrixXd all = MatrixXd::Identity(size(), size());
    return {std::make_shared<MatrixReceptance>(matrices, w, all, all.leftCols(1)), joints(), force, {.fixed = std::move(harmonics)}};
  }
};

template <class A, class B>
double difference(const A& found, const B& expected) {
  return (found - expected).cwiseAbs().maxCoeff() / expected.cwiseAbs().maxCoeff();
}

/// Harmonic balance, which knows no time, and shooting, which knows no harmonics: as harmonics are added the first comes to the
/// second (X_n of the harmonics left out falls with n⁻⁴).
RC_GTEST_PROP(Variations, HarmonicsComeToTheExactOrbit, ()) {
  const AnyAssembly assembly(2);
  RC_LOG() << assembly.text();
  const double p = any_decade(1.0, 30.0), omega = any_in(6.0, 25.0);
  const PeriodicProblem problem = {assembly.jointed(), omega, {1}, Complex(0.0, -p) * VectorXd::Unit(assembly.size(), 0)};
  const PeriodicOrbit orbit = find_orbit(problem);
  RC_ASSERT(orbit.closed);
  const OrbitFigures exact = figures(problem, orbit, {1, 3, 5});
  const auto error = [&](int largest) {
    const HarmonicSolution found =
        assembly.balance(Excitation::single(Complex(0.0, -p)), Harmonics::odd(largest).numbers()).solve(omega);
    RC_ASSERT(found.converged);
    return difference(Eigen::MatrixXcd(found.response.topRows(3).transpose()), exact.x);
  };
  const double few = error(9), many = error(41);
  RC_LOG() << few << " to " << many << "\n";
  RC_ASSERT(many <= 2e-4);
  RC_ASSERT(many <= std::max(0.2 * few, 1e-7));
}

/// Transients: Algorithm One is of order 2 and shares with exact marching only the laws.
RC_GTEST_PROP(Variations, AlgorithmOneComesToTheExactTransient, ()) {
  const AnyAssembly assembly(2);
  RC_LOG() << assembly.text();
  const Eigen::Index n = assembly.size();
  const ForceHistory force =
      any_of(2) == 0 ? ForceHistory::half_sine(any_decade(3.0, 60.0) * VectorXd::Unit(n, 0), any_in(0.1, 0.5))
                     : ForceHistory::periodic(any_in(6.0, 25.0), {1}, Complex(0.0, -any_decade(1.0, 30.0)) * VectorXd::Unit(n, 0));
  const double duration = 0.8;
  const auto motion = [&](int steps) {
    AlgorithmOne one(assembly.jointed(), force, duration / steps);
    MatrixXd x(n, 8);
    for (int i = 1; i <= steps; ++i) {
      one.step();
      if (i % (steps / 8) == 0) x.col(i / (steps / 8) - 1) = one.motion().x;
    }
    return x;
  };
  ExactMarch march(assembly.jointed(), force);
  MatrixXd exact(n, 8);
  for (int i = 0; i < 8; ++i) {
    RC_ASSERT(march.march(duration / 8.0 * (i + 1)));
    exact.col(i) = march.motion().x;
  }
  const double coarse = difference(motion(400), exact), fine = difference(motion(1600), exact);
  RC_LOG() << coarse << " to " << fine << "\n";
  RC_ASSERT(fine <= 1e-3);
  RC_ASSERT(fine <= 0.15 * coarse);
}

/// The motions of both algorithms in their own equations (R3.22 with β = −½; R3.34), forces by a Masing path of the test's own.
RC_GTEST_PROP(Variations, AlgorithmsMeetTheirEquations, ()) {
  const AnyAssembly assembly(2);
  RC_LOG() << assembly.text();
  const JointedStructure structure = assembly.jointed();
  const Eigen::Index n = assembly.size();
  const double delta = any_decade(1e-3, 1e-2), a = 1.0 / 3.0;
  const ForceHistory force =
      ForceHistory::periodic(any_in(6.0, 25.0), {1}, Complex(0.0, -any_decade(1.0, 30.0)) * VectorXd::Unit(n, 0));
  const MatrixXd &m = structure.matrices.mass, &c = structure.matrices.damping, &k = structure.matrices.stiffness,
                 &w = structure.incidence;
  struct Forces {
    std::vector<friction::MasingPath> paths;
    VectorXd at(const VectorXd& q) {
      VectorXd f(q.size());
      for (Eigen::Index j = 0; j < q.size(); ++j) f[j] = paths[static_cast<std::size_t>(j)].advance(q[j]).force;
      return f;
    }
  };
  Forces one_forces, two_forces;
  for (const auto& law : structure.laws) {
    one_forces.paths.emplace_back(*law);
    two_forces.paths.emplace_back(*law);
  }
  AlgorithmOne one(structure, force, delta);
  AlgorithmTwo two(structure, force, delta);
  VectorXd x = VectorXd::Zero(n), v = x, acceleration = x, two_before = x, two_now = x;
  const MatrixXd reference = w * structure.initial_stiffness().asDiagonal() * w.transpose(), stiff = k + reference;
  for (int i = 1; i <= 100; ++i) {
    const double t = i * delta;
    one.step();
    const VectorXd after = one.motion().x;
    acceleration = (4.0 / (delta * delta) * (after - x) - 4.0 / delta * v - acceleration).eval();
    v = (2.0 / delta * (after - x) - v).eval();
    x = after;
    const VectorXd inertia = m * acceleration, elastic = k * x;
    const VectorXd residual = inertia + c * v + elastic + w * one_forces.at(w.transpose() * x) - force.value(t);
    RC_ASSERT(residual.cwiseAbs().maxCoeff() <= 1e-7 * std::max({inertia.cwiseAbs().maxCoeff(), elastic.cwiseAbs().maxCoeff(), 1.0}));

    two.step();
    const VectorXd next = two.motion().x;
    if (i > 1) {  // the first step is Algorithm One's
      const VectorXd f = two_forces.at(w.transpose() * two_now);
      const VectorXd left = m * (next - 2.0 * two_now + two_before) / (delta * delta) + c * (next - two_before) / (2.0 * delta) +
                            stiff * (a * next + (1.0 - 2.0 * a) * two_now + a * two_before);
      const VectorXd right =
          a * force.value(t) + (1.0 - 2.0 * a) * force.value(t - delta) + a * force.value(t - 2.0 * delta) - w * f + reference * two_now;
      RC_ASSERT((left - right).cwiseAbs().maxCoeff() <= 1e-9 * std::max((m * next).cwiseAbs().maxCoeff() / (delta * delta), 1.0));
    }
    two_before = two_now;
    two_now = next;
  }
}

/// Peaks lie where single solutions beside them say.
TEST(Variations, PeaksAreTheLargestOfSingleSolutions) {
  const auto problems = rc::gen::exec([] { return std::pair(AnyAssembly(1), any_decade(0.5, 10.0)); });
  for (std::uint64_t seed = 1; seed <= draws(10); ++seed) {
    SCOPED_TRACE(seed);
    const auto [assembly, level] = problems(rc::Random(seed), rc::kNominalSize).value();
    const HarmonicBalance balance = assembly.balance(Excitation::single(1.0), {1, 3});
    CurveRequest request = {.along = Along::frequency, .from = 3.0, .to = 12.0};
    request.level = level;
    for (const HarmonicSolution& peak : follow_response(balance, request).peaks) {
      for (const double share : {-1e-5, 1e-5}) {
        const HarmonicSolution beside = balance.solve(peak.omega * (1.0 + share), level, &peak);
        EXPECT_TRUE(beside.converged);
        EXPECT_LT(std::abs(beside.response(0, 0)), std::abs(peak.response(0, 0)) * (1.0 + 1e-12)) << peak.omega;
      }
    }
  }
}

/// (K + W k_e Wᵀ)φ = ω²Mφ with k_e, d_e of the amplitude that φ gives each joint; loss factors from their quadratic forms.
RC_GTEST_PROP(Variations, EquivalentModesSolveTheirEigenproblem, ()) {
  const AnyAssembly assembly(2);
  RC_LOG() << assembly.text();
  const double amplitude = any_decade(1e-3, 0.3);
  const Eigen::Index mode = at(any_of(static_cast<std::size_t>(assembly.size())));
  const EquivalentMode found = equivalent_mode(assembly.matrices, assembly.w, assembly.joints(), mode, 0, amplitude);
  RC_PRE(found.converged);
  const VectorXd q = assembly.w.transpose() * found.motion;
  RC_ASSERT(std::abs(q[0] - amplitude) <= 1e-10 * amplitude);
  VectorXd k_e(q.size()), d_e(q.size());
  for (Eigen::Index j = 0; j < q.size(); ++j) {
    const EquivalentJoint joint = equivalent_joint(assembly.joints()[static_cast<std::size_t>(j)], std::abs(q[j]), found.omega);
    k_e[j] = joint.stiffness;
    d_e[j] = joint.damping;
  }
  const VectorXd inertia = found.omega * found.omega * (assembly.matrices.mass * found.motion);
  const VectorXd elastic = assembly.matrices.stiffness * found.motion + assembly.w * k_e.cwiseProduct(q);
  RC_ASSERT(difference(elastic, inertia) <= 1e-8);
  const double modal = found.motion.dot(inertia);
  RC_ASSERT(std::abs(found.loss_factor_joints - q.dot(d_e.cwiseProduct(q)) / modal) <= 1e-8);
  const double viscous = found.omega * found.motion.dot(assembly.matrices.damping * found.motion) / modal;
  RC_ASSERT(std::abs(found.loss_factor_viscous - viscous) <= 1e-8);
}

/// FRFs of one coordinate after the other as a file has them, at the harmonics of ω.
frf::FrfSet file_of(const MatrixStructure& part, double omega, const std::vector<int>& harmonics, int first_node) {
  frf::FrfSet set;
  const Eigen::Index n = part.mass.rows();
  const MatrixXd all = MatrixXd::Identity(n, n);
  const MatrixReceptance receptance(part, MatrixXd(n, 0), all, all);
  for (Eigen::Index i = 0; i < n; ++i) set.header.response.push_back({first_node + i, frf::Direction::x, 1});
  set.header.reference = set.header.response;
  for (const int harmonic : harmonics) {
    set.header.frequency_hz.push_back(hertz(harmonic * omega));
    const Eigen::MatrixXcd h = receptance.at(harmonic * omega).transpose();  // row by row
    set.values.insert(set.values.end(), h.data(), h.data() + h.size());
  }
  return set;
}

/// Two parts by their FRFs alone, and by the matrices of both.
RC_GTEST_PROP(Variations, FilesOfPartsGiveWhatTheirMatricesGive, ()) {
  const AnyAssembly a(1), b(1);
  const double omega = any_in(6.0, 25.0), p = any_decade(0.5, 30.0);
  const std::vector<int> harmonics = {1, 3, 5, 7, 9};
  const auto node = [](Eigen::Index i) { return frf::Dof{i + 1, frf::Direction::x, 1}; };
  const Eigen::Index size = a.size() + b.size();
  std::vector<frf::Dof> all;
  for (Eigen::Index i = 0; i < size; ++i) all.push_back(node(i));
  const auto files = frf::memory_system(
      "parts", {file_of(a.matrices, omega, harmonics, 1), file_of(b.matrices, omega, harmonics, 1 + static_cast<int>(a.size()))},
      frf::Composition::uncoupled);
  const auto measured = std::make_shared<FrfReceptance>(*files, std::vector<JointEnds>{{node(a.size() - 1), node(a.size())}}, all,
                                                        std::vector<frf::Dof>{node(0)});
  const auto both = [&](const MatrixXd& first, const MatrixXd& second) {
    MatrixXd together = MatrixXd::Zero(size, size);
    together.topLeftCorner(a.size(), a.size()) = first;
    together.bottomRightCorner(b.size(), b.size()) = second;
    return together;
  };
  const MatrixStructure matrices = {both(a.matrices.mass, b.matrices.mass), both(a.matrices.damping, b.matrices.damping),
                                    both(a.matrices.stiffness, b.matrices.stiffness)};
  const MatrixXd unit = MatrixXd::Identity(size, size), w = unit.col(a.size() - 1) - unit.col(a.size());
  const auto solve = [&](const std::shared_ptr<const Receptance>& structure) {
    return HarmonicBalance(structure, a.joints(), Excitation::single(p), {.fixed = harmonics}).solve(omega);
  };
  const HarmonicSolution found = solve(measured), expected = solve(std::make_shared<MatrixReceptance>(matrices, w, unit, unit.leftCols(1)));
  RC_ASSERT(found.converged && expected.converged);
  RC_ASSERT(difference(found.response, expected.response) <= 1e-10);
  RC_ASSERT(difference(found.joint_force, expected.joint_force) <= 1e-9);
}

/// Turning points of the first-harmonic curve of a mass on a cubic spring beside a slider: the closed form
/// P² = X²[(k + ¾k₃X² + k_e − mω²)² + (cω + d_e)²] holds there, and its derivative by X is zero.
RC_GTEST_PROP(Variations, FoldsAreThoseOfTheClosedForm, ()) {
  const double a = any_in(0.1, 0.6), k = any_in(0.1, 0.5), cubic = any_in(0.04, 0.15), c = any_in(0.01, 0.03), p = any_in(0.3, 0.8);
  const MatrixXd one = MatrixXd::Ones(1, 1);
  const Joint joint = {.name = "joint", .friction = friction::make_element("bilinear", std::vector<double>{a, k}), .cubic = cubic};
  const HarmonicBalance balance(std::make_shared<MatrixReceptance>(MatrixStructure{one, c * one, one}, one, one, one), {joint},
                                Excitation::single(p), {.fixed = {1}});
  CurveRequest request = {.along = Along::frequency, .from = 0.3, .to = 4.0};
  request.longest_step = 0.02;
  const ResponseCurve curve = follow_response(balance, request);
  RC_ASSERT(curve.end == CurveEnd::reached);
  RC_ASSERT(curve.turning_points.size() % 2 == 0U);
  const auto square = [&](double x, double omega) {
    const double cosine = 1.0 - 2.0 * std::min(a / x, 1.0), angle = std::acos(std::clamp(cosine, -1.0, 1.0));
    const double k_e = k / std::numbers::pi * (angle - 0.5 * std::sin(2.0 * angle));
    const double d_e = k / std::numbers::pi * std::pow(std::sin(angle), 2);
    return x * x * (std::pow(1.0 + 0.75 * cubic * x * x + k_e - omega * omega, 2) + std::pow(c * omega + d_e, 2));
  };
  for (std::size_t i = 0; i < curve.turning_points.size(); ++i) {
    const double x = std::abs(curve.turning_points[i].response(0, 0)), omega = curve.turning_parameters[i], h = 1e-4 * x;
    RC_ASSERT(std::abs(square(x, omega) / (p * p) - 1.0) <= 1e-8);
    const double slope = (square(x + h, omega) - square(x - h, omega)) / (2.0 * h);
    const double curvature = (square(x + h, omega) - 2.0 * square(x, omega) + square(x - h, omega)) / (h * h);
    RC_ASSERT(std::abs(slope) <= 1e-4 * std::abs(curvature) * x + 1e-7 * p * p / x);
  }
}

}  // namespace
}  // namespace jointid::response
