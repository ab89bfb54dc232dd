#include "frf/csv/csv_numbered.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <set>
#include <string_view>

#include "frf/text/number_text.hpp"
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
  constexpr std::array<std::string_view, 18> words = {"ref",     "reference", "in",         "input",  "impact",   "force",
                                                      "f",       "exc",       "excitation", "hammer", "from",     "shaker",
                                                      "exciter", "excited",   "anregung",   "kraft",  "impactor", "hit"};
  return std::ranges::find(words, word) != words.end();
}

/// Letters, then two digits, or two numbers with a sign between them: "H21", "H2,1", "FRF_2_1", "H(2,1)", "2|1". The reference
/// comes first in "H1->2" and where the word before the first number says so and that before the second another: "ref1 resp2",
/// "in1out2".
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

/// The length of the DOF that begins at a place of a label, "12:+RX"; 0 where there is none.
std::size_t length_of_dof(std::string_view label, std::size_t begin) {
  std::size_t at = begin;
  while (at < label.size() && is_digit(label[at])) ++at;
  if (at == begin || at + 2 >= label.size() || label[at] != ':' || (label[at + 1] != '+' && label[at + 1] != '-')) return 0;
  at += label[at + 2] == 'R' ? 3U : 2U;
  const bool direction = at < label.size() && label[at] >= 'X' && label[at] <= 'Z';
  const bool ends = at + 1 >= label.size() || std::isalnum(static_cast<unsigned char>(label[at + 1])) == 0;
  return direction && ends ? at + 1 - begin : 0;
}

/// Letters, digits behind them and brackets: the name of an FRF, of a point, or nothing.
bool is_name(std::string_view text) {
  return text.empty() ||
         (std::isalpha(static_cast<unsigned char>(text.front())) != 0 && lower_case(text).find("ref") == std::string::npos &&
          text.find_first_of(":/,;|>") == std::string_view::npos);
}

}  // namespace

std::string dofs_in(std::string_view label) {
  std::vector<std::pair<std::size_t, std::size_t>> found;  // begin, length
  for (std::size_t at = 0; at < label.size(); ++at) {
    const bool begins = at == 0 || !is_digit(label[at - 1]);
    const std::size_t length = begins ? length_of_dof(label, at) : 0;
    if (length > 0) found.emplace_back(at, length);
  }
  if (found.size() != 2) return {};
  const auto [first, first_length] = found[0];
  const auto [second, second_length] = found[1];
  const std::string_view before = label.substr(0, first), after = label.substr(second + second_length);
  const std::string_view between = label.substr(first + first_length, second - first - first_length);
  const bool parted =
      !between.empty() && (between.front() == '/' || between.front() == ',') && is_name(trimmed(between.substr(1)));
  const bool closed = after.find_first_not_of(" )]}") == std::string_view::npos;
  if (!parted || !closed || !is_name(before)) return {};
  const std::string first_word = word_before_number(before), second_word = word_before_number(between);
  const bool first_excites = is_word_of_reference(first_word) && !is_word_of_reference(second_word);
  if (first_excites && second_word.empty()) return {};
  const std::string one(label.substr(first, first_length)), other(label.substr(second, second_length));
  return first_excites ? other + "/" + one : one + "/" + other;
}

bool says_direction(std::string_view label) {
  for (std::size_t at = label.find(':'); at != std::string_view::npos; at = label.find(':', at + 1)) {
    if (at == 0 || !is_digit(label[at - 1]) || at + 1 >= label.size()) continue;
    if (std::string_view("+-xyzXYZ").find(label[at + 1]) != std::string_view::npos) return true;
  }
  return false;
}

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
