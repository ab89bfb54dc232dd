#pragma once

#include <string>

#include "tasks/bound_report.hpp"

namespace jointid::report {

/// The tables of `jointid plan --bound`.
std::string bound_text(const tasks::BoundReport& report);

}  // namespace jointid::report
