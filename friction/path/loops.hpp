#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "friction/path/record.hpp"

namespace jointid::friction {

/// One cycle: displacements rise from the lower reversal at sample 0 to the upper one at `turn` and fall from there to the last.
struct Loop {
  Record record;
  std::size_t turn = 0;

  /// Half the way from the lower to the upper reversal.
  double amplitude() const;
  /// ∮F du, the chord from the last sample to the first included.
  double energy() const;
};

/// Samples at which the displacement turns: extremes that the motion reaches over at least `least_travel` and leaves by as much,
/// alternately upper and lower; smaller movements are noise. The first and the last sample of the record are none.
std::vector<std::size_t> reversals(std::span<const double> displacement, double least_travel);

/// The whole cycles of a continuous record, one after the other from its first reversal on; what comes before it (the first
/// loading) and after the last whole cycle is left out. Of cycles that begin at the upper reversal the rising branch is put first.
/// `least_travel` as in reversals().
std::vector<Loop> loops(const Record& record, double least_travel);

/// The point about which a steady loop is symmetric: the middle of its displacements, and of the forces the mean of both branches'
/// means over displacement.
struct LoopCentre {
  double displacement = 0.0, force = 0.0;
};
LoopCentre centre(const Loop& loop);

/// The loop about the origin, with reversals at ± amplitude().
Loop centred(Loop loop);

/// The initial loading curve that Masing's rule makes of the loop's branches: both halved and begun at their reversal, the falling
/// one after the rising one. Displacements need not increase.
Record masing_curve(const Loop& loop);

}  // namespace jointid::friction
