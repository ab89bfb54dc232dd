#pragma once

#include "cli/options/target.hpp"
#include "report/pod/pod_task.hpp"

namespace jointid::cli {

struct PodArguments : report::PodTask {
  Target json, csv, report;
};

}  // namespace jointid::cli
