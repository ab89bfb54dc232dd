#include "laws/task/contradiction.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "problems/vibration/law_problem_cases.hpp"
#include "response/identify/direct_step.hpp"

namespace jointid::laws {
namespace {

using response::Consistency;
using response::DataFault;
using testing::HasSubstr;
using Kind = DataFault::Kind;

/// States of a frame with two joints: seven responses at four levels, 1 % of noise on them and on the FRFs of the parts.
class FrameStates : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    problem_ = std::make_unique<problems::LawProblem>(problems::frame_with_joints());
    problem_->model = {1, 3};
    exact_ = std::make_unique<problems::LawMeasurement>(problems::measure(*problem_));
  }
  static void TearDownTestSuite() {
    problem_.reset();
    exact_.reset();
  }

  static auto states(std::uint64_t seed) { return problems::states_of(*problem_, problems::polluted(*problem_, *exact_, seed)); }

  static std::vector<std::size_t> levels() {
    std::vector<std::size_t> level;
    for (std::size_t i = 0; i < problem_->levels.size(); ++i) level.insert(level.end(), problem_->frequency_hz.size(), i);
    return level;
  }

  static std::unique_ptr<problems::LawProblem> problem_;
  static std::unique_ptr<problems::LawMeasurement> exact_;
};

std::unique_ptr<problems::LawProblem> FrameStates::problem_;
std::unique_ptr<problems::LawMeasurement> FrameStates::exact_;

/// χ² without a law has its freedom as its mean, whatever the laws are, and its limit is not passed.
TEST_F(FrameStates, OfGoodDataAgree) {
  double sum = 0.0;
  constexpr int seeds = 40;
  for (int seed = 1; seed <= seeds; ++seed) {
    const auto data = states(static_cast<std::uint64_t>(seed));
    const Consistency test = response::test_consistency(*data.structure, data.states, levels());
    EXPECT_EQ(test.freedom, 480);
    EXPECT_FALSE(test.contradicts()) << seed << ": " << test.chi_square;
    sum += test.chi_square / static_cast<double>(test.freedom);
  }
  // Deviation of a mean: √(2/480) of one, twice that for levels that share errors of the parts.
  EXPECT_NEAR(sum / seeds, 1.0, 4.0 * 2.0 * std::sqrt(2.0 / 480.0 / seeds));
}

TEST_F(FrameStates, OneMistakeIsNamed) {
  struct Mistake {
    Kind kind;
    Eigen::Index first, second;
    std::optional<std::size_t> level;
    Complex by;
    std::string text;
  };
  const std::vector<Mistake> mistakes = {
      {Kind::response, 2, 0, {}, -1.0, "times -1 (a wrong sign: key flip"},
      {Kind::response, 0, 0, {}, 1.0 / 9.81, "times 9.8 (a wrong unit"},
      {Kind::response, 6, 0, {}, std::polar(1.0, 0.3), "times 1 at -17° (a phase"},
      {Kind::force, 0, 0, 2, std::numbers::sqrt2, "the forces of 12 N times 0.71 (root mean squares beside peaks"},
      {Kind::force, 0, 0, {}, 0.25, "the forces of every level times 4"},
      {Kind::exchanged, 1, 4, {}, 1.0, "exchanged (wrong labels"},
  };
  std::uint64_t seed = 100;
  for (const Mistake& mistake : mistakes) {
    auto data = states(++seed);
    for (std::size_t i = 0; i < data.states.size(); ++i) {
      response::MeasuredState& state = data.states[i];
      if (mistake.kind == Kind::response) {
        state.response.col(mistake.first) *= mistake.by;
        state.deviation.col(mistake.first) *= std::abs(mistake.by);
      } else if (mistake.kind == Kind::exchanged) {
        state.response.col(mistake.first).swap(state.response.col(mistake.second));
        state.deviation.col(mistake.first).swap(state.deviation.col(mistake.second));
      } else if (!mistake.level || *mistake.level == levels()[i]) {
        state.force.amplitudes *= mistake.by;
      }
    }
    const Consistency test = response::test_consistency(*data.structure, data.states, levels());
    ASSERT_TRUE(test.contradicts()) << mistake.text;
    const std::string text = contradiction_text(test, problem_->responses, {"1 N", "4 N", "12 N", "30 N"});
    ASSERT_FALSE(test.faults.empty()) << text;
    const DataFault& found = test.faults.front();
    EXPECT_EQ(found.kind, mistake.kind) << text;
    EXPECT_EQ(found.level, mistake.level) << text;
    if (mistake.kind != Kind::force) {
      EXPECT_EQ(found.first, mistake.first) << text;
      EXPECT_EQ(found.second, mistake.second) << text;
    }
    EXPECT_LT(std::abs(found.gain * mistake.by - 1.0), 0.03) << text;
    EXPECT_LT(found.chi_square, test.limit) << text;
    EXPECT_THAT(text, HasSubstr(mistake.text));
  }
}

