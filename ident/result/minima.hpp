#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ident/result/solution.hpp"

namespace jointid::ident {

/// The minima that several starts of an iterative method ended in, each told once.
class MinimumList {
 public:
  /// Whether two ends are the same minimum.
  using Same = std::function<bool(const FoundMinimum& a, const FoundMinimum& b)>;

  void add(FoundMinimum minimum, const Same& same);

  /// Best first; those that fit as well as the best, that is with a cost of at most `limit`, say whether the joint is unique.
  MinimumSearch result(double limit) const;

  bool empty() const { return minima_.empty(); }

 private:
  std::vector<FoundMinimum> minima_;
};

}  // namespace jointid::ident
