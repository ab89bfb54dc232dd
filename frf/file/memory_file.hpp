#pragma once

#include <filesystem>
#include <memory>
#include <span>

#include "frf/set/frf_source.hpp"

namespace jointid::frf {

/// FRFs in arrays that a caller keeps: views, of which nothing is copied. Shapes as in FrfSet, [F,R,C] and so on, but values and
/// (co)variances are of the quantity of the header, in SI units. The header names variances or coherences where there are any.
struct FrfArrays {
  FrfHeader header;
  std::span<const Complex> values;                   ///< [F,R,C], NaN where not measured
  std::span<const Complex> variance{};               ///< [F,R,C] or empty
  std::span<const double> coherence{};               ///< [F,R,C] or empty
  std::span<const Complex> covariance{};             ///< [F,P,C] or empty
  std::size_t rank = 0;                              ///< columns K of a factor in place of `covariance`
  std::span<const Complex> factor{};                 ///< [F,R,K,C] as CovarianceFactor::rows
  std::span<const double> factor_diagonal{};         ///< [F,R,C] or empty, beside a factor
  std::span<const Complex> reference_correlation{};  ///< [F,C,C] or empty, beside covariances

  FactorShape factor_shape() const { return {rank, !factor_diagonal.empty()}; }
};

/// Such arrays as a source: receptances, as ever. Throws InputError where they are not as long as the header says.
std::unique_ptr<FrfSource> from_arrays(std::shared_ptr<const FrfArrays> arrays);

/// Arrays under the name of a file: as long as this lives, open() finds them by its path, so that a scene can name them wherever
/// it can name a file. The path is of this process alone and of no file system.
class MemoryFile {
 public:
  /// Throws InputError as from_arrays().
  explicit MemoryFile(std::shared_ptr<const FrfArrays> arrays);
  ~MemoryFile();
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// The arrays of a MemoryFile as a source; null for every other path.
std::unique_ptr<FrfSource> open_memory_file(const std::filesystem::path& path);

}  // namespace jointid::frf
