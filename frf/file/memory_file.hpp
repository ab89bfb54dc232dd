#pragma once

#include <filesystem>
#include <memory>
#include <span>

#include "frf/set/frf_source.hpp"

namespace jointid::frf {

/// Views of FRFs in arrays that a caller keeps; nothing is copied. Shapes as in FrfSet, [F,R,C] and so on. Values and
/// (co)variances are of the quantity of the header, in SI units. The header names variances or coherences if there are any.
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

/// Such arrays as a source of receptances. Throws InputError if their lengths disagree with the header.
std::unique_ptr<FrfSource> from_arrays(std::shared_ptr<const FrfArrays> arrays);

/// Arrays under the name of a file. While this exists, open() finds them by its path, and a scene can name them like a file. The
/// path is valid in this process alone and in no file system.
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
