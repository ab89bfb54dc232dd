#pragma once

#include <Eigen/Core>
#include <vector>

#include "base/eigen.hpp"

namespace jointid::response {

/// The harmonics n of a periodic quantity q(θ) = Σ Re Q_n e^{inθ}, ascending, n ≥ 0. As unknowns they are real: Re Q_n, Im Q_n
/// for each in turn, of n = 0 the real part alone.
class Harmonics {
 public:
  /// Throws InputError (usage) unless the numbers ascend, are not negative, and one of them is above 0.
  explicit Harmonics(std::vector<int> numbers);

  /// 1, 3, … or 0, 1, 2, … up to `largest`.
  static Harmonics odd(int largest);
  static Harmonics all(int largest);

  Eigen::Index size() const { return at(numbers_.size()); }
  int operator[](Eigen::Index i) const { return numbers_[static_cast<std::size_t>(i)]; }
  int largest() const { return numbers_.back(); }
  bool only_odd() const { return only_odd_; }
  const std::vector<int>& numbers() const { return numbers_; }

  /// Place of a harmonic, or −1.
  Eigen::Index find(int harmonic) const;

  /// Number of real unknowns, and where those of the i-th harmonic begin.
  Eigen::Index unknowns() const { return 2 * size() - (numbers_.front() == 0 ? 1 : 0); }
  Eigen::Index offset(Eigen::Index i) const { return 2 * i - (i > 0 && numbers_.front() == 0 ? 1 : 0); }

  Eigen::VectorXd pack(const Eigen::Ref<const Eigen::VectorXcd>& amplitudes) const;
  Eigen::VectorXcd unpack(const Eigen::Ref<const Eigen::VectorXd>& unknowns) const;

  bool operator==(const Harmonics&) const = default;

 private:
  std::vector<int> numbers_;
  bool only_odd_ = true;
};

}  // namespace jointid::response
