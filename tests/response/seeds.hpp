#pragma once

#include <map>
#include <optional>

#include "tests/response/golden.hpp"

/// Cases of golden/seeds.json, written by an independent program: the two theses (Ren 1992, Kappagantu 1997).
namespace jointid::response::golden {

inline std::filesystem::path seeds_file() { return file().parent_path() / "seeds.json"; }

/// The case of that name; nothing where there is no file.
inline std::optional<json> seed(const std::string& name) {
  std::ifstream in(seeds_file());
  if (!in) return std::nullopt;
  const json all = json::parse(in);
  for (const json& each : all["cases"]) {
    if (each["name"] == name) return each;
  }
  return std::nullopt;
}

}  // namespace jointid::response::golden
