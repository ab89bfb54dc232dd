#pragma once

#include <span>
#include <vector>

#include "base/complex.hpp"
#include "frf/noise/variance_law.hpp"
#include "frf/set/block_pieces.hpp"
#include "frf/set/frf_source.hpp"
#include "ident/scene/variance_origin.hpp"

namespace jointid::ident {

/// Variances of the FRFs that one file contributes to a rectangle, in the order [line, response, reference] of the file.
class VariancePiece {
 public:
  /// Throws as variance_origin(). `source` must live longer.
  VariancePiece(frf::FrfSource& source, frf::BlockPiece piece, const Scene& scene);

  const frf::BlockPiece& piece() const { return piece_; }
  const frf::FrfSource& source() const { return source_; }
  VarianceOrigin origin() const { return origin_; }
  bool needs_prepare() const;
  /// FRFs whose scatter is more than noise (Scatter::unresolved), by the last prepare().
  std::size_t unresolved() const { return unresolved_; }

  /// Finds the laws that depend on the values, for these lines of the file (those in use, ascending): a floor, the scatter,
  /// the smoothing. Throws InputError (data) as estimate_scatter().
  void prepare(std::span<const std::size_t> lines);

  /// The measured values themselves.
  void read_values(std::span<const std::size_t> lines, std::span<Complex> out);

  /// What the file says: NaN where it has no variance or a coherence of 0.
  void read_recorded(std::span<const std::size_t> lines, std::span<const Complex> values, std::span<Complex> out);

  /// Variances of the measured `values`, recorded or by law.
  void read(std::span<const std::size_t> lines, std::span<const Complex> values, std::span<Complex> out);

 private:
  frf::Block block(std::span<const std::size_t> lines) const { return {lines, piece_.responses, piece_.references}; }
  bool is_recorded() const;
  std::vector<frf::VarianceLaw> laws_with_floor();
  void from_coherence(std::span<const std::size_t> lines, std::span<const Complex> values, std::span<Complex> out);
  void from_law(std::span<const std::size_t> lines, std::span<const Complex> values, std::span<Complex> out) const;

  frf::FrfSource& source_;
  frf::BlockPiece piece_;
  VarianceOrigin origin_;
  frf::NoiseModel model_;
  bool smooth_;
  std::size_t unresolved_ = 0;
  std::vector<frf::VarianceLaw> laws_;  ///< one per FRF of the piece; unused for recorded variances
  std::vector<double> coherence_;       ///< scratch
};

}  // namespace jointid::ident
