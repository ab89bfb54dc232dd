#include "problems/thesis/thesis_tables.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <set>

#include "base/error.hpp"
#include "ident/identify.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/problem.hpp"
#include "problems/thesis/reproduction.hpp"

namespace jointid::problems {
namespace {

/// The print of an entry by row and column.
const Print& print(const std::string& table, const std::string& row, const std::string& column) {
  for (const TableEntry& entry : thesis_table(table).entries) {
    if (entry.row == row && entry.column == column) return entry.print;
  }
  throw std::out_of_range(table + " " + row + " " + column);
}

TEST(ThesisTables, HaveTheSizesOfThePrint) {
  const std::map<std::string, std::size_t> sizes = {{"6.3", 100},  {"6.4", 100}, {"6.5", 40},  {"6.6", 64},  {"6.7", 64},
                                                    {"6.8", 64},   {"6.9", 64},  {"6.10", 64}, {"6.11", 64}, {"6.12", 72},
                                                    {"6.13", 108}, {"6.14", 20}, {"6.15", 33}, {"6.16", 30}, {"6.17", 30}, {"6.18", 24},
                                                    {"6.19", 20},  {"6.20", 10}, {"6.21", 10}, {"6.22", 10},
                                                    {"7.2", 60},   {"7.3", 60},  {"7.5", 8}};
  ASSERT_EQ(thesis_tables().size(), sizes.size());
  for (const ThesisTable& table : thesis_tables()) EXPECT_EQ(table.entries.size(), sizes.at(table.number)) << table.number;
}

TEST(ThesisTables, HaveItsNumbers) {
  EXPECT_EQ(print("6.3", "A8", "K(1,3)").value, -0.261);
  EXPECT_EQ(print("6.4", "A2", "D(3,3)").value, 3.027);
  EXPECT_EQ(print("6.5", "A11", "D(1,1)").value, 24.240);
  EXPECT_EQ(print("6.8", "WBS ARVF", "Δ 0").value, 1.7480);
  EXPECT_EQ(print("6.9", "WBS RJCF", "Δ 0.05").value, 0.99);
  EXPECT_EQ(print("6.13", "h(1,2)", "Δ 0.02").value, -28.47);
  EXPECT_EQ(print("6.18", "G2", "K(3,4)").value, -5.1e-4);
  EXPECT_EQ(print("6.19", "H1", "K(2,4)").value, 6.87);
}

TEST(ThesisTables, KnowHowFarThePrintIsRounded) {
  EXPECT_DOUBLE_EQ(print("6.3", "A1", "K(1,1)").half_unit, 0.0005);
  EXPECT_DOUBLE_EQ(print("6.9", "WBG RJCF", "Δ 0.3").half_unit, 0.05);
  EXPECT_NEAR(print("6.18", "G1", "K(3,3)").half_unit, 0.5e-5, 1e-18);
}

TEST(ThesisTables, MarkWhatIsDoubtfulAndSayWhy) {
  std::map<std::string, std::size_t> doubtful;
  for (const ThesisTable& table : thesis_tables()) {
    for (const TableEntry& entry : table.entries) {
      if (!entry.print.doubtful) continue;
      ++doubtful[table.number];
      EXPECT_THAT(table.notes, testing::Contains(testing::HasSubstr(entry.print.text + "?")));
    }
  }
  const std::map<std::string, std::size_t> expected = {{"6.8", 1}, {"6.10", 1}, {"6.11", 1}, {"6.12", 1}, {"6.13", 1}};
  EXPECT_EQ(doubtful, expected);
  EXPECT_EQ(print("6.8", "WBS ARVF", "Δ 0.3").text, "0.90690");
}

/// (RJCF, ARVF) of the 4×4 matrix with the six printed elements (1,1), (1,2), (1,3), (1,4), (2,2), (2,4).
std::pair<double, double> factors(const std::vector<double>& u) {
  const std::vector<double> triangle = {u[0], u[1], u[2], u[3], u[4], u[3], u[5], u[0], u[1], u[4]};
  double sum = 0.0, squares = 0.0;
  for (const double each : triangle) {
    sum += each;
    squares += each * each;
  }
  return {sum * sum / (10.0 * squares), sum / 10.0};
}

/// The elements of Tables 6.12 and 6.13 give the pairs of Tables 6.9 to 6.11: transcription and print at once.
TEST(ThesisTables, ElementsGiveThePairs) {
  const std::vector<std::array<std::string, 4>> columns = {
      {"6.12", "WA (Δ=0)", "WA", "Δ 0"},   {"6.12", "WB (Δ=0)", "WB", "Δ 0"}, {"6.12", "WBG (Δ=0)", "WBG", "Δ 0"},
      {"6.12", "WBS (Δ=0.05)", "WBS", "Δ 0.05"}, {"6.13", "Δ 0", "WBS", "Δ 0"},     {"6.13", "Δ 0.02", "WBS", "Δ 0.02"},
      {"6.13", "Δ 0.1", "WBS", "Δ 0.1"},   {"6.13", "Δ 0.3", "WBS", "Δ 0.3"}, {"6.13", "Δ 0.5", "WBS", "Δ 0.5"}};
  const std::set<std::string> known_to_disagree = {"6.12 WA (Δ=0) m", "6.12 WB (Δ=0) h", "6.13 Δ 0.1 h"};
  for (const auto& [table, column, weighting, delta] : columns) {
    for (const auto& [letter, pairs] : {std::pair("k", "6.9"), std::pair("m", "6.10"), std::pair("h", "6.11")}) {
      if (known_to_disagree.contains(table + " " + column + " " + letter)) continue;
      std::vector<double> u;
      for (const char* place : {"(1,1)", "(1,2)", "(1,3)", "(1,4)", "(2,2)", "(2,4)"})
        u.push_back(print(table, letter + std::string(place), column).value);
      const auto [rjcf, arvf] = factors(u);
      EXPECT_NEAR(rjcf, print(pairs, weighting + " RJCF", delta).value, 0.0125) << table << column << letter;
      EXPECT_NEAR(arvf, print(pairs, weighting + " ARVF", delta).value, 0.0285) << table << column << letter;
    }
  }
}

TEST(ThesisTables, AnUnknownNumberLeadsToTheNearest) {
  try {
    thesis_table("6.33");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("6.3"));
    EXPECT_EQ(error.kind(), ErrorKind::usage);
  }
}

/// A second program found 20 of 20 and 30 of 30 by these equations and weightings (40 seeds).
TEST(Reproduction, OfTheTablesOfWhichTheChoicesAreKnownHasThePrintsInside) {
  for (const char* number : {"6.14", "6.17"}) {
    const std::vector<Reproduced> results = reproduce(thesis_table(number), {.trials = 40});
    EXPECT_GE(std::ranges::count(results, true, &Reproduced::inside), static_cast<std::ptrdiff_t>(results.size()) - 1) << number;
  }
}

TEST(Reproduction, IsThatOfSolvingTrialAfterTrial) {
  const ThesisTable& table = thesis_table("6.5");
  const std::vector<Reproduced> results = reproduce(table, {.trials = 5, .seed = 2});
  ASSERT_EQ(results.size(), table.entries.size());
  const Problem problem = make("A11");
  std::vector<double> relative;
  for (std::uint64_t trial = 0; trial < 5; ++trial) {
    const auto solution = ident::solve(*plan(scene(problem), polluted(problem, 2, trial)));
    relative.push_back(solution.bands[0].matrices.at(Kind::stiffness)[2][3] / problem.truth.at(Kind::stiffness)[2][3]);
  }
  std::ranges::sort(relative);
  const std::size_t entry = 18;  // A11 K(3,4)
  ASSERT_EQ(table.entries[entry].column, "K(3,4)");
  EXPECT_NEAR(results[entry].ours.median, relative[2], 1e-12 * std::abs(relative[2]));
  const Print& printed = table.entries[entry].print;
  EXPECT_EQ(results[entry].inside, results[entry].ours.low <= printed.value + printed.half_unit &&
                                       results[entry].ours.high >= printed.value - printed.half_unit);
}

TEST(Reproduction, EveryTableRunsAndSameNumbersForTwoThreads) {
  for (const char* number : {"6.9", "6.18", "6.19"}) {
    const auto one = reproduce(thesis_table(number), {.trials = 2, .threads = 1});
    const auto two = reproduce(thesis_table(number), {.trials = 2, .threads = 2});
    for (std::size_t e = 0; e < one.size(); ++e) {
      EXPECT_TRUE(std::isfinite(one[e].ours.median));
      EXPECT_EQ(one[e].ours.high, two[e].ours.high);
    }
  }
}

}  // namespace
}  // namespace jointid::problems
