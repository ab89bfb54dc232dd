#include "report/text/frf_summary.hpp"

#include <gmock/gmock.h>

#include <limits>

namespace jointid::report {
namespace {

using testing::HasSubstr;

/// Two responses, one reference; the second FRF is zero or not measured throughout.
frf::FrfSet sample(std::size_t lines) {
  frf::FrfSet set;
  for (std::size_t i = 0; i < lines; ++i) {
    set.header.frequency_hz.push_back(10.0 + 0.5 * static_cast<double>(i));
    set.values.emplace_back(1.0, 0.0);
    set.values.emplace_back(i == 0 ? std::numeric_limits<double>::quiet_NaN() : 0.0, 0.0);
  }
  set.header.response = {frf::Dof::parse("4:+Y"), frf::Dof::parse("4:-RZ")};
  set.header.reference = {frf::Dof::parse("4:+Y")};
  return set;
}

const auto never = [] { return false; };

TEST(FrfCensus, CountsWhatIsMissingAndWhatIsZero) {
  const auto source = frf::from_memory(sample(4));
  const tasks::FrfCensus census = tasks::take_census(*source, never);
  EXPECT_EQ(census.values, 8U);
  EXPECT_EQ(census.missing, 1U);
  EXPECT_EQ(census.zero_frfs, 1U);
  EXPECT_TRUE(census.complete);
}

TEST(FrfCensus, ReadsManyLinesInSeveralPiecesEachOnce) {
  const auto source = frf::from_memory(sample(300000));
  EXPECT_EQ(tasks::take_census(*source, never).values, 600000U);
  EXPECT_EQ(source->count().lines, 300000U);
  EXPECT_GT(source->count().calls, 1U);
}

TEST(FrfCensus, StopsWhenInterrupted) {
  const auto source = frf::from_memory(sample(300000));
  int polls = 0;
  const tasks::FrfCensus census = tasks::take_census(*source, [&polls] { return ++polls > 1; });
  EXPECT_FALSE(census.complete);
  EXPECT_EQ(source->count().calls, 1U);
}

TEST(SummaryText, SaysWhatTheFileHolds) {
  const auto source = frf::from_memory(sample(4));
  const std::string text = summary_text(source->header(), tasks::take_census(*source, never));
  EXPECT_THAT(text, HasSubstr("lines                 4, 10 to 11.5 Hz, step 0.5 Hz\n"));
  EXPECT_THAT(text, HasSubstr("responses             2: 4:+Y 4:-RZ\n"));
  EXPECT_THAT(text, HasSubstr("not measured          1 of 8 values (12.5 %)\n"));
  EXPECT_THAT(text, HasSubstr("FRFs without a value  1 of 2\n"));
}

TEST(SummaryText, ListsValuesThatStandOutAndCountsTheRest) {
  frf::FrfSet set = sample(200);
  set.header.quantity = frf::Quantity::mobility;
  for (std::size_t line = 0; line < 200; ++line) set.values[set.index(line, 1, 0)] = {0.0, 2.0};
  set.values[set.index(40, 0, 0)] = {5e4, 0.0};
  set.values[set.index(60, 1, 0)] = {std::numeric_limits<double>::infinity(), 0.0};
  const std::string some = summary_text(set.header, tasks::take_census(*frf::from_memory(set), never));
  EXPECT_THAT(some, HasSubstr("values that are no FRF of a structure\n"
                              "  4:-RZ/4:+Y, line 61 (40 Hz): infinite\n"
                              "  4:+Y/4:+Y, line 41 (30 Hz): 5e+04 times its neighbours: 0+9.425e+06i m/(s*N)\n"));
  for (std::size_t line = 5; line < 200; line += 10) set.values[set.index(line, 1, 0)] = {std::numeric_limits<double>::quiet_NaN(), 0.0};
  const std::string many = summary_text(set.header, tasks::take_census(*frf::from_memory(set), never));
  EXPECT_THAT(many, HasSubstr("4:-RZ/4:+Y, line 6 (12.5 Hz): not a number\n"));
  EXPECT_THAT(many, HasSubstr("\n  and 10 more\n"));
  EXPECT_THAT(summary_text(set.header, {.values = 400}), testing::Not(HasSubstr("values that")));
}

TEST(SummaryText, ManyDofsAreCutAndUnevenStepsAreSaid) {
  frf::FrfHeader header;
  header.frequency_hz = {1.0, 2.0, 4.0};
  for (int node = 1; node <= 40; ++node) header.response.push_back({node, frf::Direction::x, +1});
  header.reference = {header.response.front()};
  const std::string text = summary_text(header, {.values = 120});
  EXPECT_THAT(text, HasSubstr("steps vary"));
  EXPECT_THAT(text, HasSubstr("40: 1:+X 2:+X"));
  EXPECT_THAT(text, HasSubstr("11:+X … 40:+X\n"));
}

}  // namespace
}  // namespace jointid::report
