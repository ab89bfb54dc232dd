#include "frf/set/scaled_source.hpp"

#include "base/kernel.hpp"

namespace jointid::frf {
namespace {

class ScaledSource final : public FrfSource {
 public:
  ScaledSource(std::unique_ptr<FrfSource> source, FrfHeader header, EntryScale scale)
      : source_(std::move(source)), scale_(std::move(scale)) {
    header_ = std::move(header);
  }

  bool has_covariance() const override { return source_->has_covariance(); }
  FactorShape factor_shape() const override { return source_->factor_shape(); }
  bool has_reference_correlation() const override { return source_->has_reference_correlation(); }

 private:
  /// Calls change(factor, value) for every entry of a block.
  template <class Change>
  void for_each(const Block& block, std::span<Complex> values, Change change) const {
    std::size_t next = 0;
    for (const std::size_t line : block.lines) {
      for (const std::size_t r : block.responses) {
        for (const std::size_t c : block.references) {
          change(scale_.line[line] * (scale_.response[r] * scale_.reference[c]), values[next++]);
        }
      }
    }
  }

  void do_read(const Block& block, std::span<Complex> out) override {
    source_->read(block, out);
    for_each(block, out, [&](Complex factor, Complex& value) { value = product(factor, scale_.conjugate ? std::conj(value) : value); });
  }

  void do_read_variance(const Block& block, std::span<Complex> out) override {
    source_->read_variance(block, out);
    for_each(block, out, [](Complex factor, Complex& variance) { variance = scaled_variance(factor, variance); });
  }

  void do_read_coherence(const Block& block, std::span<double> out) override { source_->read_coherence(block, out); }

  void do_read_covariance(const Block& pairs, std::span<Complex> out) override {
    read_pairs(*source_, pairs, out);
    const std::vector<double> of_pair = pair_factors();
    std::size_t next = 0;
    for (const std::size_t line : pairs.lines) {
      for (const std::size_t pair : pairs.responses) {
        for (const std::size_t c : pairs.references) {
          const double factor = std::norm(scale_.line[line] * scale_.reference[c]) * of_pair[pair];
          out[next] = factor * (scale_.conjugate ? std::conj(out[next]) : out[next]);
          ++next;
        }
      }
    }
  }

  void do_read_factor(const Block& block, std::span<Complex> rows, std::span<double> diagonal) override {
    source_->read_factor(block, rows, diagonal);
    std::size_t next = 0, at = 0;
    for (const std::size_t line : block.lines) {
      for (const std::size_t r : block.responses) {
        for (std::size_t k = 0; k < source_->factor_shape().rank; ++k) {
          for (const std::size_t c : block.references) {
            const double factor = std::abs(scale_.line[line] * scale_.reference[c]) * scale_.response[r];
            rows[next] = factor * (scale_.conjugate ? std::conj(rows[next]) : rows[next]);
            ++next;
          }
        }
        for (const std::size_t c : block.references) {
          if (diagonal.empty()) break;
          diagonal[at++] *= std::norm(scale_.line[line] * (scale_.response[r] * scale_.reference[c]));
        }
      }
    }
  }

  /// A factor of all lines and responses alike turns errors to all references; of those of the references the signs are left.
  void do_read_reference_correlation(std::span<const std::size_t> lines, std::span<const std::size_t> references,
                                     std::span<Complex> out) override {
    source_->read_reference_correlation(lines, references, out);
    std::size_t next = 0;
    for (std::size_t l = 0; l < lines.size(); ++l) {
      for (const std::size_t m : references) {
        for (const std::size_t n : references) {
          const double sign = (scale_.reference[m] < 0.0) == (scale_.reference[n] < 0.0) ? 1.0 : -1.0;
          out[next] = sign * (scale_.conjugate ? std::conj(out[next]) : out[next]);
          ++next;
        }
      }
    }
  }

  /// What the covariances of two responses are multiplied by, line and reference apart.
  std::vector<double> pair_factors() const {
    std::vector<double> factors;
    for (std::size_t r = 0; r < scale_.response.size(); ++r) {
      for (std::size_t s = 0; s <= r; ++s) factors.push_back(scale_.response[r] * scale_.response[s]);
    }
    return factors;
  }

  std::unique_ptr<FrfSource> source_;
  EntryScale scale_;
};

}  // namespace

std::unique_ptr<FrfSource> scaled_source(std::unique_ptr<FrfSource> source, FrfHeader header, EntryScale scale) {
  return std::make_unique<ScaledSource>(std::move(source), std::move(header), std::move(scale));
}

}  // namespace jointid::frf
