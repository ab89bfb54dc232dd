#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "ident/plan/plan.hpp"

namespace jointid::ident {

/// Rows that touch the same unknowns.
struct RowGroup {
  std::vector<std::size_t> unknowns;  ///< of the restriction
  std::string files;                  ///< the substructures, where rows are kept apart by them; else empty
};

/// Which unknowns the rows of a plan touch together, known before any FRF is read.
struct SystemPattern {
  std::size_t unknowns = 0;        ///< columns
  std::size_t supports = 0;        ///< groups of rows, one or a few substructures where they are kept apart
  std::size_t widest = 0;          ///< unknowns that one of them touches
  std::string widest_file;         ///< the substructure, where rows are by parts
  std::vector<std::string> wide_files{};  ///< those that touch more than half of the unknowns: with one of them a dense solver is better
  std::size_t joints = 0;
  std::size_t joint_pairs = 0;     ///< ordered pairs of joints, each with itself too, that share a support: blocks of RᵀR
  std::size_t factor_entries = 0;  ///< numbers in the Cholesky factor of RᵀR, ordered by AMD
  std::vector<std::vector<std::size_t>> joints_of;  ///< [support], ascending

  /// Unknowns squared over two: what a dense factor has.
  double share_of_dense() const;

  /// The blocks of RᵀR as text, joints along both sides, `most` rows and columns at most: ■ where joints are coupled.
  std::vector<std::string> picture(std::size_t most) const;
};

/// That of a plan with these groups of rows.
SystemPattern pattern_of(const Plan& plan, const std::vector<RowGroup>& groups);

/// That of a plan with linear equations; empty for other methods, and below `least` unknowns.
std::optional<SystemPattern> system_pattern(const Plan& plan, std::size_t least);

}  // namespace jointid::ident
