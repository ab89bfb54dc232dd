#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "ident/check/test/checked_file.hpp"
#include "ident/check/test/span_test.hpp"
#include "ident/result/suspect.hpp"

namespace jointid::ident {

/// Squares of differences that should be noise, over what the noise of the files makes of them: χ² over its degrees of freedom,
/// about 1 when all is well, as the likelihood sees it with a joint that is free at every line.
struct Agreement {
  double ratio = 0.0;     ///< mean over the lines
  double freedom = 0.0;   ///< complex degrees of freedom of all lines; 0: nothing was tested
  bool recorded = false;  ///< the files say how large their noise is
  Dofs rows, columns;
  Eigen::MatrixXd cells;        ///< [row, column] mean over the lines; NaN where nothing was tested
  std::vector<double> by_line;  ///< NaN for a line without a test
  std::vector<double> frequency_hz;
  /// The FRF at one line that makes most of χ², and the share of χ² beyond the degrees of freedom that goes with its column and
  /// line.
  std::size_t worst_line = 0;
  Eigen::Index worst_row = 0, worst_column = 0;
  double worst_share = 0.0, worst_ratio = 0.0;
  /// Of a span test: by which share all FRFs of the assembly would have to be larger, its standard deviation, and how much of it
  /// a wrong law of the noise may make, and the degrees of freedom of the deviation; 0 where that is not told.
  double excess = 0.0, excess_deviation = 0.0, excess_doubt = 0.0, excess_freedom = 0.0;
  double ratio_without = 0.0;  ///< what is left of `ratio` when it is put right

  /// Whether that is more than chance and the uncertainty of noise laws make.
  bool contradicts() const;
  /// Lines whose χ² is 100 times that of the middle line, and at least 100 times its expectation, where they are a fifth at most.
  std::vector<std::size_t> outlying_lines() const;
  /// Ratio and freedom without some lines; the rest as it is.
  Agreement without(const std::vector<std::size_t>& lines) const;
  /// Whether the excess is beyond 0.3 %, up to 10 %, six deviations and its doubt, and leaves no more than noise; and is no chance where
  /// so many are looked at.
  bool tells_gain(double tried) const;
};

/// Of a span test: H_asm − H_sub − H_sub(R,J) F, with the forces F by least squares. No test unless the noise of both files is
/// recorded.
Agreement span_agreement(const SpanSetup& setup, const std::vector<CheckedFile>& files);

/// H_ij − H_ji in a file; where its noise is not recorded, over a law that most of the lines follow.
Agreement mirror_agreement(const CheckedFile& file);
/// The same by the record of the file, or by such a law.
Agreement mirror_agreement(const CheckedFile& file, bool recorded);

/// A pair whose FRFs differ by a factor where the other pairs of a file agree: H_ij = factor·H_ji.
struct PairFactor {
  frf::Dof i, j;
  double factor = 1.0, deviation = 0.0;
  double usual = 0.0;  ///< the middle |factor − 1| of all pairs
};

/// The pair that is furthest off, where that is 3 % or more, three times the middle one, and no chance among `tried` times the pairs
/// of the file; by the scatter of the lines, which noise weighs.
std::optional<PairFactor> factor_of_one_pair(const CheckedFile& file, double tried);

/// The size of H_ij − H_ji of each pair in a file; no DOFs where it has fewer than two in both roles.
ReciprocityMap reciprocity_map(const CheckedFile& file);

}  // namespace jointid::ident
