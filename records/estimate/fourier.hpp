#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "base/complex.hpp"

namespace jointid::records {

/// X_k = Σ_t x_t e^(−2πi k t / N), k = 0 … N/2, of N real numbers, again and again of one N. By kissfft (Eigen), of any N, fast
/// where N has small prime factors.
class Fourier {
 public:
  explicit Fourier(std::size_t samples);
  ~Fourier();
  Fourier(const Fourier&) = delete;
  Fourier& operator=(const Fourier&) = delete;

  std::size_t samples() const { return samples_; }
  std::size_t lines() const { return samples_ / 2 + 1; }

  std::vector<Complex> transform(std::span<const double> x);

 private:
  struct Plan;
  std::size_t samples_;
  std::unique_ptr<Plan> plan_;
};

}  // namespace jointid::records
