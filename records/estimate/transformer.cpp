#include "records/estimate/transformer.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <numeric>

#include "records/estimate/window.hpp"

namespace jointid::records {
namespace {

void multiply(std::vector<double>& x, const std::vector<double>& w) {
  std::ranges::transform(x, w, x.begin(), std::multiplies<>());
}

}  // namespace

Transformer::Transformer(const FrfOptions& options, std::size_t samples, double rate_hz)
    : options_(options), rate_hz_(rate_hz), fourier_(samples), window_(samples, 1.0) {
  if (options.segments) window_ = make_window(options.segments->window, samples);
  if (options.decay_time_s) window_ = exponential_window(samples, *options.decay_time_s, rate_hz);
}

std::vector<Complex> Transformer::transform(const Channel& channel, const Blow& blow) {
  const auto first = channel.samples.begin() + static_cast<std::ptrdiff_t>(blow.first);
  std::vector<double> x(first, first + static_cast<std::ptrdiff_t>(blow.length));
  if (options_.remove_mean) {
    const double mean = std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(x.size());
    for (double& sample : x) sample -= mean;
  }
  if (options_.force_window_s && channel.kind == ChannelKind::force) {
    multiply(x, force_window(x.size(), *blow.peak - blow.first, *options_.force_window_s, rate_hz_));
  }
  multiply(x, window_);
  std::vector<Complex> lines = fourier_.transform(x);
  if (channel.start_s != 0.0) shift(lines, channel.start_s);
  return lines;
}

/// e^(−s t) of a channel that begins at t; under an exponential window s = iω + 1/decay time.
void Transformer::shift(std::vector<Complex>& lines, double start_s) const {
  const double decay = options_.decay_time_s ? std::exp(-start_s / *options_.decay_time_s) : 1.0;
  const double spacing_hz = rate_hz_ / static_cast<double>(fourier_.samples());
  for (std::size_t k = 0; k < lines.size(); ++k)
    lines[k] *= std::polar(decay, -angular(spacing_hz * static_cast<double>(k)) * start_s);
}

}  // namespace jointid::records
