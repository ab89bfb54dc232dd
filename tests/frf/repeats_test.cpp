#include "frf/noise/repeats.hpp"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "base/statistics.hpp"

namespace jointid::frf {
namespace {

using ::testing::HasSubstr;

FrfSet run_of(const std::vector<Complex>& values) {
  FrfSet set;
  set.header.file = "run.h5";
  for (std::size_t i = 0; i < values.size(); ++i) set.header.frequency_hz.push_back(10.0 * static_cast<double>(i + 1));
  set.header.response = {Dof::parse("1:+Y")};
  set.header.reference = {Dof::parse("2:+Y")};
  set.values = values;
  return set;
}

FrfSet mean_of(const std::vector<FrfSet>& runs) {
  std::vector<std::unique_ptr<FrfSource>> sources;
  for (const FrfSet& run : runs) sources.push_back(from_memory(run));
  return load(*mean_of_repeats(std::move(sources)));
}

void expect_refused(const FrfSet& other, const std::string& problem) {
  try {
    mean_of({run_of({1.0, 2.0}), other});
    FAIL() << "no error: " << problem;
  } catch (const InputError& error) {
    EXPECT_EQ(error.kind(), ErrorKind::data);
    EXPECT_THAT(error.parts().problem, HasSubstr(problem));
    EXPECT_FALSE(error.parts().remedy.empty());
  }
}

RC_GTEST_PROP(Repeats, HaveTheMeanAndItsVarianceByTheDirectFormulas, ()) {
  const auto runs = *rc::gen::inRange<std::size_t>(2, 8);
  std::vector<FrfSet> sets;
  const auto number = [] { return 1e-3 * static_cast<double>(*rc::gen::inRange(-1000, 1000)); };
  for (std::size_t i = 0; i < runs; ++i) sets.push_back(run_of({Complex(number(), 100.0 + number())}));
  const FrfSet mean = mean_of(sets);
  const double n = static_cast<double>(runs);
  Complex expected = 0.0;
  for (const FrfSet& set : sets) expected += set.values[0] / n;
  double real = 0.0, imag = 0.0;
  for (const FrfSet& set : sets) {
    real += std::pow(set.values[0].real() - expected.real(), 2) / (n * (n - 1.0));
    imag += std::pow(set.values[0].imag() - expected.imag(), 2) / (n * (n - 1.0));
  }
  RC_ASSERT(std::abs(mean.values[0] - expected) < 1e-12);
  RC_ASSERT(std::abs(mean.variance[0] - Complex(real, imag)) < 1e-12);
  RC_ASSERT(mean.header.noise == NoiseRecord::variance);
  RC_ASSERT(mean.header.repeats == runs);
}

TEST(Repeats, UseTheRunsThatHaveAnFrf) {
  const FrfSet mean = mean_of({run_of({1.0, nan, nan}), run_of({3.0, 5.0, nan}), run_of({nan, nan, nan})});
  EXPECT_EQ(mean.values[0], Complex(2.0, 0.0));
  EXPECT_EQ(mean.variance[0], Complex(1.0, 0.0));
  EXPECT_EQ(mean.values[1], Complex(5.0, 0.0));
  EXPECT_TRUE(std::isnan(mean.variance[1].real()));
  EXPECT_TRUE(std::isnan(mean.values[2].real()));
}

TEST(Repeats, ThatDisagreeAreRefused) {
  expect_refused(run_of({1.0}), "its lines, 10 to 10 Hz in 1 line, differ from those of run.h5");
  FrfSet other = run_of({1.0, 2.0});
  other.header.frequency_hz[1] += 5.0;
  expect_refused(other, "its lines");
  other = run_of({1.0, 2.0});
  other.header.response[0].sign = -1;
  expect_refused(other, "its response DOFs");
  other = run_of({1.0, 2.0});
  other.header.reference[0].node = 7;
  expect_refused(other, "its reference DOFs");
  other = run_of({1.0, 2.0});
  other.header.quantity = Quantity::mobility;
  expect_refused(other, "of quantity mobility");
}

TEST(Repeats, AreTwoAtLeast) { EXPECT_THROW(mean_of({run_of({1.0})}), InputError); }

}  // namespace
}  // namespace jointid::frf
