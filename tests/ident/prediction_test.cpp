#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dense/lu.hpp"
#include "ident/identify.hpp"
#include "ident/result/quality.hpp"
#include "memory_systems.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/problem.hpp"

namespace jointid::ident {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using restrictions::Kind;

MatrixXcd block(const std::vector<frf::FrfSet>& sets, std::size_t line, const Dofs& rows, const Dofs& columns,
                Complex absent) {
  MatrixXcd h(static_cast<Index>(rows.size()), static_cast<Index>(columns.size()));
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (std::size_t c = 0; c < columns.size(); ++c) {
      h(static_cast<Index>(r), static_cast<Index>(c)) = frf_at(sets, line, rows[r], columns[c], absent);
    }
  }
  return h;
}

/// rms of 20 log10(|predicted|/|measured|) by coupling all coordinates: H_asm = (H_sub⁻¹ + Z)⁻¹.
double plain_error(const Plan& plan, const problems::Measurement& measured, const Matrices& joint, const Dofs& rows,
                   const Dofs& columns) {
  Dofs all = measured.assembly.header.response;
  double sum = 0.0, count = 0.0;
  for (const Line& line : plan.lines) {
    const double omega = 2.0 * std::numbers::pi * line.frequency_hz;
    MatrixXcd z = dense::inverse(block(measured.substructures, line.substructures, all, all, 0.0));
    for (const auto& [kind, matrix] : joint) {
      const Complex factor = kind == Kind::stiffness ? Complex(1.0) : kind == Kind::mass ? Complex(-omega * omega) : Complex(0.0, 1.0);
      for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 4; ++j) {
          z(static_cast<Index>(frf::find_coordinate(all, plan.coordinates.joint[i])),
            static_cast<Index>(frf::find_coordinate(all, plan.coordinates.joint[j]))) += factor * matrix[i][j];
        }
      }
    }
    const MatrixXcd predicted = dense::inverse(z);
    for (const frf::Dof& r : rows) {
      for (const frf::Dof& c : columns) {
        const Complex here = predicted(static_cast<Index>(frf::find_coordinate(all, r)), static_cast<Index>(frf::find_coordinate(all, c)));
        const double db = 20.0 * std::log10(std::abs(here) / std::abs(frf_at({measured.assembly}, line.assembly, r, c)));
        if (!std::isfinite(db)) continue;
        sum += db * db;
        count += 1.0;
      }
    }
  }
  return std::sqrt(sum / count);
}

struct Use {
  Method method;
  std::vector<Equation> equations;
};

const Use uses[] = {{Method::one, {Equation::nj}},
                    {Method::one, {Equation::nn, Equation::nj}},
                    {Method::one, {Equation::nn, Equation::jj}},
                    {Method::one, {Equation::jj}},
                    {Method::one, {Equation::nj, Equation::jn}},
                    {Method::one, {Equation::nn, Equation::nj, Equation::jj, Equation::jn}},
                    {Method::two, {Equation::jn}},
                    {Method::two, {Equation::jj}},
                    {Method::direct, {Equation::nn}}};

// The assembly of B is symmetric about node 4: H(4:+Y, 4:+RZ) is zero but for rounding and must not count.
TEST(Prediction, IsExactForCleanData) {
  for (const char* name : {"A1", "C2", "B"}) {
    const problems::Problem problem = problems::make(name);
    for (const Use& use : uses) {
      Scene scene = problems::scene(problem);
      scene.identify.method = use.method;
      scene.identify.equations = use.equations;
      const auto plan = problems::plan(scene, {problem.substructures, problem.assembly});
      const Solution solution = solve(*plan);
      ASSERT_TRUE(solution.fit.asm_frf_error.has_value());
      EXPECT_LE(*solution.fit.asm_frf_error, 1e-5) << name << " " << ident::name(use.method);
    }
  }
}

TEST(Prediction, IsThatOfCouplingAllCoordinatesForNoisyData) {
  const problems::Problem a1 = problems::make("A1");
  problems::Measurement measured = problems::polluted(a1, 11, 0);
  measured.assembly.values[measured.assembly.index(3, 0, 0)] = std::numeric_limits<double>::quiet_NaN();
  measured.assembly.values[measured.assembly.index(4, 1, 7)] = 0.0;
  for (const Use& use : uses) {
    Scene scene = problems::scene(a1);
    scene.identify.method = use.method;
    scene.identify.equations = use.equations;
    scene.identify.weighting = weighting::Weighting::wa;
    scene.frequency.step_hz = 60.0;
    const auto plan = problems::plan(scene, measured);
    const Solution solution = solve(*plan);
    const double expected = plain_error(*plan, measured, solution.bands[0].matrices, plan->predicted_responses, plan->predicted_references);
    ASSERT_TRUE(solution.fit.asm_frf_error.has_value());
    EXPECT_GT(expected, 0.1);
    EXPECT_NEAR(*solution.fit.asm_frf_error, expected, 1e-6 * expected) << name(use.method) << plan->predicted_responses.size();
  }
}

