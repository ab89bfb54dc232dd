#include "frf/set/merged_set.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "frf/set/h1.hpp"

namespace jointid::frf {
namespace {

FrfSet set_of(const char* file, const std::vector<const char*>& responses, const std::vector<const char*>& references, double first) {
  FrfSet set;
  set.header.file = file;
  set.header.frequency_hz = {10.0, 20.0};
  for (const char* dof : responses) set.header.response.push_back(Dof::parse(dof));
  for (const char* dof : references) set.header.reference.push_back(Dof::parse(dof));
  for (std::size_t i = 0; i < 2 * set.header.entries(); ++i) set.values.emplace_back(first + static_cast<double>(i), 1.0);
  return set;
}

std::string error_of(std::vector<FrfSet> sets) {
  try {
    merged(std::move(sets));
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(MergedSet, HasTheFrfsOfAllWithTheFirstOnesSigns) {
  const FrfSet out = merged({set_of("a", {"1:+Z", "2:+Z"}, {"1:+Z"}, 1.0), set_of("b", {"2:-Z", "3:+Z"}, {"4:+Y"}, 100.0)});
  ASSERT_EQ(out.header.response.size(), 3u);
  ASSERT_EQ(out.header.reference.size(), 2u);
  EXPECT_EQ(out.values[out.index(1, 1, 0)], Complex(4.0, 1.0));
  EXPECT_EQ(out.values[out.index(1, 1, 1)], Complex(-102.0, -1.0));
  EXPECT_EQ(out.values[out.index(0, 2, 1)], Complex(101.0, 1.0));
  EXPECT_TRUE(std::isnan(out.values[out.index(0, 0, 1)].real()));
  EXPECT_EQ(out.header.noise, NoiseRecord::none);
}

TEST(MergedSet, KeepsNoiseWhereAllKnowTheirs) {
  FrfSet a = set_of("a", {"1:+Z"}, {"1:+Z"}, 1.0), b = set_of("b", {"2:+Z"}, {"1:+Z"}, 5.0);
  a.header.noise = NoiseRecord::coherence;
  a.header.averages = 5.0;
  a.coherence = {0.9, 0.8};
  b.header.noise = NoiseRecord::variance;
  b.variance = {{0.1, 0.2}, {0.3, 0.4}};
  const FrfSet out = merged({a, b});
  EXPECT_EQ(out.header.noise, NoiseRecord::variance);
  EXPECT_EQ(out.variance[out.index(1, 1, 0)], Complex(0.3, 0.4));
  EXPECT_DOUBLE_EQ(out.variance[out.index(1, 0, 0)].real(), 0.5 * h1_variance(a.values[1], 0.8, 5.0));
  b.variance.clear();
  EXPECT_EQ(merged({a, b}).header.noise, NoiseRecord::none);
  EXPECT_EQ(merged({a}).coherence, a.coherence);  // one set stays as it is
}

/// A set with covariances 10 r + s + i of responses r > s, 100 + r on the diagonal.
FrfSet with_covariance(FrfSet set) {
  set.header.noise = NoiseRecord::variance;
  set.header.averages = 7.0;
  const std::size_t rows = set.header.response.size(), columns = set.header.reference.size();
  set.variance.assign(set.values.size(), {50.0, 50.0});
  for (std::size_t line = 0; line < set.header.lines(); ++line) {
    for (std::size_t r = 0; r < rows; ++r) {
      for (std::size_t s = 0; s <= r; ++s) {
        const auto of = [](std::size_t i) { return static_cast<double>(i); };
        const Complex value = r == s ? Complex(100.0 + of(r)) : Complex(10.0 * of(r) + of(s), 1.0);
        for (std::size_t c = 0; c < columns; ++c) set.covariance.push_back(value);
      }
    }
  }
  return set;
}

TEST(MergedSet, KeepsCovariancesAndTakesSetsForIndependent) {
  const FrfSet a = with_covariance(set_of("a", {"1:+Z", "2:+Z"}, {"1:+Z"}, 1.0)),
               b = with_covariance(set_of("b", {"3:+Z"}, {"1:+Z"}, 9.0)),
               c = with_covariance(set_of("c", {"3:+Z", "1:+Z", "2:-Z"}, {"4:+Y"}, 20.0));
  const FrfSet out = merged({a, b, c});
  EXPECT_EQ(out.header.averages, 7.0);
  validate(out);
  const auto of = [&](std::size_t r, std::size_t s, std::size_t column) { return out.covariance[(6 + pair_index(r, s)) * 2 + column]; };
  EXPECT_EQ(of(0, 0, 0), Complex(100.0));
  EXPECT_EQ(of(1, 0, 0), Complex(10.0, 1.0));
  EXPECT_EQ(of(2, 0, 0), Complex(0.0));
  EXPECT_EQ(of(2, 2, 0), Complex(100.0));
  // c has 3, 1 and −2 where the union has 1, 2, 3.
  EXPECT_EQ(of(2, 0, 1), Complex(10.0, -1.0));
  EXPECT_EQ(of(2, 1, 1), Complex(-20.0, 1.0));
  EXPECT_EQ(of(1, 0, 1), Complex(-21.0, -1.0));
  FrfSet plain = b;
  plain.covariance.clear();
  const FrfSet with_plain = merged({a, plain});
  EXPECT_EQ(with_plain.covariance[6 + pair_index(2, 2)], Complex(100.0));
  EXPECT_EQ(with_plain.covariance[6 + pair_index(2, 1)], Complex(0.0));
  EXPECT_TRUE(merged({plain, set_of("d", {"9:+Z"}, {"1:+Z"}, 1.0)}).covariance.empty());
}

/// References 1 and 4 of the first set acted at once, and 4 is in the other set, too; 5 and 6 are of that one alone.
TEST(MergedSet, KeepsWhatReferencesOfOneSetHaveInCommon) {
  FrfSet first = with_covariance(set_of("a", {"1:+Z", "2:+Z"}, {"1:+Z", "4:+Y"}, 1.0));
  FrfSet second = with_covariance(set_of("b", {"3:+Z"}, {"4:+Y", "5:+Z", "6:+Z"}, 100.0));
  const Complex value(0.3, -0.4);
  for (int line = 0; line < 2; ++line) {
    first.reference_correlation.insert(first.reference_correlation.end(), {1.0, value, std::conj(value), 1.0});
    second.reference_correlation.insert(second.reference_correlation.end(),
                                        {1.0, 0.2, 0.2, 0.2, 1.0, std::conj(value), 0.2, value, 1.0});
  }
  const FrfSet out = merged({first, second});
  validate(out);
  for (std::size_t line = 0; line < 2; ++line) {
    for (std::size_t m = 0; m < 4; ++m) {
      for (std::size_t n = 0; n < 4; ++n) {
        Complex expected = m == n ? 1.0 : 0.0;
        if (m == 3 && n == 2) expected = value;
        if (m == 2 && n == 3) expected = std::conj(value);
        EXPECT_EQ(out.reference_correlation[(line * 4 + m) * 4 + n], expected) << m << " " << n;
      }
    }
  }
  second.reference_correlation.clear();
  EXPECT_TRUE(merged({first, second}).reference_correlation.empty());
}

TEST(MergedSet, RefusesOtherLinesAndFrfsTwice) {
  FrfSet other = set_of("b", {"2:+Z"}, {"1:+Z"}, 1.0);
  other.header.frequency_hz[1] = 25.0;
  EXPECT_THAT(error_of({set_of("a", {"1:+Z"}, {"1:+Z"}, 1.0), other}), testing::HasSubstr("are not those of a"));
  EXPECT_THAT(error_of({set_of("a", {"1:+Z"}, {"1:+Z"}, 1.0), set_of("b", {"1:-Z"}, {"1:+Z"}, 1.0)}),
              testing::HasSubstr("another file has it"));
}

}  // namespace
}  // namespace jointid::frf
