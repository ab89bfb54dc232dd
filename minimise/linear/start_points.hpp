#pragma once

#include <functional>
#include <optional>
#include <vector>

namespace jointid::minimise {

/// Starts of an iteration from joints that were guessed. First the guesses times 10^-4 to 10^4 in half decades, those that misfit
/// least first, five of them for every guess: the shape of a joint is often better known than its size. Then random ones: the
/// best with every element changed by up to ±80 %.
class StartPoints {
 public:
  using Misfit = std::function<double(const std::vector<double>& theta)>;

  StartPoints(const std::vector<std::vector<double>>& guesses, const Misfit& misfit);

  /// The k-th start.
  std::vector<double> operator()(std::size_t k) const;

  static constexpr std::size_t sizes = 5;  ///< of one guess

 private:
  std::vector<std::vector<double>> sized_;
};

}  // namespace jointid::minimise
