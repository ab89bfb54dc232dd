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

double relative(const Json& a, const Json& b) {
  if (!a.is_number() || !b.is_number()) return 1.0;
  const double one = a.get<double>(), other = b.get<double>();
  const double size = std::max(std::abs(one), std::abs(other));
  return size > 0.0 ? std::abs(one - other) / size : 0.0;
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

  /// `a`, `b`: null where there is none.
  void compare(const std::string& at, const Json* a, const Json* b) {
    if (a != nullptr && b != nullptr && a->is_object() && b->is_object()) return objects(at, *a, *b);
    if (a != nullptr && b != nullptr && a->is_array() && b->is_array()) return arrays(at, *a, *b);
    if (a != nullptr) ++out.values;
    if (a != nullptr && b != nullptr && *a == *b) return;
    ++out.other;
    const double size = a != nullptr && b != nullptr ? relative(*a, *b) : 1.0;
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

  void arrays(const std::string& at, const Json& a, const Json& b) {
    for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i)
      compare(at + "[" + std::to_string(i) + "]", i < a.size() ? &a[i] : nullptr, i < b.size() ? &b[i] : nullptr);
  }
};

}  // namespace

Difference difference_of(const Json& before, const Json& after) {
  Walk walk;
  walk.compare("", &before, &after);
  return walk.out;
}

}  // namespace jointid::cli
