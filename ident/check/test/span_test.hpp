#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "ident/check/test/checked_file.hpp"

namespace jointid::ident {

/// Which FRFs of a part and of an assembly file say whether the assembly moves as the part does under the excitation and forces
/// at the joint: with R the responses that both have, J the part's joint DOFs and C the references,
///   H_asm(R,C) − H_sub(R,C) = H_sub(R,J) F,  F any J × C,   H_sub(R,c) = 0 for c on another part.
/// `transposed`: the same of the references, by reciprocity of the parts' equations: H_asm(R,C) − H_sub(R,C) = F H_sub(J,C).
/// It holds for every joint, and so needs none; more rows than joint DOFs make it a test.
struct SpanSetup {
  std::size_t part = 0, assembly = 0;  ///< of the files
  bool transposed = false;
  Dofs rows;
  std::vector<Eigen::Index> part_rows, assembly_rows;        ///< of R
  std::vector<Eigen::Index> part_columns, assembly_columns;  ///< of C on the part
  std::vector<Eigen::Index> outer_columns;                   ///< of C on other parts, in the assembly
  std::vector<Eigen::Index> joint;                           ///< of J among the part's columns
  bool weighed = false;  ///< both files know what the errors of R have in common
};

/// All pairs of part and assembly file that can be tested, in both directions. `elsewhere`: coordinates of parts that are
/// not among the files.
std::vector<SpanSetup> span_setups(const std::vector<CheckedFile>& files, const Dofs& joint, const Dofs& elsewhere = {});

/// What is left of it. Rows and columns are scaled by the sizes of the terms, so that relative errors p of all FRFs leave about
/// p. Where the covariances of the errors are known, W⁻¹ of the scaled terms is looked at, W Wᴴ the covariance of a column of the
/// difference to a determinant of 1: what all rows share, as the noise of a blow, no longer hides what one of them has of its own.
struct SpanTest {
  double level = 0.0;  ///< geometric mean over the lines of the rms residual per degree of freedom
  std::size_t lines = 0;
  // with details:
  std::vector<double> share;            ///< [R] of the square sum that freeing this row takes away
  std::vector<double> column;           ///< [C] mean square of what is left, over that of its line: about 1 in all columns
  std::vector<double> gain, deviation;  ///< [R] factor by which the assembly's row must be multiplied, and its standard deviation
  std::vector<double> freedom;          ///< [R] degrees of freedom of that deviation
  std::vector<std::complex<double>> ratio;  ///< [line] assembly over part, in what the forces at the joint do not explain
  std::vector<double> coherence;            ///< [line] of that
  std::vector<double> ratio_hz;             ///< [line]
  std::vector<Eigen::MatrixXcd> residuals;  ///< [line], empty where a value is missing
};

enum class SpanDetail { level, rows, residuals };

SpanTest span_test(const SpanSetup& setup, const std::vector<CheckedFile>& files, SpanDetail detail);

}  // namespace jointid::ident
