#pragma once

#include <functional>

#include "gui/work/worker.hpp"
#include "study/comparison.hpp"

namespace jointid::gui {

struct ComparisonWish {
  ident::Scene scene;
  study::Alternatives alternatives;
  std::size_t trials = 200;
  std::uint64_t seed = 1;
};

/// As `jointid compare` does; `so_far` is given what there is after every way. Interrupted, it gives the ways that are done,
/// marked so; throws Interrupted where there are none, and InputError.
study::Comparison run_comparison(const ComparisonWish& wish, const Worker::Watch& watch,
                                 const std::function<void(const study::Comparison&)>& so_far);

}  // namespace jointid::gui
