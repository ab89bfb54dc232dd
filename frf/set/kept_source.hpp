#pragma once

#include <memory>

#include "frf/set/frf_source.hpp"

namespace jointid::frf {

/// A source that remembers what was read of another, so that whoever asks again is answered from memory: every FRF of a file is
/// read once. It keeps nothing until it is told how much it may.
class KeptSource final : public FrfSource {
 public:
  explicit KeptSource(std::unique_ptr<FrfSource> source);
  ~KeptSource() override;

  /// From now on up to so many bytes of values are kept; what is beyond is read again. The first call counts.
  void keep(std::size_t bytes);

  /// Covariances are handed on and never kept.
  bool has_covariance() const override { return source_->has_covariance(); }
  FactorShape factor_shape() const override { return source_->factor_shape(); }
  bool has_error_sums() const override { return source_->has_error_sums(); }
  bool has_reference_correlation() const override { return source_->has_reference_correlation(); }

 private:
  template <class T>
  class Values;

  void do_read(const Block& block, std::span<Complex> out) override;
  void do_read_variance(const Block& block, std::span<Complex> out) override;
  void do_read_coherence(const Block& block, std::span<double> out) override;
  void do_read_covariance(const Block& pairs, std::span<Complex> out) override { read_pairs(*source_, pairs, out); }
  void do_read_factor(const Block& block, std::span<Complex> rows, std::span<double> diagonal) override {
    source_->read_factor(block, rows, diagonal);
  }
  std::vector<ErrorSums> do_read_error_sums(const Block& block) override { return source_->read_error_sums(block); }
  void do_read_reference_correlation(std::span<const std::size_t> lines, std::span<const std::size_t> references,
                                     std::span<Complex> out) override {
    source_->read_reference_correlation(lines, references, out);
  }

  std::unique_ptr<FrfSource> source_;
  std::size_t room_ = 0;  ///< bytes
  std::unique_ptr<Values<Complex>> frfs_, variances_;
  std::unique_ptr<Values<double>> coherences_;
};

}  // namespace jointid::frf
