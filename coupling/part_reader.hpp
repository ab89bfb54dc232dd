#pragma once

#include <optional>

#include "coupling/assembly.hpp"
#include "coupling/condition.hpp"
#include "coupling/propagation.hpp"
#include "frf/noise/noise.hpp"

namespace jointid::coupling {

/// Reads the FRFs of one part between given DOFs, and their variances, line by line.
class PartReader {
 public:
  /// `noise`: the law for files that have neither variances nor coherences. With `variance` throws InputError (data) for such
  /// files when there is no law, and for coherences of less than two averages.
  PartReader(const Part& part, std::vector<frf::Dof> rows, std::vector<frf::Dof> columns, bool variance,
             const std::optional<frf::NoiseModel>& noise);

  std::size_t size() const { return rows_.size() * columns_.size(); }

  /// out[line, row, column] for lines of the part's system; NaN where not measured.
  void read(std::span<const std::size_t> lines, std::span<Complex> out);

  /// Variances of real and imaginary part of the same; 0 between files.
  void read_variance(std::span<const std::size_t> lines, std::span<Complex> out);

  /// Whether a file of the part has covariances beside its variances, and no FRF stands in for its transpose.
  bool has_covariance() const;

  /// The least degrees of freedom that covariances of its files come from, averages or repeats − 1; 0 where no file tells.
  double covariance_freedom() const;

  /// Covariances of the rows of each column, out[line, column, row, row]; 0 where independent or not known.
  void read_covariance(std::span<const std::size_t> lines, std::span<Complex> out);

  /// What the errors of its columns have in common on a line where files tell, rows and columns counted as above.
  std::vector<SharedColumns> shared_columns(std::size_t line);

 private:
  void read_piece(const frf::BlockPiece& piece, std::span<const std::size_t> lines, std::vector<Complex>& values,
                  std::vector<Complex>& variances);

  std::shared_ptr<frf::FrfSystem> system_;
  std::vector<frf::Dof> rows_, columns_;
  frf::BlockReader reader_;
  std::vector<frf::BlockPiece> pieces_;  ///< for variances
  std::optional<frf::NoiseModel> noise_;
};

}  // namespace jointid::coupling
