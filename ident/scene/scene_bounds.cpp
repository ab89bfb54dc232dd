#include <algorithm>
#include <limits>

#include "ident/scene/scene_sections.hpp"

namespace jointid::ident {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Bound read_bound(const std::string& unknown, const scene::Item& item) {
  static const std::vector<std::string> signs = {"positive", "negative"};
  if (item.is_text()) return item.word(signs) == "positive" ? Bound{unknown, 0.0, infinity} : Bound{unknown, -infinity, 0.0};
  const std::vector<scene::Item> pair = item.list();
  if (pair.size() != 2) {
    item.fail("a bound is [lowest, highest], found " + std::to_string(pair.size()) + " numbers",
              "write \"K(1,1)\" = [0.0, inf], or \"positive\"");
  }
  const Bound bound{unknown, pair[0].number_or_infinity(), pair[1].number_or_infinity()};
  if (bound.lower == bound.upper) {
    const std::string value = scene::number_text(bound.lower);
    item.fail("both bounds are " + value, "write ties = [\"" + unknown + " = " + value + "\"]");
  }
  if (bound.lower > bound.upper || bound.lower == infinity || bound.upper == -infinity) {
    item.fail("expected lowest < highest, found [" + scene::number_text(bound.lower) + ", " + scene::number_text(bound.upper) +
              "]");
  }
  if (bound.lower == -infinity && bound.upper == infinity) item.fail("neither bound is finite", "leave the unknown out");
  return bound;
}

}  // namespace

std::vector<Bound> read_bounds(const scene::Item& item) {
  std::vector<Bound> bounds;
  const scene::Table table = item.open_table();
  for (const auto& [unknown, pair] : table.members()) bounds.push_back(read_bound(unknown, pair));
  return bounds;
}

std::vector<std::string> read_ties(const scene::Item& item) {
  std::vector<std::string> ties;
  for (const scene::Item& tie : item.list_not_empty()) ties.push_back(tie.text_not_empty());
  return ties;
}

std::vector<double> read_frequencies(const scene::Item& item) {
  std::vector<double> frequencies;
  for (const scene::Item& each : item.list_not_empty()) {
    const double hz = each.number();
    if (!(hz > 0.0)) each.fail("an eigenfrequency of " + scene::number_text(hz) + " Hz", "give those above 0 Hz");
    if (std::ranges::find(frequencies, hz) != frequencies.end())
      each.fail("the eigenfrequency " + scene::number_text(hz) + " is named twice");
    frequencies.push_back(hz);
  }
  return frequencies;
}

}  // namespace jointid::ident
