#include "response/identify/law_fit.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <random>

#include "base/error.hpp"
#include "response/identify/information.hpp"
#include "response/identify/nuisance_residuals.hpp"
#include "tests/require.hpp"
#include "tests/response/any_joint.hpp"
#include "tests/response/golden.hpp"
#include "tests/response/measured_masses.hpp"
#include "tests/response/noisy_receptance.hpp"

namespace jointid::response {
namespace {

using friction::Knowledge;
using golden::json;

/// A golden case: levels · cos ωt on coordinate 1, responses at the measured coordinates.
struct Case {
  Structure structure;
  std::vector<MeasuredState> states;
  std::vector<Joint> truth, start;

  Case(const json& of, const char* responses) {
    const MatrixStructure matrices = golden::structure(of);
    const auto measured = of["measured_coordinates"].get<std::vector<Eigen::Index>>();
    const Eigen::Index n = matrices.mass.rows();
    Eigen::MatrixXd seen = Eigen::MatrixXd::Zero(n, at(measured.size()));
    for (std::size_t i = 0; i < measured.size(); ++i) seen(measured[i] - 1, at(i)) = 1.0;
    structure = std::make_shared<MatrixReceptance>(matrices, golden::matrix(of["W"]), seen, Eigen::MatrixXd::Identity(n, 1));
    const Eigen::VectorXcd y = golden::complex_vector(of[responses]);
    Eigen::Index row = 0;
    for (const double level : of["levels"]) {
      for (const double omega : of["omega"]) {
        const Eigen::MatrixXcd response = y.segment(row, seen.cols()).transpose();
        states.push_back({omega,
                          Excitation::single(level),
                          {1},
                          response,
                          Eigen::MatrixXd::Constant(1, seen.cols(), of["sigma_re_and_im"].get<double>())});
        row += seen.cols();
      }
    }
    truth = {{.name = "joint", .friction = golden::element(of["true"])}};
    start = {{.name = "joint", .friction = truth[0].friction->with(of["start"].get<std::vector<double>>())}};
  }
};

Eigen::VectorXd numbers(const json& values) {
  const auto v = values.get<std::vector<double>>();
  return Eigen::Map<const Eigen::VectorXd>(v.data(), at(v.size()));
}

double relative(const Eigen::VectorXd& found, const Eigen::VectorXd& expected) {
  return ((found - expected).array() / expected.array()).abs().maxCoeff();
}

TEST(LawFit, PredictsTheGoldenResponsesAndTheirDerivatives) {
  const auto cases = golden::cases("identify_from_responses");
  if (cases.empty()) JOINTID_SKIP("no reference file " << golden::file());
  for (const json& each : cases) {
    const Case golden_case(each, "Y_true");
    const LawUnknowns unknowns(golden_case.truth);
    const ResponseResiduals residuals(golden_case.structure, golden_case.states, unknowns,
                                      golden::integers(each["harmonics_model"]));
    const auto value = residuals.evaluate(unknowns.start());
    ASSERT_TRUE(value);
    EXPECT_LE(value->linearised.residual.cwiseAbs().maxCoeff() * each["sigma_re_and_im"].get<double>(), 1e-11) << each["id"];
    Eigen::MatrixXcd jacobian = golden::complex_matrix(each["jacobian_at_truth"]), found(jacobian.rows(), jacobian.cols());
    const Eigen::VectorXd slopes = unknowns.slopes(unknowns.start());
    for (Eigen::Index i = 0; i < found.rows(); ++i) {
      const auto row = [&](Eigen::Index k) { return value->linearised.jacobian.row(k) * each["sigma_re_and_im"].get<double>(); };
      found.row(i).real() = row(2 * i).transpose().cwiseQuotient(slopes).transpose();
      found.row(i).imag() = row(2 * i + 1).transpose().cwiseQuotient(slopes).transpose();
    }
    for (Eigen::Index k = 0; k < found.cols(); ++k) {
      EXPECT_LE(golden::difference(found.col(k), jacobian.col(k)), golden::tolerance(each["trusted_digits"]["jacobian"]))
          << each["id"] << " parameter " << k;
    }

    const Information bound(value->linearised.jacobian * slopes.cwiseInverse().asDiagonal());
    const Eigen::VectorXd deviation = bound.covariance().diagonal().cwiseSqrt();
    const double tolerance = golden::tolerance(each["trusted_digits"]["bound_std"]);
    EXPECT_LE(relative(deviation, numbers(each["bound_std"])), tolerance) << each["id"];
    const Eigen::MatrixXd correlation =
        deviation.cwiseInverse().asDiagonal() * bound.covariance() * deviation.cwiseInverse().asDiagonal();
    EXPECT_LE(golden::difference(correlation, golden::matrix(each["bound_correlation"])), tolerance) << each["id"];
  }
}

TEST(LawFit, MeetsTheGoldenEstimates) {
  const auto cases = golden::cases("identify_from_responses");
  if (cases.empty()) JOINTID_SKIP("no reference file " << golden::file());
  for (const json& each : cases) {
    const Case golden_case(each, "Y_measured");
    const auto fit = [&](std::vector<int> harmonics) {
      return fit_laws(golden_case.structure, golden_case.states, LawUnknowns(golden_case.start),
                      {.harmonics = std::move(harmonics)});
    };
    const double tolerance = golden::tolerance(each["trusted_digits"]["estimate"]);
    const LawFit found = fit(golden::integers(each["harmonics_model"]));
    EXPECT_EQ(word(found.status), "converged");
    EXPECT_LE(relative(found.values, numbers(each["estimate"])), tolerance) << each["id"];
    EXPECT_NEAR(found.chi_square, each["cost_over_sigma2"].get<double>(), 1e-8 * found.chi_square) << each["id"];
    EXPECT_EQ(found.freedom, each["degrees_of_freedom"].get<Eigen::Index>());
    EXPECT_LT(found.steps, 25);

    const LawFit one = fit({1});
    EXPECT_EQ(word(one.status), "converged");
    EXPECT_LE(relative(one.values, numbers(each["estimate_with_one_harmonic"])), 1e-7) << each["id"];
    EXPECT_NEAR(one.chi_square, each["cost_with_one_harmonic"].get<double>(), 1e-7 * one.chi_square) << each["id"];
    const LawFit nine = fit({1, 3, 5, 7, 9});
    EXPECT_LE(relative(nine.values, numbers(each["estimate_with_harmonics_to_9"])), 1e-7) << each["id"];

    // Harmonics added until they do not matter: the estimate with those to 9 is no further away than 0.1 deviations.
    const LawFit added = fit({});
    EXPECT_EQ(word(added.status), "converged");
    EXPECT_GE(added.rounds.size(), 2u);
    EXPECT_LE(added.rounds.back().moved, 0.1);
    const Eigen::VectorXd deviation = added.covariance.diagonal().cwiseSqrt();
    EXPECT_LE(((added.values - nine.values).array() / deviation.array()).abs().maxCoeff(), 0.1) << each["id"];
  }
}

TEST(LawFit, MeetsTheGoldenBoundWithErrorsOfTheReceptances) {
  const auto cases = golden::cases("identify_from_responses");
  if (cases.empty()) JOINTID_SKIP("no reference file " << golden::file());
  for (const json& each : cases) {
    if (!each.contains("bound_with_frf_noise")) continue;
    const Case golden_case(each, "Y_true");
    const MatrixStructure matrices = golden::structure(each);
    const Eigen::Index n = matrices.mass.rows();
    const auto measured = each["measured_coordinates"].get<std::vector<Eigen::Index>>();
    Eigen::MatrixXd seen = Eigen::MatrixXd::Zero(n, at(measured.size()));
    for (std::size_t i = 0; i < measured.size(); ++i) seen(measured[i] - 1, at(i)) = 1.0;
    const auto structure =
        std::make_shared<NoisyReceptance>(matrices, golden::matrix(each["W"]), seen, Eigen::MatrixXd::Identity(n, 1), 0.002);
    const LawUnknowns unknowns(golden_case.truth);
    NuisanceResiduals residuals(structure, golden_case.states, unknowns, golden::integers(each["harmonics_model"]));
    const auto value = residuals.evaluate(unknowns.start());
    ASSERT_TRUE(value);
    const Information bound(value->jacobian * unknowns.slopes(unknowns.start()).cwiseInverse().asDiagonal());
    const json& expected = each["bound_with_frf_noise"];
    EXPECT_LE(relative(bound.covariance().diagonal().cwiseSqrt(), numbers(expected["bound_std"])),
              golden::tolerance(expected["trusted_digits"]))
        << each["id"];
  }
}

/// 25 draws of receptances with 0.5 % noise: errors are those of the covariance, which without the receptances' errors is too
/// small.
TEST(LawFit, ErrorsOfReceptancesCount) {
  Eigen::MatrixXd m = Eigen::Vector3d(1.0, 1.2, 0.9).asDiagonal(), k(3, 3), w(3, 1);
  k << 500.0, -200.0, 0.0, -200.0, 250.0, -50.0, 0.0, -50.0, 150.0;
  w << 0.0, 1.0, -1.0;
  const Eigen::MatrixXd all = Eigen::MatrixXd::Identity(3, 3);
  const auto structure = std::make_shared<NoisyReceptance>(MatrixStructure{m, 1e-3 * k, k}, w, all, all.leftCols(1), 5e-3);
  const std::vector<Joint> truth = {{.name = "joint", .friction = law("ren", {0.004, 1.5, 150.0})}};
  auto exact = measure(structure, truth, {1.0, 3.0, 8.0}, {18.4, 19.0, 19.6, 20.2, 20.8});
  ASSERT_FALSE(exact.empty());
  for (MeasuredState& state : exact) state.deviation.setConstant(2e-5);
  std::mt19937_64 generator(3);
  constexpr int draws = 25;
  double counted = 0.0, ignored = 0.0, chi_square = 0.0;
  for (unsigned i = 1; i <= draws; ++i) {
    const auto disturbed = std::make_shared<NoisyReceptance>(*structure);
    disturbed->disturb(i);
    const auto states = noisy(exact, generator);
    const auto squares = [&](bool errors, LawFit& fit) {
      fit = fit_laws(disturbed, states, LawUnknowns(truth), {.harmonics = {1, 3, 5}, .receptance_errors = errors});
      EXPECT_EQ(word(fit.status), "converged");
      const Eigen::VectorXd error = fit.values - Eigen::Vector3d(0.004, 1.5, 150.0);
      return (error.array().square() / fit.covariance.diagonal().array()).mean() / draws;
    };
    LawFit fit;
    ignored += squares(false, fit);
    counted += squares(true, fit);
    chi_square += fit.chi_square / static_cast<double>(fit.freedom) / draws;
  }
  EXPECT_NEAR(counted, 1.0, 0.5);
  EXPECT_GT(ignored, 3.0);
  EXPECT_NEAR(chi_square, 1.0, 0.15);
}

/// By the implicit function theorem against differences of order 4. Laws have kinks (a slider that just slips, a motion that just
/// turns in an event more): where one lies within the steps, differences of two steps disagree and tell how far they can be trusted.
RC_GTEST_PROP(LawFit, DerivativesAreThoseOfDifferences, ()) {
  const Structure structure = masses(2);
  Joint second = {.name = "b", .friction = any_joint(), .stiffness = 20.0, .damping = 0.1};
  const std::vector<Joint> joints = {{.name = "a", .friction = any_joint()}, second};
  std::vector<JointParameter> free;
  for (std::size_t j = 0; j < 2; ++j) {
    const std::size_t count = joints[j].parameter_names().size() - (j == 0 ? 3 : 1);
    for (std::size_t i = 0; i < count; ++i) {
      const bool law_parameter = i < joints[j].friction->parameters().size();
      if (law_parameter && joints[j].friction->parameters()[i].value == joints[j].friction->parameters()[i].lower) continue;
      free.push_back({j, i});
    }
  }
  const auto states = measure(structure, joints, {any_decade(1.0, 10.0)}, {any_in(8.0, 25.0)});
  RC_PRE(!states.empty());
  const LawUnknowns unknowns(joints, free);
  const ResponseResiduals residuals(structure, states, unknowns, {1, 3, 5});
  const Eigen::VectorXd start = unknowns.start();
  const auto value = residuals.evaluate(start);
  RC_ASSERT(value.has_value());
  const Eigen::Index i = at(any_of(free.size()));
  const auto residual = [&](double step) -> Eigen::VectorXd {
    const auto moved = residuals.evaluate(start + step * Eigen::VectorXd::Unit(start.size(), i), value->states);
    RC_PRE(moved.has_value());
    return moved->linearised.residual;
  };
  const auto difference = [&](double h) -> Eigen::VectorXd {
    return (8.0 * (residual(h) - residual(-h)) - (residual(2.0 * h) - residual(-2.0 * h))) / (12.0 * h);
  };
  const Eigen::VectorXd slope = difference(2e-4), finer = difference(1e-4);
  const double size = std::max(value->linearised.jacobian.cwiseAbs().maxCoeff(), 1e-3);
  const double doubt = (finer - slope).cwiseAbs().maxCoeff();
  RC_PRE(doubt < 1e-4 * size);
  RC_ASSERT((finer - value->linearised.jacobian.col(i)).cwiseAbs().maxCoeff() < 1e-6 * size + 10.0 * doubt);
}

}  // namespace
}  // namespace jointid::response
