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

TEST(MergedSet, RefusesOtherLinesAndFrfsTwice) {
  FrfSet other = set_of("b", {"2:+Z"}, {"1:+Z"}, 1.0);
  other.header.frequency_hz[1] = 25.0;
  EXPECT_THAT(error_of({set_of("a", {"1:+Z"}, {"1:+Z"}, 1.0), other}), testing::HasSubstr("are not those of a"));
  EXPECT_THAT(error_of({set_of("a", {"1:+Z"}, {"1:+Z"}, 1.0), set_of("b", {"1:-Z"}, {"1:+Z"}, 1.0)}),
              testing::HasSubstr("another file has it"));
}

}  // namespace
}  // namespace jointid::frf
