#pragma once

#include <vector>

#include "ident/check/test/file_tests.hpp"
#include "ident/check/test/span_test.hpp"

namespace jointid::ident {

constexpr double significant_span = 6.0;  ///< standard deviations, of gains and ratios of span tests

/// What the tests say in detail, at the lines of a screening.
struct Screening {
  std::vector<SpanTest> span;                ///< per setup
  std::vector<ReciprocityTest> reciprocity;  ///< per file
  std::vector<PhaseTest> phase;              ///< per file
  std::vector<double> noise;                 ///< per file: the smallest level that it is part of, at least 0.3 %; of a file with
                                             ///< covariances what these say
  double chosen_from = 1.0;  ///< as many others might have been looked at in place of these files or references
};

Screening screen(const std::vector<CheckedFile>& files, const std::vector<SpanSetup>& setups, std::size_t threads);

/// Lines for trials and for a screening: fewer where the tests of a line take longer.
std::size_t lines_for(const std::vector<SpanSetup>& setups, std::size_t most, double work);

}  // namespace jointid::ident
