#pragma once

#include <memory>
#include <span>
#include <vector>

#include "ident/equations/equation_builder.hpp"
#include "ident/likelihood/data/line_errors.hpp"
#include "ident/likelihood/data/measured_frfs.hpp"
#include "ident/variance/frf_covariances.hpp"
#include "ident/variance/frf_error_sums.hpp"
#include "ident/variance/variances.hpp"

namespace jointid::ident {

/// Which blocks of a system are read, with n non-joint and j joint coordinates.
struct Blocks {
  bool nn = false, jn = false, jj = false;
};

/// FRFs there and back: squares of the parts of their difference over what their variances make of it, each at most 25, and how many.
struct MirrorDifferences {
  double squares = 0.0, count = 0.0;
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

  /// Finds the laws of the variances that depend on the FRFs of all `lines` in use (common lines, ascending): before read(),
  /// and again when the FRFs have changed.
  void prepare(std::span<const std::size_t> lines);

  /// From now on FRFs there and back are two measurements although they agree: they are exact, and are to be measured apart.
  void take_pairs_apart() { are_pairs_apart_ = true; }

  /// Reads some common lines of the system (ascending).
  void read(std::span<const std::size_t> lines);

  /// The i-th line read, in the role (row, column) or (column, row).
  Measured at(std::size_t i, std::size_t row, std::size_t column) const;

  /// Adds those of the i-th line read at (row, column) and back; nothing where only one was measured, or they are copies.
  void add_difference(std::size_t i, std::size_t row, std::size_t column, MirrorDifferences& to) const;

  /// Whether the files say what coupled FRFs have in common; from forget_error_sums() on these are taken for independent.
  bool has_error_sums() const { return sums_ != nullptr; }
  void forget_error_sums() { sums_.reset(); }

  /// What the errors of at() have in common on the i-th line read; empty without covariances and sums of errors.
  std::shared_ptr<const LineErrors> errors(std::size_t i) const;

  /// Works out the variances that line `line` of the system would have for other values; NaN where not measured.
  void variances_of(std::size_t line, const Symmetric<Complex>& values);

  /// After variances_of(): half of it where two measurements were averaged.
  Complex variance(std::size_t row, std::size_t column, bool averaged) const;

 private:
  struct Part {
    std::vector<std::size_t> rows, columns;  ///< in the coordinates
    std::unique_ptr<frf::BlockReader> reader;
    std::unique_ptr<Variances> variances;
  };

  enum class Role { there, back, both };

  /// Which measurements make at().
  Role role(const Measured& there, const Measured& back) const;
  ErrorTerms terms(std::size_t i, std::size_t row, std::size_t column) const;
  double correlation_there_and_back(std::size_t i, std::size_t row, std::size_t column) const;
  void add_terms(std::size_t i, std::size_t row, std::size_t column, double weight, ErrorTerms& out) const;
  void take_variances_of_laws(std::size_t lines);
  void scatter(const Part& part, std::size_t lines, const std::vector<Complex>& from, std::vector<Complex>& to) const;

  std::size_t size_;
  bool are_pairs_apart_ = false;
  std::vector<Part> parts_;
  std::unique_ptr<FrfCovariances> covariances_;  ///< where there are any
  std::unique_ptr<FrfErrorSums> sums_;           ///< the same
  std::vector<Complex> values_, variances_, scratch_, scratch_variance_;
};

}  // namespace jointid::ident
