#include "ident/likelihood/elimination/arrow_layout.hpp"

#include <algorithm>
#include <numeric>

#include "base/eigen.hpp"

namespace jointid::ident {
namespace {

/// Which columns are lone: those with the fewest elements of D first, while none of their partners is.
std::vector<bool> lone_columns(const LineLayout& layout) {
  const std::size_t n = layout.others;
  std::vector<std::vector<std::size_t>> partners(n);
  std::vector<bool> is_lone(n, false), is_taken(n, false);
  for (const auto [r, k] : layout.drop_nn) {
    partners[r].push_back(k);
    partners[k].push_back(r);
    if (r == k) is_taken[k] = true;
  }
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t k) { return partners[k].size(); });
  for (const std::size_t k : order) {
    if (is_taken[k]) continue;
    is_lone[k] = true;
    for (const std::size_t partner : partners[k]) is_taken[partner] = true;
  }
  return is_lone;
}

}  // namespace

ArrowLayout::ArrowLayout(const LineLayout& layout) : core_first(layout.others, -1), y(at(layout.sub_jj.size())) {
  const std::vector<bool> is_lone = lone_columns(layout);
  std::vector<std::size_t> place(layout.others);
  for (std::size_t k = 0; k < layout.others; ++k) {
    const Eigen::Index count = at(layout.sub_jn_first[k + 1] - layout.sub_jn_first[k]);
    if (is_lone[k]) {
      place[k] = lone.size();
      lone.push_back({k, lone_size, {}});
      lone_size += count;
    } else {
      core.push_back(k);
      core_first[k] = core_x;
      core_x += count;
    }
  }
  for (std::size_t i = 0; i < layout.drop_nn.size(); ++i) {
    const auto [r, k] = layout.drop_nn[i];
    if (is_lone[k]) {
      lone[place[k]].touches.push_back({r, i, true});
    } else if (is_lone[r]) {
      lone[place[r]].touches.push_back({k, i, false});
    } else {
      core_pairs.push_back(i);
    }
  }
}

}  // namespace jointid::ident
