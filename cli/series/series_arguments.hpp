#pragma once

#include "cli/options/target.hpp"
#include "tasks/series/align.hpp"
#include "tasks/series/contact.hpp"
#include "tasks/series/delay.hpp"
#include "tasks/series/reversal.hpp"
#include "tasks/series/strain.hpp"

namespace jointid::cli {

/// `series delay`: delay, dimension and exponents of one channel.
struct SeriesDelayArguments : tasks::DelayTask {
  Target json, csv, report;
};

/// `series strain`: displacements of a clamped beam from strain gauges.
struct SeriesStrainArguments : tasks::StrainTask {
  Target output, json, report;
};

/// `series friction`: the law of a contact from a record of it.
struct SeriesFrictionArguments : tasks::ContactTask {
  Target json, csv, report;
};

/// `series reversal`: the stiffness of a contact from the slopes of its force after reversals.
struct SeriesReversalArguments : tasks::ReversalTask {
  Target json, report;
};

/// `series align`: how late the channels of a periodic record are.
struct SeriesAlignArguments : tasks::AlignTask {
  Target output, json, report;
};

}  // namespace jointid::cli
