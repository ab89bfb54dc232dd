#pragma once

#include <memory>
#include <span>
#include <vector>

#include "ident/equation_builder.hpp"
#include "ident/variances.hpp"

namespace jointid::ident {

/// A measured FRF with the variances of its real and imaginary part; NaN where not measured.
struct Measured {
  Complex value, variance;

  bool known() const { return !std::isnan(value.real()) && !std::isnan(variance.real()); }
};

/// Which blocks of a system are read, with n non-joint and j joint coordinates.
struct Blocks {
  bool nn = false, jn = false, jj = false;
};

/// The FRFs of one system as a symmetric matrix over some coordinates (reciprocity). Where (r,c) and (c,r) are both measured
/// they are one measurement when they agree far better than their variances allow, and otherwise averaged.
class SymmetricFrfs {
 public:
  /// `coordinates`: n non-joint ones, then joint ones. Throws InputError when variances are asked for that the data do not have.
  SymmetricFrfs(frf::FrfSystem& system, const Scene& scene, const Dofs& coordinates, std::size_t others, const Blocks& blocks);

  /// FRFs read per line.
  std::size_t entries_per_line() const;

  /// Whether variances follow a law of the value, so that better values give better variances.
  bool variances_by_law() const;

  std::vector<FileVariances> origins() const;

  /// Reads common lines of the system (ascending); `first`: lines of the whole problem before them.
  void read(std::span<const std::size_t> lines);

  /// The i-th line read, in the role (row, column) or (column, row).
  Measured at(std::size_t i, std::size_t row, std::size_t column) const;

  /// The variance that line `line` of the system would have at (row, column) for other values: `values` is the symmetric
  /// matrix of all coordinates, NaN where not measured; `pattern` tells how often an FRF was measured (see times()).
  void variances_of(std::size_t line, std::span<const Complex> values);

  /// After variances_of(): half of it where two measurements were averaged.
  Complex variance(std::size_t row, std::size_t column, bool averaged) const;

  /// Whether the i-th line read has two measurements that differ at (row, column).
  bool averaged(std::size_t i, std::size_t row, std::size_t column) const;

 private:
  struct Part {
    std::vector<std::size_t> rows, columns;  ///< in the coordinates
    std::unique_ptr<frf::BlockReader> reader;
    std::unique_ptr<Variances> variances;
  };

  void scatter(const Part& part, std::size_t lines, const std::vector<Complex>& from, std::vector<Complex>& to) const;

  std::size_t size_;
  std::vector<Part> parts_;
  std::vector<Complex> values_, variances_, scratch_, scratch_variance_;
};

}  // namespace jointid::ident
