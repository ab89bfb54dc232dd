#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "nist_file.hpp"
#include "stability/refined_solution.hpp"
#include "tests/require.hpp"

namespace jointid::stability {
namespace {

using Exact = boost::multiprecision::cpp_bin_float_50;

/// How the columns of the problem are formed: in double precision, as a program would, or from the decimals of the file.
enum class Columns { in_double, exact };

Rows rows_of(const NistFile& file, Columns columns) {
  const std::size_t unknowns = file.parameters.size(), predictors = file.data.front().size() - 1;
  const bool intercept = file.name.rfind("NoInt", 0) != 0;
  Rows rows{unknowns, {}, {}};
  const auto push = [&](const Exact& value) {
    rows.high.push_back(static_cast<double>(value));
    if (columns == Columns::exact) rows.low.push_back(static_cast<double>(Exact(value - rows.high.back())));
  };
  for (const std::vector<std::string>& line : file.data) {
    std::vector<Exact> x;
    for (const std::string& word : line) {
      const Exact decimal(word);
      x.push_back(columns == Columns::exact ? decimal : Exact(static_cast<double>(decimal)));
    }
    for (std::size_t j = 0; j < unknowns; ++j) {
      const std::size_t power = j + (intercept ? 0 : 1);
      if (predictors > 1) {
        push(power == 0 ? Exact(1) : x[power]);
      } else {
        push(columns == Columns::exact ? Exact(pow(x[1], power)) : Exact(std::pow(static_cast<double>(x[1]), static_cast<double>(power))));
      }
    }
    push(x[0]);
  }
  return rows;
}

/// Certified digits of the worst parameter, at most 15: so many are given.
double digits_of(const NistFile& file, const std::vector<double>& y) {
  double worst = 1e-15;
  for (std::size_t j = 0; j < y.size(); ++j) {
    const double certified = std::stod(file.parameters[j].front());
    worst = std::max(worst, std::abs(y[j] - certified) / std::abs(certified));
  }
  return -std::log10(worst);
}

class NistLinear : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    const auto path = nist_folder("linear") / (std::string(GetParam()) + ".dat");
    if (!std::filesystem::exists(path)) JOINTID_SKIP("no " << path << "; set JOINTID_EXTERNAL_DATA");
  }
  NistFile file() const { return NistFile(nist_folder("linear") / (std::string(GetParam()) + ".dat")); }
};

TEST_P(NistLinear, RefinedSolutionFromColumnsInDouble) {
  const NistFile problem = file();
  const Refined found = solve_refined(rows_of(problem, Columns::in_double));
  EXPECT_TRUE(found.converged);
  const bool filip = problem.name == "Filip";  // its columns lose seven digits when they are rounded
  EXPECT_GE(digits_of(problem, found.y), filip ? 7.0 : 13.0);
  RecordProperty("digits", std::to_string(digits_of(problem, found.y)));
}

TEST_P(NistLinear, RefinedSolutionFromExactColumns) {
  const NistFile problem = file();
  const Refined found = solve_refined(rows_of(problem, Columns::exact));
  EXPECT_TRUE(found.converged);
  EXPECT_GE(digits_of(problem, found.y), 13.0);
}

INSTANTIATE_TEST_SUITE_P(Certified, NistLinear,
                         testing::Values("Norris", "Pontius", "NoInt1", "NoInt2", "Filip", "Longley", "Wampler1", "Wampler2", "Wampler3",
                                         "Wampler4", "Wampler5"));

}  // namespace
}  // namespace jointid::stability
