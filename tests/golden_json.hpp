#pragma once

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

namespace jointid {

/// A file of values that independent programs gave, in `golden` beside JOINTID_EXTERNAL_DATA; null where it is not there.
inline nlohmann::json golden_json(const char* file) {
  std::ifstream in(std::filesystem::path(JOINTID_EXTERNAL_DATA).parent_path() / "golden" / file);
  return in ? nlohmann::json::parse(in) : nlohmann::json();
}

/// The case of such a file whose `key` is `value`; null where there is none.
inline nlohmann::json golden_case(const char* file, const char* key, const std::string& value) {
  const nlohmann::json all = golden_json(file);
  if (all.is_null()) return {};
  for (const nlohmann::json& each : all["cases"]) {
    if (each[key] == value) return each;
  }
  return {};
}

}  // namespace jointid