TEST(Prediction, CoversRowsAndColumnsThatTheEquationsUse) {
  const problems::Problem a1 = problems::make("A1");
  const std::pair<std::size_t, std::size_t> sizes[] = {{10, 4},  {10, 14}, {14, 14}, {4, 4},  {14, 14},
                                                       {14, 14}, {14, 10}, {14, 4},  {10, 10}};
  for (std::size_t i = 0; i < std::size(uses); ++i) {
    Scene scene = problems::scene(a1);
    scene.identify.method = uses[i].method;
    scene.identify.equations = uses[i].equations;
    const auto plan = problems::plan(scene, {a1.substructures, a1.assembly});
    EXPECT_EQ(plan->predicted_responses.size(), sizes[i].first) << i;
    EXPECT_EQ(plan->predicted_references.size(), sizes[i].second) << i;
  }
}

TEST(Prediction, IsLeftOutWithoutHbb) {
  const problems::Problem a1 = problems::make("A1");
  for (const std::vector<Equation>& equations : {std::vector<Equation>{Equation::nn}, {Equation::nn, Equation::jn}}) {
    Scene scene = problems::scene(a1);
    scene.identify.equations = equations;
    const auto plan = problems::plan(scene, {a1.substructures, a1.assembly});
    EXPECT_FALSE(solve(*plan).fit.asm_frf_error.has_value());
  }
}

TEST(Quality, FiguresOfMeritByHand) {
  // Upper triangle u = 1.1, 0.9, 2: Σu = 4, Σu² = 6.02; the zero and the lower triangle are left out.
  const Matrix exact = {{10.0, 20.0, 0.0}, {99.0, -4.0, 0.0}, {99.0, 99.0, 0.0}};
  const Matrix identified = {{11.0, 18.0, 5.0}, {0.0, -8.0, 7.0}, {0.0, 0.0, 1.0}};
  const auto quality = judge(identified, exact);
  ASSERT_TRUE(quality.has_value());
  EXPECT_NEAR(quality->rjcf, 16.0 / (3.0 * 6.02), 1e-14);
  EXPECT_NEAR(quality->arvf, 4.0 / 3.0, 1e-14);
  EXPECT_NEAR(quality->rms_relative_error, std::sqrt((0.01 + 0.01 + 1.0) / 3.0), 1e-14);
}

TEST(Quality, PerfectScaledAndHopeless) {
  const Matrix exact = {{2.0, -1.0}, {-1.0, 3.0}};
  const auto perfect = judge(exact, exact), twice = judge({{4.0, -2.0}, {-2.0, 6.0}}, exact);
  EXPECT_DOUBLE_EQ(perfect->rjcf, 1.0);
  EXPECT_DOUBLE_EQ(perfect->arvf, 1.0);
  EXPECT_DOUBLE_EQ(perfect->rms_relative_error, 0.0);
  EXPECT_DOUBLE_EQ(twice->rjcf, 1.0);
  EXPECT_DOUBLE_EQ(twice->arvf, 2.0);
  EXPECT_EQ(judge({{0.0, 0.0}, {0.0, 0.0}}, exact)->rjcf, 0.0);
  EXPECT_FALSE(judge(exact, {{0.0, 0.0}, {1.0, 0.0}}).has_value());
}

TEST(Quality, IsThereForMatricesWithATruth) {
  const problems::Problem a1 = problems::make("A1");
  Scene scene = problems::scene(a1);
  scene.truth.erase(Kind::hysteretic_damping);
  const auto plan = problems::plan(scene, problems::polluted(a1, 2, 0));
  const Solution solution = solve(*plan);
  EXPECT_EQ(solution.quality.size(), 1u);
  const auto expected = judge(solution.bands[0].matrices.at(Kind::stiffness), a1.truth.at(Kind::stiffness));
  EXPECT_EQ(solution.quality.at(Kind::stiffness).rjcf, expected->rjcf);
}

}  // namespace
}  // namespace jointid::ident
