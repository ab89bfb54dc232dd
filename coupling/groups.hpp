#pragma once

#include <cstddef>
#include <vector>

#include "coupling/condition.hpp"

namespace jointid::coupling {

/// Which coordinates move as one, by union-find with signs; coordinate 0 … count−1 and the ground.
class Groups {
 public:
  enum class Outcome { joined, implied, contradiction };

  explicit Groups(std::size_t count);

  /// x_first = sign·x_second, or x_first = 0. Contradiction: it would force a moving coordinate x = −x.
  Outcome join(const Condition& condition);

  bool grounded(Index coordinate) const { return root(coordinate) == ground_; }
  bool same(Index one, Index two) const { return root(one) == root(two); }
  /// s of x_one = s·x_two for two that are the same.
  double sign_between(Index one, Index two) const { return sign(one) * sign(two); }

 private:
  Index root(Index i) const;
  double sign(Index i) const;

  Index ground_;
  std::vector<Index> parent_;  ///< the ground last
  std::vector<double> sign_;   ///< to the parent
};

}  // namespace jointid::coupling
