#include <algorithm>

#include "coupling/jumps.hpp"
#include "coupling/methods.hpp"
#include "dense/lu.hpp"

namespace jointid::coupling {
namespace {

ComplexMatrix solve_lu(const ComplexMatrix& s, const ComplexMatrix& y) { return dense::solve(s, y); }

/// Conditions of which no two name the same coordinate, and the rest.
std::pair<Conditions, Conditions> next_pairs(const Conditions& conditions) {
  std::vector<Index> taken;
  Conditions now, later;
  for (const Condition& condition : conditions) {
    const auto free = [&](Index i) { return std::ranges::find(taken, i) == taken.end(); };
    const bool pair = free(condition.first) && (!condition.second || free(*condition.second));
    (pair ? now : later).push_back(condition);
    taken.push_back(condition.first);
    if (condition.second) taken.push_back(*condition.second);
  }
  return {std::move(now), std::move(later)};
}

}  // namespace

ComplexMatrix pcc(const MatrixRef& h, const Conditions& conditions, const Wanted& wanted) {
  return one_step<ComplexMatrix>(h, conditions, wanted, solve_lu);
}

ComplexMatrix grc(const MatrixRef& h, const Conditions& conditions, const Wanted& wanted) {
  auto [now, later] = next_pairs(conditions);
  if (later.empty()) return pcc(h, now, wanted);
  return grc(pcc(h, now, everything(h)), later, wanted);
}

}  // namespace jointid::coupling
