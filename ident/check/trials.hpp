#pragma once

#include <string>
#include <functional>
#include <vector>

#include "ident/check/misfit.hpp"

namespace jointid::ident {

/// A factor between units that are mistaken for each other.
struct UnitFactor {
  double factor = 1.0;
  std::string words;  ///< "g in place of m/s²"; empty: no such factor
};

/// The factor between units within `tolerance` (of its logarithm) of a measured one, or the measured one without words.
UnitFactor nearest_unit(double measured, double tolerance);

/// A mistake that may have been made, and how to undo it.
struct MistakeTrial {
  SuspectKind kind = SuspectKind::sign;
  std::vector<std::size_t> files;  ///< that change
  Dofs dofs;
  std::string what;    ///< "the sensor at 125:+Y points the other way"
  std::string remedy;  ///< of the first file
  std::function<void(std::vector<CheckedFile>&)> undo;
  double bonus = 0.0;      ///< what the data say for it beside the healing
  double least_score = 0.4;  ///< of a trial that counts
  bool only_span = false;  ///< of no effect on reciprocity and signs; takes all lines that were read
  /// What to compare with, where undoing smooths as well: the same with the mistake left in.
  std::function<void(std::vector<CheckedFile>&)> leave{};
  /// Of a mistake in some references of a file alone: these, and the same mistake in others of them.
  Dofs references{};
  std::function<MistakeTrial(const Dofs& references)> in_others{};
};

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

/// The mistakes that are worth a trial; none where nothing stands out.
std::vector<MistakeTrial> trials_of(const std::vector<CheckedFile>& files, const std::vector<SpanSetup>& setups,
                             const Screening& screening, const Misfit& misfit);

/// Lines for trials and for a screening: fewer where the tests of a line take longer.
std::size_t lines_for(const std::vector<SpanSetup>& setups, std::size_t most, double work);

/// [data.files."NAME"] and a line below it.
std::string remedy_in(const std::string& file, const std::string& line);

}  // namespace jointid::ident
