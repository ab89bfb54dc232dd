#pragma once

#include <string>
#include <vector>

#include "tasks/response/response_ways.hpp"

namespace jointid::report {

/// `response --compare`: tables for each case, error beside time, and the iterations of harmonic balance.
std::string ways_text(const tasks::ResponseScene& scene, const std::vector<tasks::WaysResult>& runs);

/// The keys stay; figures of ways that were not found are null.
std::string ways_json(const tasks::ResponseScene& scene, const std::vector<tasks::WaysResult>& runs);

/// A line for each case and way, iterations last; figures of ways that were not found are empty.
std::string ways_csv(const std::vector<tasks::WaysResult>& runs);

}  // namespace jointid::report