/// Files of two levels in the wrong order: two forces wrong at once, and named as one mistake.
TEST_F(FrameStates, LevelsInAnotherOrderAreNamed) {
  auto data = states(11);
  const std::vector<std::size_t> level = levels();
  const std::size_t lines = problem_->frequency_hz.size();
  for (std::size_t i = 0; i < lines; ++i) std::swap(data.states[lines + i].force, data.states[2 * lines + i].force);
  const Consistency test = response::test_consistency(*data.structure, data.states, level);
  ASSERT_TRUE(test.contradicts());
  const std::string text = contradiction_text(test, problem_->responses, {"1 N", "4 N", "12 N", "30 N"});
  ASSERT_FALSE(test.faults.empty()) << text;
  EXPECT_EQ(test.faults.front().kind, Kind::levels) << text;
  EXPECT_LT(test.faults.front().chi_square, test.limit);
  EXPECT_THAT(text, HasSubstr("the forces of 4 N and 12 N exchanged"));
}

/// Two mistakes at once, and errors stated far too small, are no single mistake.
TEST_F(FrameStates, WhatNoSingleMistakeExplainsIsSaid) {
  auto data = states(7);
  for (response::MeasuredState& state : data.states) {
    state.response.col(1) *= -1.0;
    state.response.col(5) *= 3.0;
  }
  const Consistency test = response::test_consistency(*data.structure, data.states, levels());
  ASSERT_TRUE(test.contradicts());
  EXPECT_THAT(contradiction_text(test, problem_->responses, {}), HasSubstr("no single sign, gain or exchange explains it"));
}

/// Against the residual of the direct step, found from a singular value decomposition: parts without errors.
TEST(ResponseConsistency, IsTheResidualOfTheDirectStep) {
  const problems::LawProblem problem = [] {
    problems::LawProblem frame = problems::frame_with_joints();
    frame.model = {1, 3};
    frame.noise = 0.0;
    return frame;
  }();
  auto data = problems::states_of(problem, problems::measure(problem));
  double expected = 0.0;
  std::vector<std::size_t> level;
  for (std::size_t i = 0; i < data.states.size(); ++i) {
    response::MeasuredState& state = data.states[i];
    level.push_back(i % 2);
    for (Eigen::Index k = 0; k < state.response.size(); ++k) {
      state.response(k) *= 1.0 + 0.1 * std::sin(static_cast<double>(1 + k) * static_cast<double>(i + 1));
      state.deviation(k) = (1.0 + 0.5 * std::cos(static_cast<double>(k))) * 1e-2 * std::abs(state.response(k));
    }
    const response::DirectStep step = response::direct_step(*data.structure, state);
    const Eigen::Index joints = data.structure->joints();
    for (Eigen::Index n = 0; n < state.response.rows(); ++n) {
      const int harmonic = state.harmonics[static_cast<std::size_t>(n)];
      Eigen::VectorXcd acting(joints + data.structure->forces());
      acting << -step.joint_force.row(n).transpose(), state.force.of(harmonic);
      const Eigen::VectorXcd moved = data.structure->at(harmonic * state.omega) * acting;
      const Eigen::RowVectorXcd rest = state.response.row(n) - moved.tail(data.structure->responses()).transpose();
      expected += rest.cwiseQuotient(state.deviation.row(n).cast<Complex>()).squaredNorm();
    }
  }
  ASSERT_TRUE(data.structure->errors(data.states[0].omega).empty());
  const Consistency test = response::test_consistency(*data.structure, data.states, level);
  EXPECT_NEAR(test.chi_square / expected, 1.0, 1e-6);
}

}  // namespace
}  // namespace jointid::laws
