#pragma once

#include <span>
#include <string>
#include <vector>

#include "frf/set/frf_system.hpp"
#include "ident/variance/variance_piece.hpp"

namespace jointid::ident {

/// Where the variances of a file come from.
struct FileVariances {
  std::string file;
  VarianceOrigin origin = VarianceOrigin::variance;
  std::size_t unresolved = 0;  ///< FRFs whose scatter is more than noise: their variances are upper bounds (after prepare())
};

/// A sentence for the user when the lines of a file are too coarse to see its noise; empty otherwise.
std::string note(const FileVariances& file);

/// Variances of the measured FRFs rows × columns of one system: what its files say, by the scene's [noise], or estimated from
/// the scatter of the data (variance_origin()); with [identify] smooth_variance, smooth laws fitted to what files say.
/// They hold for a measured value, so FRFs and variances may change between reads (studies); nothing of them is kept but what
/// prepare() finds. Nothing is read before it is asked for.
class Variances {
 public:
  /// From the headers alone; throws as variance_origin(), only about files that have FRFs of the rectangle.
  Variances(frf::FrfSystem& system, const std::vector<frf::Dof>& rows, const std::vector<frf::Dof>& columns,
            const Scene& scene);

  /// Whether prepare() has anything to do; it must then be called before read(), and again when the FRFs have changed.
  bool needs_prepare() const;

  /// Finds the laws that depend on the FRFs (floor, scatter, smoothing); `lines`: the common lines in use, ascending. Reads
  /// FRFs some lines at a time; for the scatter, lines of the files between those in use as well, and some milliseconds
  /// per FRF. Throws InputError (data) for a file with too few lines to see a scatter.
  void prepare(std::span<const std::size_t> lines);

  /// `frf`: what frf::BlockReader::read() gave for the same rectangle and common lines (ascending). `out` gets the variances
  /// of the real and the imaginary part, [line, row, column] as there, (m/N)² or (rad/(N·m))²: NaN where nothing was measured
  /// or the file does not know the variance of what was, zero where the FRF is zero by construction. A coherence of 1 and a
  /// recorded variance of 0 say that the FRF is exact and give 0.
  void read(std::span<const std::size_t> lines, std::span<const Complex> frf, std::span<Complex> out);

  /// One per file that the rectangle has FRFs of, in the order of the system.
  std::vector<FileVariances> origins() const;

 private:
  /// The file's lines that are the common `lines`.
  std::span<const std::size_t> lines_of(const VariancePiece& part, std::span<const std::size_t> lines);
  void find_contested();

  frf::FrfSystem& system_;
  std::size_t columns_;
  std::vector<Complex> background_;
  std::vector<VariancePiece> parts_;
  std::vector<bool> contested_;  ///< of a part: a later one may fill what it lacks
  bool any_contested_ = false;
  std::vector<bool> taken_;  ///< [line, row, column], when parts are contested
  std::vector<std::size_t> source_lines_;
  std::vector<Complex> values_, variances_;
};

}  // namespace jointid::ident
