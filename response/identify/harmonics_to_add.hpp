#pragma once

#include <vector>

#include "response/identify/measured_state.hpp"

namespace jointid::response {

/// The harmonics that a model of measured states may have, and how many come next: odd ones alone where the states have no
/// others.
class HarmonicsToAdd {
 public:
  HarmonicsToAdd(const Receptance& structure, const std::vector<MeasuredState>& states, int largest);

  /// The largest measured one.
  int first() const { return first_; }

  /// All up to this one.
  std::vector<int> to(int largest) const;

  /// The next largest one, or 0 when it is above the most or no state's structure is known there.
  int after(int largest) const;

 private:
  const Receptance& structure_;
  const std::vector<MeasuredState>& states_;
  int most_, first_ = 1;
  bool odd_ = true;
};

}  // namespace jointid::response
