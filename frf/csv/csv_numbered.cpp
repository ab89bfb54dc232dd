#include "frf/csv/csv_numbered.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <set>
#include <string_view>

#include "frf/text/unit_names.hpp"

namespace jointid::frf {
namespace {

using Numbers = std::pair<std::int64_t, std::int64_t>;
using Place = std::pair<std::size_t, std::size_t>;
using Places = std::vector<std::optional<Place>>;

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// The last letters of a text, in lower case.
std::string word_before_number(std::string_view text) {
  std::size_t end = text.size();
  while (end > 0 && std::isalpha(static_cast<unsigned char>(text[end - 1])) == 0) --end;
  std::size_t begin = end;
  while (begin > 0 && std::isalpha(static_cast<unsigned char>(text[begin - 1])) != 0) --begin;
  return lower_case(text.substr(begin, end - begin));
}

bool is_word_of_reference(std::string_view word) {
  constexpr std::array<std::string_view, 11> words = {"ref", "reference", "in",         "input",  "impact", "force",
                                                      "f",   "exc",       "excitation", "hammer", "from"};
  return std::ranges::find(words, word) != words.end();
}

/// Letters, then two digits, or two numbers with a sign between them: "H21", "H2,1", "FRF_2_1", "H(2,1)", "2|1". The reference comes first
/// in "H1->2" and where the word before the first number says so and that before the second another: "ref1 resp2", "in1out2".
std::optional<Numbers> numbers_of(std::string_view label) {
  std::vector<std::string> numbers, before;
  std::string between;
  for (const char c : label) {
    if (is_digit(c)) {
      if (numbers.empty() || !between.empty()) numbers.emplace_back(), before.push_back(between), between.clear();
      numbers.back() += c;
    } else {
      between += c;
    }
  }
  const bool closed = between.empty() || between == ")" || between == "]" || between == "}";
  if (!closed || label.empty()) return std::nullopt;
  constexpr std::size_t longest = 9;
  const bool named = std::isalpha(static_cast<unsigned char>(label.front())) != 0;
  if (!named && !is_digit(label.front())) return std::nullopt;
  if (named && numbers.size() == 1 && numbers[0].size() == 2) {
    numbers = {numbers[0].substr(0, 1), numbers[0].substr(1)};
    before.emplace_back();
  }
  if (numbers.size() != 2 || numbers[0].size() > longest || numbers[1].size() > longest) return std::nullopt;
  const std::string first = word_before_number(before[0]), second = word_before_number(before[1]);
  const bool arrow = before[1].find('>') != std::string::npos || before[1].find("\u2192") != std::string::npos;
  const bool turned = arrow || (is_word_of_reference(first) && !second.empty() && !is_word_of_reference(second));
  return Numbers{std::stoll(numbers[turned ? 1 : 0]), std::stoll(numbers[turned ? 0 : 1])};
}

/// "FRF1", "FRF3", "FRF2": one number each, in another order than the columns.
bool are_out_of_order(const std::vector<std::string>& labels) {
  std::int64_t last = -1;
  std::string_view name;
  bool ascending = true;
  for (const std::string_view label : labels) {
    const std::size_t digits = std::min(label.find_first_of("0123456789"), label.size());
    const std::string_view number = label.substr(digits);
    const bool one = !number.empty() && number.size() < 10 && std::ranges::all_of(number, is_digit);
    if (!one || (last >= 0 && label.substr(0, digits) != name)) return false;
    name = label.substr(0, digits);
    const std::int64_t value = std::stoll(std::string(number));
    ascending = ascending && value > last;
    last = value;
  }
  return !ascending;
}

/// Where the only DOF of a node stands.
std::optional<std::size_t> place_of_node(const std::vector<Dof>& dofs, std::int64_t node) {
  if (std::ranges::count(dofs, node, &Dof::node) != 1) return std::nullopt;
  return static_cast<std::size_t>(std::ranges::find(dofs, node, &Dof::node) - dofs.begin());
}

/// Empty where a place is missing or taken twice.
template <class Find>
std::optional<std::vector<Place>> all_places(const std::vector<Numbers>& numbers, const Find& find) {
  std::vector<Place> places;
  for (const Numbers& each : numbers) {
    const auto r = find(true, each.first), c = find(false, each.second);
    if (!r || !c) return std::nullopt;
    places.emplace_back(*r, *c);
  }
  const std::set<Place> distinct(places.begin(), places.end());
  return distinct.size() == places.size() ? std::optional(places) : std::nullopt;
}

std::size_t rank(const std::vector<Numbers>& numbers, std::int64_t Numbers::*which, std::int64_t value) {
  std::set<std::int64_t> below;
  for (const Numbers& each : numbers) {
    if (each.*which < value) below.insert(each.*which);
  }
  return below.size();
}

}  // namespace

Places places_of_labels(const std::vector<std::string>& labels, const std::vector<Dof>& response,
                        const std::vector<Dof>& reference) {
  if (labels.size() < 2 || reference.empty()) return {};
  std::vector<Numbers> numbers;
  for (const std::string& label : labels) {
    const auto own = numbers_of(label);
    if (!own) return are_out_of_order(labels) ? Places(labels.size()) : Places();
    numbers.push_back(*own);
  }
  const bool from_zero = std::ranges::any_of(numbers, [](const Numbers& each) { return each.first == 0 || each.second == 0; });
  const auto counted = all_places(numbers, [&](bool of_response, std::int64_t number) -> std::optional<std::size_t> {
    const std::size_t size = of_response ? response.size() : reference.size(), at = static_cast<std::size_t>(number);
    const std::size_t first = from_zero ? 0 : 1;
    return at < size + first ? std::optional(at - first) : std::nullopt;
  });
  const auto nodes = all_places(
      numbers, [&](bool of_response, std::int64_t number) { return place_of_node(of_response ? response : reference, number); });
  const Places open(labels.size());
  if (counted && nodes && *counted != *nodes) return open;
  if (const auto& places = nodes ? nodes : counted) return {places->begin(), places->end()};
  Places in_order;
  for (std::size_t k = 0; k < labels.size(); ++k) {
    const Place place{k / reference.size(), k % reference.size()};
    const Place ranks{rank(numbers, &Numbers::first, numbers[k].first), rank(numbers, &Numbers::second, numbers[k].second)};
    if (place != ranks) return open;
    in_order.emplace_back(place);
  }
  return in_order;
}

}  // namespace jointid::frf
