#include "response/fourier/harmonics.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "base/error.hpp"

namespace jointid::response {

Harmonics::Harmonics(std::vector<int> numbers) : numbers_(std::move(numbers)) {
  const auto fail = [](std::string problem) {
    throw InputError({.kind = ErrorKind::usage,
                      .file = "",
                      .place = "harmonics",
                      .problem = std::move(problem),
                      .remedy = "give ascending numbers such as [1, 3, 5] or [0, 1, 2, 3]"});
  };
  if (numbers_.empty() || numbers_.back() < 1) fail("no harmonic above 0");
  if (numbers_.front() < 0) fail("harmonic " + std::to_string(numbers_.front()) + " is negative");
  for (std::size_t i = 1; i < numbers_.size(); ++i) {
    if (numbers_[i] <= numbers_[i - 1]) fail("harmonic " + std::to_string(numbers_[i]) + " does not ascend");
  }
  if (numbers_.back() > 1000) fail("harmonic " + std::to_string(numbers_.back()) + " is above 1000");
  only_odd_ = std::ranges::all_of(numbers_, [](int n) { return n % 2 == 1; });
}

Harmonics Harmonics::odd(int largest) {
  std::vector<int> numbers;
  for (int n = 1; n <= largest; n += 2) numbers.push_back(n);
  return Harmonics(std::move(numbers));
}

Harmonics Harmonics::all(int largest) {
  std::vector<int> numbers;
  for (int n = 0; n <= largest; ++n) numbers.push_back(n);
  return Harmonics(std::move(numbers));
}

Eigen::Index Harmonics::find(int harmonic) const {
  const auto found = std::ranges::lower_bound(numbers_, harmonic);
  return found != numbers_.end() && *found == harmonic ? found - numbers_.begin() : -1;
}

Eigen::VectorXd Harmonics::pack(const Eigen::Ref<const Eigen::VectorXcd>& amplitudes) const {
  Eigen::VectorXd unknowns(this->unknowns());
  for (Eigen::Index i = 0; i < size(); ++i) {
    unknowns(offset(i)) = amplitudes(i).real();
    if ((*this)[i] > 0) unknowns(offset(i) + 1) = amplitudes(i).imag();
  }
  return unknowns;
}

Eigen::VectorXcd Harmonics::unpack(const Eigen::Ref<const Eigen::VectorXd>& unknowns) const {
  Eigen::VectorXcd amplitudes(size());
  for (Eigen::Index i = 0; i < size(); ++i) {
    amplitudes(i) = {unknowns(offset(i)), (*this)[i] > 0 ? unknowns(offset(i) + 1) : 0.0};
  }
  return amplitudes;
}

}  // namespace jointid::response
