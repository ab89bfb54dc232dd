#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "base/temporary_file.hpp"
#include "frf/hdf5/hdf5_module.hpp"
#include "frf/set/frf_set.hpp"

namespace jointid::frf {

struct Hdf5WriteOptions {
  std::optional<Quantity> quantity = std::nullopt;  ///< stored quantity, in SI units; default: header.quantity
  std::size_t lines_per_chunk = 0;                  ///< 0: as many as make a chunk of about 512 KiB, at least one
  int compression = 0;                              ///< deflate level 0 (none, the fastest to read) … 9
  bool covariance = false;                          ///< lines carry covariances: layout version 2, else 1
  FactorShape factor = {};                          ///< form of the covariances; rank 0: pairs
  bool reference_correlation = false;               ///< lines have correlations between references, too
  std::string provenance = {};                      ///< root attribute; empty: file_origin()
};

/// Writes a jointid-frf file line by line, so a set can be larger than memory. Until `finish` the data are in a temporary file
/// in the same folder. A writer destroyed without it deletes that file. All functions throw InputError if the disk refuses the
/// data.
class Hdf5Writer {
 public:
  /// Creates the file without FRFs. `header.noise` names the noise record of the lines.
  Hdf5Writer(const std::filesystem::path& path, const FrfHeader& header, const Hdf5WriteOptions& options = {});

  /// Writes lines first … first + count − 1, each [R,C], of receptances and of the header's noise record. That is `variance` of
  /// the receptances or `coherence`, as long as `values`; the other is empty. Covariances have the form of the options. Whole
  /// chunks in order are fastest.
  void write_lines(std::size_t first, std::size_t count, std::span<const Complex> values, std::span<const Complex> variance = {},
                   std::span<const double> coherence = {}, const CovarianceLines& covariance = {});

  /// Completes the file and gives it its name. Throws InputError if a line is missing.
  void finish();

  /// Lines per chunk as chosen.
  std::size_t lines_per_chunk() const;

 private:
  TemporaryFile temporary_;
  std::unique_ptr<LinesOutput> file_;
};

/// Writes a whole set. Covariances have the smaller form if the set has a factor.
void write_hdf5(const FrfSet& set, const std::filesystem::path& path, const Hdf5WriteOptions& options = {});

}  // namespace jointid::frf
