#include "records/estimate/fourier.hpp"

#include <cassert>
#include <unsupported/Eigen/FFT>

namespace jointid::records {

struct Fourier::Plan {
  Eigen::FFT<double> fft;
  std::vector<Complex> in, out;
};

Fourier::Fourier(std::size_t samples) : samples_(samples), plan_(std::make_unique<Plan>()) {
  plan_->in.resize(samples);
  plan_->out.resize(samples);
}

Fourier::~Fourier() = default;

std::vector<Complex> Fourier::transform(std::span<const double> x) {
  assert(x.size() == samples_);
  // As complex numbers: kissfft's transform of real ones has no odd lengths.
  plan_->in.assign(x.begin(), x.end());
  plan_->fft.fwd(plan_->out.data(), plan_->in.data(), static_cast<Eigen::Index>(samples_));
  return {plan_->out.begin(), plan_->out.begin() + static_cast<std::ptrdiff_t>(lines())};
}

}  // namespace jointid::records
