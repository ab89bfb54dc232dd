#pragma once

#include "cli/options/target.hpp"
#include "tasks/pod/pod_task.hpp"

namespace jointid::cli {

struct PodArguments : tasks::PodTask {
  static constexpr bool is_shared = true;
  Target json, csv, report;
};

}  // namespace jointid::cli
