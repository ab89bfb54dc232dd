#include "coupling/coupled_source.hpp"

#include <algorithm>
#include <limits>

namespace jointid::coupling {
namespace {

class CoupledSource final : public frf::FrfSource {
 public:
  explicit CoupledSource(std::unique_ptr<AssemblyReader> reader) : reader_(std::move(reader)) { header_ = reader_->header(); }

  bool has_error_sums() const override { return reader_->options().uncertainty; }

 private:
  std::vector<frf::ErrorSums> do_read_error_sums(const frf::Block& block) override { return reader_->read_errors(block); }

  void do_read(const frf::Block& block, std::span<Complex> out) override { reader_->read(block, out); }

  void do_read_variance(const frf::Block& block, std::span<Complex> out) override {
    values_.resize(out.size());
    reader_->read(block, values_, out);
  }

  void do_read_coherence(const frf::Block&, std::span<double> out) override {
    std::ranges::fill(out, std::numeric_limits<double>::quiet_NaN());
  }

  std::unique_ptr<AssemblyReader> reader_;
  std::vector<Complex> values_;
};

}  // namespace

std::unique_ptr<frf::FrfSource> as_source(std::unique_ptr<AssemblyReader> reader) {
  return std::make_unique<CoupledSource>(std::move(reader));
}

}  // namespace jointid::coupling
