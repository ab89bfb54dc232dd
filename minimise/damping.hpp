#pragma once

#include <algorithm>

namespace jointid::minimise {

struct DampingRange {
  double first = 1e-4;    ///< to begin with
  double least = 1e-12;   ///< what falls below it is 0: Gauss–Newton steps as they are
  double most = 1e12;     ///< nothing is tried beyond
  double again = 1e-12;   ///< the least to go on with after a step that failed
};

/// Levenberg–Marquardt damping over the steps of a minimisation: ten times more after a step that does not lower the cost, a tenth
/// after one that does.
class Damping {
 public:
  explicit Damping(const DampingRange& range = {}) : range_(range), value_(range.first) {}

  double value() const { return value_; }
  bool is_spent() const { return value_ > range_.most; }
  void more() { value_ = std::max(10.0 * value_, range_.again); }
  void less() { value_ = 0.1 * value_ < range_.least ? 0.0 : 0.1 * value_; }

  /// Steps more and more damped, until `lowers(damping)` says that one lowers the cost; false when none did.
  template <class Lowers>
  bool search(const Lowers& lowers) {
    for (; !is_spent(); more()) {
      if (lowers(value_)) return true;
    }
    return false;
  }

 private:
  DampingRange range_;
  double value_;
};

}  // namespace jointid::minimise
