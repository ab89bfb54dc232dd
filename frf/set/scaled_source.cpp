#include "frf/set/scaled_source.hpp"

namespace jointid::frf {
namespace {

/// Without the tests for infinities of std::complex.
Complex product(Complex a, Complex b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

class ScaledSource final : public FrfSource {
 public:
  ScaledSource(std::unique_ptr<FrfSource> source, FrfHeader header, EntryScale scale)
      : source_(std::move(source)), scale_(std::move(scale)) {
    header_ = std::move(header);
  }

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

  std::unique_ptr<FrfSource> source_;
  EntryScale scale_;
};

}  // namespace

std::unique_ptr<FrfSource> scaled_source(std::unique_ptr<FrfSource> source, FrfHeader header, EntryScale scale) {
  return std::make_unique<ScaledSource>(std::move(source), std::move(header), std::move(scale));
}

}  // namespace jointid::frf
