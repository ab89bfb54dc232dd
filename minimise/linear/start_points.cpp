#include "minimise/linear/start_points.hpp"

#include <algorithm>
#include <cmath>

#include "base/random.hpp"

namespace jointid::minimise {

StartPoints::StartPoints(const std::vector<std::vector<double>>& guesses, const Misfit& misfit) {
  std::vector<std::pair<double, std::vector<double>>> ranked;
  for (const std::vector<double>& guess : guesses) {
    for (int half_decade = -8; half_decade <= 8; ++half_decade) {
      std::vector<double> theta = guess;
      for (double& value : theta) value *= std::pow(10.0, 0.5 * half_decade);
      ranked.emplace_back(misfit(theta), theta);
    }
  }
  std::ranges::stable_sort(ranked, {}, [](const auto& each) { return each.first; });
  for (std::size_t k = 0; k < guesses.size() * sizes; ++k) sized_.push_back(std::move(ranked[k].second));
}

std::vector<double> StartPoints::operator()(std::size_t k) const {
  if (k < sized_.size()) return sized_[k];
  std::vector<double> theta = sized_.front();
  for (std::size_t i = 0; i < theta.size(); ++i) theta[i] *= 0.2 + 1.6 * uniform_numbers({.seed = 1, .trial = k}, i)[0];
  return theta;
}

}  // namespace jointid::minimise
