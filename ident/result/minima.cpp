#include "ident/result/minima.hpp"

#include <algorithm>

namespace jointid::ident {

void MinimumList::add(FoundMinimum minimum, const Same& same) {
  const auto known = std::ranges::find_if(minima_, [&](const FoundMinimum& each) { return same(each, minimum); });
  if (known == minima_.end()) {
    minima_.push_back(std::move(minimum));
    return;
  }
  minimum.starts += known->starts;
  if (minimum.cost < known->cost) {
    *known = std::move(minimum);
  } else {
    known->starts = minimum.starts;
  }
}

MinimumSearch MinimumList::result(double limit) const {
  MinimumSearch out{minima_, 0};
  std::ranges::stable_sort(out.minima, {}, &FoundMinimum::cost);
  out.equally_good =
      static_cast<std::size_t>(std::ranges::count_if(out.minima, [&](const FoundMinimum& each) { return each.cost <= limit; }));
  return out;
}

}  // namespace jointid::ident
