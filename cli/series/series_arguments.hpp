#pragma once

#include "cli/options/target.hpp"
#include "report/series/align_report.hpp"
#include "report/series/contact_report.hpp"
#include "report/series/delay_task.hpp"
#include "report/series/strain_report.hpp"

namespace jointid::cli {

/// `series delay`: delay, dimension and exponents of one channel.
struct SeriesDelayArguments : report::DelayTask {
  Target json, csv, report;
};

/// `series strain`: displacements of a clamped beam from strain gauges.
struct SeriesStrainArguments : report::StrainTask {
  Target output, json, report;
};

/// `series friction`: the law of a contact from a record of it.
struct SeriesFrictionArguments : report::ContactTask {
  Target json, csv, report;
};

/// `series align`: how late the channels of a periodic record are.
struct SeriesAlignArguments : report::AlignTask {
  Target output, json, report;
};

}  // namespace jointid::cli
