#include "cli/rerun/difference.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

namespace jointid::cli {
namespace {

using report::Json;

constexpr std::array not_compared = {"provenance", "runtime_s", "seconds", "solve_s", "full_seconds", "expected_s", "expected_range_s"};

/// To the larger one, or to `scale` where that is more.
double relative(const Json& a, const Json& b, double scale) {
  if (!a.is_number() || !b.is_number()) return 1.0;
  const double one = a.get<double>(), other = b.get<double>();
  const double size = std::max({std::abs(one), std::abs(other), scale});
  return size > 0.0 ? std::abs(one - other) / size : 0.0;
}

/// The largest number of a list or matrix, by size; 0 where it holds anything else.
double largest_of(const Json& list) {
  double largest = 0.0;
  for (const Json& each : list) {
    if (each.is_object()) return 0.0;
    if (each.is_array()) largest = std::max(largest, largest_of(each));
    if (each.is_number()) largest = std::max(largest, std::abs(each.get<double>()));
  }
  return largest;
}

std::string shown(const Json* value) {
  constexpr std::size_t most = 60;
  if (value == nullptr) return "nothing";
  const std::string text = value->dump(-1, ' ', false, Json::error_handler_t::replace);
  return text.size() > most ? text.substr(0, most) + "…" : text;
}

class Walk {
 public:
  Difference out;

  /// `a`, `b`: null where there is none. `scale`: the largest number of the list or matrix that they stand in.
  void compare(const std::string& at, const Json* a, const Json* b, double scale = 0.0) {
    if (a != nullptr && b != nullptr && a->is_object() && b->is_object()) return objects(at, *a, *b);
    if (a != nullptr && b != nullptr && a->is_array() && b->is_array())
      return arrays(at, *a, *b, std::max({scale, largest_of(*a), largest_of(*b)}));
    if (a != nullptr) ++out.values;
    if (a != nullptr && b != nullptr && *a == *b) return;
    ++out.other;
    const double size = a != nullptr && b != nullptr ? relative(*a, *b, scale) : 1.0;
    if (size <= out.largest && !out.at.empty()) return;
    out.largest = size;
    out.at = at;
    out.before = shown(a);
    out.after = shown(b);
  }

 private:
  void objects(const std::string& at, const Json& a, const Json& b) {
    std::set<std::string> keys;
    for (const auto& [key, value] : a.items()) keys.insert(key);
    for (const auto& [key, value] : b.items()) keys.insert(key);
    for (const std::string& key : keys) {
      if (std::ranges::find(not_compared, key) != not_compared.end()) continue;
      compare(at.empty() ? key : at + "." + key, a.contains(key) ? &a.at(key) : nullptr, b.contains(key) ? &b.at(key) : nullptr);
    }
  }

  void arrays(const std::string& at, const Json& a, const Json& b, double scale) {
    for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i)
      compare(at + "[" + std::to_string(i) + "]", i < a.size() ? &a[i] : nullptr, i < b.size() ? &b[i] : nullptr, scale);
  }
};

}  // namespace

Difference difference_of(const Json& before, const Json& after) {
  Walk walk;
  walk.compare("", &before, &after);
  return walk.out;
}

}  // namespace jointid::cli
