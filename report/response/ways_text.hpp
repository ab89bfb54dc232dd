#pragma once

#include <string>
#include <vector>

#include "tasks/response/response_ways.hpp"

namespace jointid::report {

/// `response --compare`: a table for each case, error beside time.
std::string ways_text(const tasks::ResponseScene& scene, const std::vector<tasks::WaysResult>& runs);

/// The keys stay; figures of ways that were not found are null.
std::string ways_json(const tasks::ResponseScene& scene, const std::vector<tasks::WaysResult>& runs);

/// A line for each case and way; figures of ways that were not found are empty.
std::string ways_csv(const std::vector<tasks::WaysResult>& runs);

}  // namespace jointid::report
