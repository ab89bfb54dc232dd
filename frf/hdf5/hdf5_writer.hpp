#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>

#include "base/temporary_file.hpp"
#include "frf/hdf5/hdf5_module.hpp"
#include "frf/set/frf_set.hpp"

namespace jointid::frf {

struct Hdf5WriteOptions {
  std::optional<Quantity> quantity = std::nullopt;  ///< stored as, in SI units; default: header.quantity
  std::size_t lines_per_chunk = 0;                  ///< 0: as many as make a chunk of about 512 KiB, at least one
  int compression = 0;                              ///< deflate level 0 (none, the fastest to read) … 9
  bool covariance = false;                          ///< lines carry covariances: layout version 2, else 1
  FactorShape factor = {};                          ///< in this form; of rank 0 as pairs
  bool reference_correlation = false;               ///< lines carry that, too
};

/// Writes a jointid-frf file line by line, so that a set larger than memory can be made. Until `finish` the
/// data lie under a temporary name in the same folder; a writer destroyed without it leaves nothing behind.
/// Everything throws InputError when the disk does not take it.
class Hdf5Writer {
 public:
  /// Creates the file with all but the FRFs. `header.noise` says which noise record the lines will carry.
  Hdf5Writer(const std::filesystem::path& path, const FrfHeader& header, const Hdf5WriteOptions& options = {});

  /// Writes lines first … first + count − 1, each [R,C], of receptances and of the header's noise record:
  /// `variance` of the receptances or `coherence`, as long as `values`, the other empty; covariances in the form
  /// that the options ask for. Fastest in whole chunks, in order.
  void write_lines(std::size_t first, std::size_t count, std::span<const Complex> values, std::span<const Complex> variance = {},
                   std::span<const double> coherence = {}, const CovarianceLines& covariance = {});

  /// Completes the file and gives it its name. Throws InputError when a line was never written.
  void finish();

  /// Lines per chunk as chosen.
  std::size_t lines_per_chunk() const;

 private:
  TemporaryFile temporary_;
  std::unique_ptr<LinesOutput> file_;
};

/// Writes a whole set, its covariances in the form that is smaller where it has a factor.
void write_hdf5(const FrfSet& set, const std::filesystem::path& path, const Hdf5WriteOptions& options = {});

}  // namespace jointid::frf
