#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "ident/identify.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/problem.hpp"
#include "thread_team.hpp"

namespace jointid::ident {
namespace {

using testing::HasSubstr;

/// Problem A1 with noise, identified by a method.
class SharedLines : public testing::Test {
 protected:
  explicit SharedLines(const std::string& name = "A1") : problem_(problems::make(name)), scene_(problems::scene(problem_)) {
    scene_.identify.automatic = false;
  }

  std::unique_ptr<Plan> plan() const { return problems::plan(scene_, measurement_); }

  Solution alone() const {
    Control control;
    control.threads = 1;
    control.judgement = Judgement::data;
    return solve(*plan(), control);
  }

  /// The solutions of all members of a team.
  std::vector<Solution> together(std::size_t size) const {
    std::vector<Solution> out(size);
    const auto thrown = ThreadTeam(size).run([&](Team& member) {
      Control control;
      control.threads = 1;
      control.judgement = Judgement::data;
      control.shares = LineShares(member);
      out[member.rank()] = control.shares.together([&] { return solve(*plan(), control); });
    });
    for (const std::exception_ptr& each : thrown) {
      if (each) std::rethrow_exception(each);
    }
    return out;
  }

  problems::Problem problem_;
  Scene scene_;
  problems::Measurement measurement_ = problems::polluted(problem_, 3, 0);
};

void expect_near(const std::optional<double>& one, const std::optional<double>& other, double relative) {
  ASSERT_EQ(one.has_value(), other.has_value());
  EXPECT_NEAR(one.value_or(0.0), other.value_or(0.0), relative * std::abs(one.value_or(0.0)));
}

void expect_same(const Solution& one, const Solution& other) {
  EXPECT_EQ(one.status, other.status);
  EXPECT_EQ(one.message, other.message);
  ASSERT_EQ(one.unknowns.size(), other.unknowns.size());
  for (std::size_t u = 0; u < one.unknowns.size(); ++u) {
    EXPECT_NEAR(one.unknowns[u].value, other.unknowns[u].value, 1e-10 * std::abs(one.unknowns[u].value));
    expect_near(one.unknowns[u].std_error, other.unknowns[u].std_error, 1e-9);
    expect_near(one.unknowns[u].error_estimate, other.unknowns[u].error_estimate, 1e-6);
  }
  EXPECT_EQ(one.fit.lines, other.fit.lines);
  EXPECT_EQ(one.fit.equations_used, other.fit.equations_used);
  EXPECT_EQ(one.fit.equations_dropped, other.fit.equations_dropped);
  EXPECT_EQ(one.fit.iterations, other.fit.iterations);
  EXPECT_EQ(one.fit.rank, other.fit.rank);
  expect_near(one.fit.condition, other.fit.condition, 1e-9);
  expect_near(one.fit.asm_frf_error, other.fit.asm_frf_error, 1e-9);
  ASSERT_EQ(one.fit.chi_square.has_value(), other.fit.chi_square.has_value());
  if (!one.fit.chi_square) return;
  EXPECT_NEAR(one.fit.chi_square->value, other.fit.chi_square->value, 1e-9 * one.fit.chi_square->value);
  EXPECT_EQ(one.fit.chi_square->degrees_of_freedom, other.fit.chi_square->degrees_of_freedom);
  EXPECT_EQ(one.fit.chi_square->outlying_lines, other.fit.chi_square->outlying_lines);
}

/// All members know the same, to the last bit.
void expect_identical(const std::vector<Solution>& all) {
  for (const Solution& each : all) {
    for (std::size_t u = 0; u < each.unknowns.size(); ++u) {
      EXPECT_EQ(each.unknowns[u].value, all.front().unknowns[u].value);
      EXPECT_EQ(each.unknowns[u].std_error, all.front().unknowns[u].std_error);
    }
    EXPECT_EQ(each.message, all.front().message);
  }
}

class AnyMethod : public SharedLines, public testing::WithParamInterface<Method> {
 protected:
  AnyMethod() {
    scene_.identify.method = GetParam();
    if (GetParam() == Method::two) scene_.identify.equations = {Equation::jj};
    if (GetParam() == Method::direct) scene_.identify.equations.clear();
  }
};

/// With 40 members some of them have no line.
TEST_P(AnyMethod, AnyNumberOfProcessesGetsTheSolutionOfOne) {
  const Solution one = alone();
  for (const std::size_t size : {2u, 3u, 40u}) {
    const std::vector<Solution> all = together(size);
    expect_same(one, all.front());
    expect_identical(all);
  }
}

INSTANTIATE_TEST_SUITE_P(SharedLines, AnyMethod, testing::Values(Method::one, Method::two, Method::direct, Method::likelihood),
                         [](const auto& info) { return name(info.param); });

TEST_F(SharedLines, NormalEquationsAddUp) {
  scene_.identify.method = Method::one;
  scene_.identify.solver = Solver::normal;
  expect_same(alone(), together(3).front());
}

/// What only some lines know decides about the layout of all: two FRFs are missing on the first half, one on the second.
TEST_F(SharedLines, FrfsThatOneProcessDoesNotKnowAreTheOthers) {
  scene_.identify.method = Method::likelihood;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (frf::FrfSet* set : {&measurement_.substructures.front(), &measurement_.assembly}) {
    const std::size_t lines = set->header.lines();
    for (std::size_t line = 0; line < lines; ++line) {
      if (2 * line < lines) set->values[set->index(line, 0, 1)] = set->values[set->index(line, 1, 0)] = {nan, nan};
      if (2 * line >= lines) set->values[set->index(line, 2, 2)] = {nan, nan};
    }
  }
  expect_same(alone(), together(2).front());
}

TEST_F(SharedLines, MethodsThatNeedAllLinesSaySo) {
  const auto why = [&]() -> std::string {
    try {
      together(2);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  scene_.identify.method = Method::newton;
  scene_.identify.equations.clear();
  EXPECT_THAT(why(), HasSubstr("several processes cannot share"));
  scene_.identify.method = Method::likelihood;
  scene_.identify.bootstrap = 20;
  EXPECT_THAT(why(), HasSubstr("a bootstrap simulates all lines at once"));
}

/// One failure ends all, and is told by who had it.
TEST(LineShares, AFailureIsToldOnce) {
  const auto thrown = ThreadTeam(3).run([](Team& member) {
    const LineShares shares(member);
    shares.together([&] {
      if (member.rank() > 0) throw std::runtime_error("failed");
      return shares.any(false);
    });
  });
  EXPECT_THROW(std::rethrow_exception(thrown[0]), ToldElsewhere);
  EXPECT_THROW(std::rethrow_exception(thrown[1]), std::runtime_error);
  EXPECT_THROW(std::rethrow_exception(thrown[2]), ToldElsewhere);
}

TEST(LineShares, LinesAreSplitInOrderAndCompletedByAll) {
  constexpr std::size_t lines = 8, width = 2;
  ThreadTeam(3).run([](Team& member) {
    const LineShares shares(member);
    const LineShares::Range own = shares.own(lines);
    EXPECT_LE(own.size(), 3u);
    std::vector<double> numbers(width * lines, -1.0);
    for (std::size_t i = width * own.first; i < width * own.last; ++i) numbers[i] = static_cast<double>(i);
    shares.complete(numbers, lines);
    for (std::size_t i = 0; i < numbers.size(); ++i) EXPECT_EQ(numbers[i], static_cast<double>(i));
    double sum = 1.0 + static_cast<double>(member.rank());
    shares.sum({&sum, 1});
    EXPECT_EQ(sum, 6.0);
  });
}

}  // namespace
}  // namespace jointid::ident
