#include "stability/sweeps.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "minimise/linear/sparse_qr.hpp"
#include "stability/exact_fit.hpp"
#include "stability/many_joints_scene.hpp"
#include "stability/matrix_sweeps.hpp"

namespace jointid::stability {
namespace {

using ident::Solver;

Measured measured(const ExtremeScene& scene, Way solver) {
  const ExtremeProblem problem = make(scene);
  return measure(problem, solver, exact_estimate(problem));
}

/// What has to be left: all but what the condition takes, and one.
double allowed(const Measured& row) { return 15.0 - std::log10(row.condition) - 1.0; }

TEST(Stability, CompressedQrKeepsWhatTheConditionAllows) {
  for (const Form form : {Form::springs, Form::symmetric}) {
    for (const double stiffness : {1e-6, 1e-3, 1.0, 1e3, 1e6}) {
      ExtremeScene scene;
      scene.form = form;
      scene.joint_stiffness = stiffness;
      const Measured row = measured(scene, Solver::qr);
      EXPECT_GE(row.digits_kept, std::min(10.0, allowed(row))) << stiffness << ", condition " << row.condition;
    }
  }
}

TEST(Stability, NormalEquationsLoseTwiceAsMany) {
  for (const double delta : {1e-4, 1e-5, 1e-6}) {
    const Measured qr = measure(laeuchli(5, delta), Solver::qr), normal = measure(laeuchli(5, delta), Solver::normal);
    const double lost = std::log10(qr.condition);
    EXPECT_GE(qr.digits_kept, 15.0 - lost - 1.0);
    EXPECT_GE(16.0 - normal.digits_kept, 1.6 * lost) << "they lost " << 16.0 - normal.digits_kept << " at " << delta;
  }
}

TEST(Stability, EveryOrthogonalRouteAgreesOnHardRows) {
  for (const Way solver : {Way(Solver::qr), Way(OwnWay::svd), Way(Solver::spqr)}) {
    for (const Rows& rows : {hilbert(8), laeuchli(5, 1e-8), weighted(60, 5, 1e4)}) {
      const Measured row = measure(rows, solver);
      EXPECT_GE(row.digits_kept, std::min(15.0, allowed(row))) << name(solver) << ", condition " << row.condition;
    }
  }
}

TEST(Stability, RefinementGivesAllDigitsOfHardRows) {
  for (const Rows& rows : {hilbert(10), laeuchli(5, 1e-10), weighted(60, 5, 1e14)}) {
    EXPECT_GE(measure(rows, OwnWay::qr_refined).digits_kept, 15.0);
  }
}

TEST(Stability, ExactIdentificationOfEveryMethodFindsTheTruth) {
  for (const ident::Method method : {ident::Method::one, ident::Method::two, ident::Method::direct}) {
    ExtremeScene scene;
    scene.method = method;
    for (const auto weighting : {weighting::Weighting::none, weighting::Weighting::wa, weighting::Weighting::wbg}) {
      scene.weighting = weighting;
      const ExtremeProblem problem = make(scene);
      const ExactEstimate exact = *exact_estimate(problem);
      for (std::size_t j = 0; j < problem.truth.size(); ++j) {
        EXPECT_NEAR(exact.values[j] / problem.truth[j], 1.0, 1e-10) << ident::name(method);
      }
      const Measured row = measure(problem, Solver::qr, exact);
      EXPECT_GE(row.digits_kept, 10.0) << ident::name(method);
      EXPECT_EQ(row.verdict, Honesty::right);
    }
  }
}

TEST(Stability, TheExactMinimumDoesNotDependOnItsStart) {
  for (const ident::Method method : {ident::Method::likelihood, ident::Method::newton}) {
    ExtremeScene scene;
    scene.method = method;
    scene.lines = 4;
    scene.joint_stiffness = 30.0;
    const ExtremeProblem problem = make(scene);
    std::vector<double> elsewhere = problem.truth;
    for (std::size_t j = 0; j < elsewhere.size(); ++j) elsewhere[j] *= j % 2 == 0 ? 1.001 : 0.999;
    const ExactEstimate one = fit_exactly(*problem.plan(Solver::automatic), problem.sets, problem.truth);
    const ExactEstimate other = fit_exactly(*problem.plan(Solver::automatic), problem.sets, elsewhere);
    for (std::size_t j = 0; j < problem.truth.size(); ++j) {
      EXPECT_NEAR(one.values[j] / problem.truth[j], 1.0, 1e-12) << ident::name(method);
      EXPECT_NEAR(one.values[j] / other.values[j], 1.0, 1e-15) << ident::name(method);
    }
  }
}

TEST(Stability, IterativeMethodsKeepTheDigitsOfTheirExactMinimum) {
  for (const ident::Method method : {ident::Method::likelihood, ident::Method::newton}) {
    ExtremeScene scene;
    scene.method = method;
    for (const double stiffness : {1e-4, 1.0}) {
      scene.joint_stiffness = stiffness;
      EXPECT_GE(measured(scene, Solver::automatic).digits_kept, 12.0) << ident::name(method) << ", " << stiffness;
    }
  }
}

TEST(Stability, TheStatedBoundCoversTheErrorAndIsNotIdle) {
  ExtremeScene scene;
  for (const double stiffness : {1e-4, 1.0, 1e4}) {
    for (const Storage storage : {Storage::double_precision, Storage::single_precision}) {
      scene.joint_stiffness = stiffness;
      scene.storage = storage;
      const Measured row = measured(scene, Solver::qr);
      ASSERT_TRUE(row.digits_stated);
      EXPECT_LE(*row.digits_stated, row.digits_true + 1.0) << stiffness;
      EXPECT_GE(*row.digits_stated, row.digits_true - 5.0) << stiffness;
    }
  }
}

TEST(Stability, WhatRoundingDestroysIsImprecise) {
  ExtremeScene scene;
  scene.joint_stiffness = 1e9;
  scene.storage = Storage::single_precision;
  const Measured row = measured(scene, Solver::qr);
  EXPECT_NE(row.status, ident::Status::ok);
  EXPECT_EQ(row.verdict, Honesty::told);
}

TEST(Stability, SweepsKeepTheirPromises) {
  for (const Measured& row : run_sweeps({"spread", "coincident", "single"})) {
    EXPECT_NE(row.verdict, Honesty::silent_wrong) << row.sweep << " " << row.value << " " << row.solver;
  }
}

/// Rows of many joints from a millionth to a million times the structure's stiffness: sparse ways keep what the dense one keeps.
TEST(Stability, SparseWaysKeepWhatTheDenseOneKeeps) {
  for (const bool frame : {false, true}) {
    for (const double spread : {1.0, 1e3, 1e6}) {
      const ExtremeProblem problem = make(ManyJointsScene{.frame = frame, .spread = spread});
      const Measured dense = measure(problem, Solver::qr, std::nullopt);
      EXPECT_NE(dense.verdict, Honesty::silent_wrong) << spread;
      EXPECT_TRUE(spread > 1.0 || dense.digits_true >= 8.0) << frame << ", " << dense.digits_true;
      for (const Solver solver : {Solver::cholmod, Solver::ldlt, Solver::spqr}) {
        if (solver != Solver::ldlt && !minimise::has_spqr()) continue;
        const Measured sparse = measure(problem, solver, std::nullopt);
        EXPECT_GE(sparse.digits_true, dense.digits_true - 1.5) << sparse.solver << ", " << spread;
        EXPECT_NE(sparse.verdict, Honesty::silent_wrong) << sparse.solver << ", " << spread;
      }
    }
  }
}

/// Half of the D are zero, the edge of what is allowed: the constrained joint is the truth, as the free one is.
TEST(Stability, ConstrainedJointsOnTheEdgeKeepTheirDigits) {
  for (const bool frame : {false, true}) {
    for (const double spread : {1.0, 1e3}) {
      const Measured free = measure(make(ManyJointsScene{.frame = frame, .spread = spread}), Solver::automatic, std::nullopt);
      const Measured held =
          measure(make(ManyJointsScene{.frame = frame, .spread = spread, .definite = true}), Solver::automatic, std::nullopt);
      EXPECT_GE(held.digits_true, std::min(6.0, free.digits_true - 2.0)) << frame << ' ' << spread << ' ' << free.digits_true;
      EXPECT_NE(held.verdict, Honesty::silent_wrong) << frame << ' ' << spread;
    }
  }
}

TEST(Stability, AnUnknownSweepIsAnError) {
  try {
    run_sweeps({"stifness"});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean 'stiffness'"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace jointid::stability
