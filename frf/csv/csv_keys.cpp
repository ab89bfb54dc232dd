#include "frf/csv/csv_keys.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "frf/set/unit_label.hpp"
#include "frf/set/units.hpp"
#include "frf/text/number_text.hpp"
#include "frf/text/remarks.hpp"
#include "frf/text/unit_names.hpp"

namespace jointid::frf {
namespace {

/// As they may be written, in lower case with one blank between words, and the keys that they are.
constexpr std::array<std::pair<std::string_view, std::string_view>, 10> known_keys = {{{"quantity", "quantity"},
                                                                                       {"unit", "unit"},
                                                                                       {"units", "unit"},
                                                                                       {"averages", "averages"},
                                                                                       {"average", "averages"},
                                                                                       {"number of averages", "averages"},
                                                                                       {"frequency unit", "frequency_unit"},
                                                                                       {"frequency units", "frequency_unit"},
                                                                                       {"freq unit", "frequency_unit"},
                                                                                       {"freq units", "frequency_unit"}}};

/// In lower case, one blank for blanks, tabs, underscores and hyphens.
std::string plain_key(std::string_view text) {
  std::string key;
  for (const char c : text) {
    const bool blank = c == ' ' || c == '\t' || c == '_' || c == '-';
    if (!blank) key += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (blank && !key.empty() && key.back() != ' ') key += ' ';
  }
  while (!key.empty() && key.back() == ' ') key.pop_back();
  return key;
}

/// The key that one with a slip of the pen, or with a word too many, may be meant as.
std::string_view near_key(const std::string& key) {
  const std::vector<std::string_view> words = split(key, ' ');
  for (const std::string_view word : words) {
    if (word == "unit" || word == "units") return "unit";
  }
  if (words.size() != 1 || key.size() < 3) return {};
  for (const std::string_view known : {"unit", "units", "quantity", "averages"}) {
    const std::size_t slips = known.size() > 5 ? 2 : 1;
    std::string swapped = key;  // two letters the wrong way round are one slip
    for (std::size_t i = 0; i + 1 < key.size(); ++i) {
      std::swap(swapped[i], swapped[i + 1]);
      if (swapped == known) return known == "units" ? "unit" : known;
      std::swap(swapped[i], swapped[i + 1]);
    }
    if (edit_distance(key, std::string(known)) <= slips) return known == "units" ? "unit" : known;
  }
  return {};
}

/// "# y-axis: g/N", "# unit g/N", "# g/N": the unit of an FRF that nothing reads.
bool is_unit_in_comment(std::string_view comment) {
  constexpr std::size_t longest = 60;
  const std::string_view first = comment.substr(0, comment.find_first_of(" \t"));
  const std::string word = lower_case(first);
  const bool named = word == "unit" || word == "units";
  const std::string_view text = trimmed(named ? comment.substr(first.size()) : comment);
  return text.size() <= longest && quantity_of_unit(text).has_value();
}

[[noreturn]] void fail(const std::string& file, std::size_t line, std::string problem, std::string remedy) {
  throw InputError({.kind = ErrorKind::data,
                    .file = file,
                    .place = "line " + std::to_string(line),
                    .problem = std::move(problem),
                    .remedy = std::move(remedy)});
}

bool is_scale(std::string_view key) {
  const std::string plain = lower_case(key);
  const auto has = [&](std::string_view part) { return plain.find(part) != std::string::npos; };
  const bool named = std::ranges::any_of(std::to_array<std::string_view>({"scal", "skal", "multipl"}), has) ||
                     plain == "factor" || plain == "faktor" || plain == "facteur";
  return named && use_of_number(key) == NumberUse::multiplies;
}

}  // namespace

void require_no_scale(const std::string& key, const std::string& value, const std::string& file, std::size_t number) {
  double factor = 1.0;
  if (!is_scale(key) || value.empty() || !parse_cell(value, false, factor)) factor = stated_factor(value).value_or(1.0);
  if (factor != 1.0 && factor != 0.0)
    fail(file, number, "states the factor " + shown_label(value) + ", which is not applied to the FRFs",
         "store the FRFs multiplied by it and remove the line; if that is done already, remove or reword it");
  if (states_conjugates(key + " " + value))
    fail(file, number, "states '" + shown_label(value) + "', conjugates of FRFs of exp(+iωt)",
         "store the FRFs for exp(+iωt), and remove the line");
}

void read_csv_key(std::string_view line, const std::string& file, std::size_t number, bool unit_given, CsvKeys& keys) {
  line.remove_prefix(1);
  const std::size_t end = line.find_first_of("=:");
  const bool comment = end == std::string_view::npos;
  const std::string_view written = trimmed(line.substr(0, end)), value = comment ? written : trimmed(line.substr(end + 1));
  require_no_scale(comment ? std::string() : std::string(written), std::string(value), file, number);
  if (comment && (unit_given || !is_unit_in_comment(value))) return;
  std::string key = plain_key(written);
  const auto known = std::ranges::find(known_keys, key, [](const auto& pair) { return pair.first; });
  if (comment) {
    fail(file, number, "'" + shown_label(value) + "' is a unit that is not read",
         "did you mean # unit = ...? Or reword the comment, or give --unit, in a scene unit");
  } else if (known != known_keys.end()) {
    key = known->second;
  } else if (key.starts_with("node ")) {
    key = std::string(written);
    std::ranges::transform(key.begin(), key.begin() + 4, key.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  } else if (const std::string_view near = near_key(key); !near.empty() && !(unit_given && near == "unit")) {
    fail(file, number, "the key '" + std::string(written.substr(0, 40)) + "' is not known",
         "did you mean " + std::string(near) + "? Or write a comment without = and :");
  } else if (!unit_given && is_unit_in_comment(value)) {
    fail(file, number,
         "the unit '" + shown_label(value) + "' of the key '" + std::string(written.substr(0, 40)) + "' is not read",
         "did you mean # unit = " + shown_label(value) + "? Or reword the comment, or give --unit, in a scene unit");
  } else {
    return;
  }
  const auto [entry, fresh] = keys.emplace(key, value);
  if (!fresh && entry->second != value)
    fail(file, number, "'" + key + "' is " + std::string(value) + " here and " + entry->second + " above",
         "keep the one that is right");
}

}  // namespace jointid::frf
