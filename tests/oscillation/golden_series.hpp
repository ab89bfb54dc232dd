#pragma once

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <vector>

namespace jointid {

/// Values of an independent program (../shared/golden/README-oscillations.md); null where the file is not there.
inline nlohmann::json golden_file(const char* name) {
  std::ifstream file(std::filesystem::path(JOINTID_EXTERNAL_DATA).parent_path() / "golden" / name);
  return file ? nlohmann::json::parse(file) : nlohmann::json();
}

inline nlohmann::json oscillation_golden() { return golden_file("oscillations.json"); }

/// Whether two estimates agree within four combined standard errors, and `least` at least.
inline bool agree(double one, double one_error, double other, double other_error, double least) {
  return std::abs(one - other) <= std::max(least, 4.0 * std::hypot(one_error, other_error));
}

}  // namespace jointid

/// The case `name`, or the test ends.
#define OSCILLATION_CASE(variable, name)                                \
  const nlohmann::json variable##_all = jointid::oscillation_golden();  \
  if (variable##_all.is_null()) JOINTID_SKIP("no golden oscillations"); \
  const nlohmann::json& variable = variable##_all.at(name)
