#include "records/file/time_title.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "frf/set/unit_label.hpp"
#include "records/file/stated_unit.hpp"

namespace jointid::records {
namespace {

constexpr std::array<std::string_view, 10> time_words = {"time",  "t",         "zeit", "temps", "tiempo",
                                                         "tempo", "timestamp", "tijd", "時間",  "时间"};
/// Of times that are no seconds, whatever their unit.
constexpr std::array<std::string_view, 16> no_seconds = {"sample",   "samples", "index",  "tick",  "ticks",  "count",
                                                         "counts",   "frame",   "frames", "point", "points", "date",
                                                         "datetime", "clock",   "utc",    "no"};

/// Words in lower case, "TimeMs" and "Time_ms" two of them; a micro sign is a letter.
std::vector<std::string> words_of(std::string_view name) {
  std::vector<std::string> words(1);
  bool was_lower = false;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    const bool letter = std::isalnum(byte) != 0 || byte >= 0x80;
    if ((!letter || (was_lower && std::isupper(byte) != 0)) && !words.back().empty()) words.emplace_back();
    if (letter) words.back() += static_cast<char>(std::tolower(byte));
    was_lower = std::islower(byte) != 0;
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

template <class Words>
bool is_one_of(const std::string& word, const Words& words) {
  return std::ranges::find(words, word) != words.end();
}

/// "sec", "ms" and the like, which alone are a title; s is as well a name.
bool is_long_time_unit(const std::string& word) { return word.size() > 1 && seconds_of(word).has_value(); }

}  // namespace

bool is_time_column(const frf::NumberColumn& column) {
  if (!column.unit.empty() && states_no_time(column.unit)) return false;
  const std::vector<std::string> words = words_of(column.name);
  if (words.size() == 1 && is_long_time_unit(words.front())) return true;
  return std::ranges::any_of(words, [](const std::string& word) { return is_one_of(word, time_words); }) &&
         (!is_one_of("rate", words) || seconds_of(column.unit));
}

const frf::NumberColumn* find_times(const frf::Columns& columns) {
  const auto are_times = [](const frf::NumberColumn& column) { return column.values.size() != 1 && is_time_column(column); };
  const auto found = std::ranges::find_if(columns.columns, are_times);
  return found == columns.columns.end() ? nullptr : &*found;
}

std::string stated_time_unit(const frf::NumberColumn& column) {
  if (!column.unit.empty()) return column.unit;
  const std::vector<std::string> words = words_of(column.name);
  if (words.empty()) return {};
  const bool named =
      words.size() > 1 && std::ranges::any_of(words, [](const std::string& word) { return is_one_of(word, time_words); });
  const auto odd = std::ranges::find_if(words, [](const std::string& word) { return is_one_of(word, no_seconds); });
  if (named && odd != words.end()) return *odd;
  if (named && !is_one_of(words.back(), time_words) && seconds_of(words.back())) return words.back();
  return words.size() == 1 && is_long_time_unit(words.front()) ? words.front() : std::string();
}

double seconds_per_number(const frf::NumberColumn& column, const std::string& file) {
  const std::string unit = stated_time_unit(column);
  if (frf::states_no_unit(unit)) return 1.0;
  if (const auto seconds = seconds_of(unit)) return *seconds;
  const std::string hint = frf::unit_hint(unit);
  throw InputError(
      {ErrorKind::data, file, "column " + column.name,
       "'" + frf::shown_label(unit) + "' is no unit of a time that is known" + (hint.empty() ? "" : " (" + hint + ")"),
       "write s, ms or us, or give the samples per second by --rate (in a scene: rate)"});
}

}  // namespace jointid::records
