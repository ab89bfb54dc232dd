#pragma once

#include <vector>

#include "ident/check/test/file_tests.hpp"
#include "ident/check/test/span_test.hpp"

namespace jointid::ident {

constexpr double large_misfit = 0.08;  ///< above it, signs and labels of single channels are tried

/// How badly files agree with each other and with physics; smaller is better.
struct Misfit {
  std::vector<double> span;         ///< per setup, SpanTest::level
  std::vector<double> reciprocity;  ///< per file, ReciprocityTest::level
  std::vector<double> imaginary;    ///< per file, 1 − PhaseTest::real_share
  std::vector<double> active;       ///< per file, `activity`
};

/// How far the driving points of a file give energy away: 0 where they take it, up to 3 and 0.5 for each of them. `noise`: relative
/// error of its FRFs.
double activity(const CheckedFile& file, double noise);

/// Which parts of it to work out anew.
struct Touched {
  std::vector<bool> files;
  bool only_span = false;

  bool setup(const SpanSetup& each) const { return files[each.part] || files[each.assembly]; }
};

/// `noise`: relative errors of each file's FRFs, which sizes the imaginary parts that count as active.
Misfit misfit_of(const std::vector<CheckedFile>& files, const std::vector<SpanSetup>& setups, const std::vector<double>& noise,
                 std::size_t threads);

/// `before` with what the touched files change.
Misfit misfit_of(const std::vector<CheckedFile>& files, const std::vector<SpanSetup>& setups, const std::vector<double>& noise,
                 const Misfit& before, const Touched& touched, std::size_t threads);

/// Σ ln(before/after) over span and reciprocity, floored at 0.4 %, and over imaginary shares, plus what becomes passive. 0: no
/// better.
double healing(const Misfit& before, const Misfit& after);

}  // namespace jointid::ident
