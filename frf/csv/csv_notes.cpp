// Free lines above the row of titles: what they say of units, averages and the quantity.
#include <algorithm>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "frf/csv/csv_keys.hpp"
#include "frf/csv/csv_titles.hpp"
#include "frf/set/unit_label.hpp"
#include "frf/set/units.hpp"
#include "frf/text/number_text.hpp"
#include "frf/text/unit_names.hpp"

namespace jointid::frf {
namespace {

constexpr const char* give_unit = "correct it, or give the unit of the numbers: --unit g/N, in a scene unit";

/// Words of a key in lower case, without signs around them.
std::vector<std::string> words_of(std::string_view key) {
  std::vector<std::string> words(1);
  for (const char c : lower_case(key)) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || static_cast<unsigned char>(c) >= 0x80;
    if (letter) words.back() += c;
    if (!letter && !words.back().empty()) words.emplace_back();
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

bool has_one_of(const std::vector<std::string>& words, std::initializer_list<std::string_view> wanted) {
  return std::ranges::any_of(words, [&](const std::string& word) { return std::ranges::find(wanted, word) != wanted.end(); });
}

/// Empty where it is none of a frequency.
std::optional<double> hertz_of(const std::string& label) {
  try {
    return hertz_per(label);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

bool is_count(const std::string& text) {
  double value = 0.0;
  return !text.empty() && parse_cell(text, false, value) && value >= 1.0;
}

bool is_quantity(const std::string& text) {
  try {
    parse_quantity(text);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

bool is_decibel(const std::string& value) { return value == "db" || value.starts_with("db re") || value.starts_with("db ("); }

class Notes {
 public:
  Notes(const std::string& file, const std::vector<std::string>& units, bool unit_given, CsvKeys& keys)
      : file_(file), units_(units), keys_(keys), unit_given_(unit_given) {
    const bool stated = units.size() > 1 && std::any_of(units.begin() + 1, units.end(), [](const std::string& unit) {
                          return quantity_of_unit(unit).has_value();
                        });
    unit_known_ = unit_given || stated || keys.contains("unit");
  }

  void take(const CsvNote& note) {
    const std::vector<std::string> words = words_of(note.key);
    const bool of_unit = has_one_of(words, {"unit", "units", "einheit", "einheiten", "eu", "unite", "unité", "unidad"});
    const bool of_axis = has_one_of(words, {"x", "frequency", "freq", "abscissa", "frequenz"});
    if (quantity_of_unit(note.value)) {
      set_unit(note);
    } else if (of_unit && of_axis && hertz_of(note.value)) {
      set_axis(note);
    } else if (of_unit && !states_no_unit(note.value) && !(of_axis && !units_.front().empty())) {
      refuse_unit(note);
    } else if (is_decibel(lower_case(note.value))) {
      refuse_unit(note);
    } else if (words == std::vector<std::string>{"quantity"} && is_quantity(note.value)) {
      keys_.emplace("quantity", note.value);
    } else if (has_one_of(words, {"average", "averages"}) && is_count(note.value)) {
      keys_.emplace("averages", note.value);
    }
  }

 private:
  [[noreturn]] void fail(const CsvNote& note, std::string problem, std::string remedy) const {
    throw InputError({.kind = ErrorKind::data,
                      .file = file_,
                      .place = "line " + std::to_string(note.line),
                      .problem = std::move(problem),
                      .remedy = std::move(remedy)});
  }

  void set_unit(const CsvNote& note) {
    if (unit_given_) return;
    const auto [entry, fresh] = keys_.emplace("unit", note.value);
    if (!fresh && entry->second != note.value)
      fail(note, "the unit is '" + shown_label(note.value) + "' here and '" + shown_label(entry->second) + "' elsewhere",
           give_unit);
    unit_known_ = true;
  }

  void set_axis(const CsvNote& note) {
    const auto [entry, fresh] = keys_.emplace("frequency_unit", note.value);
    if (!fresh && hertz_of(entry->second) != hertz_of(note.value))
      fail(note,
           "the unit of the frequencies is '" + shown_label(note.value) + "' here and '" + shown_label(entry->second) +
               "' elsewhere",
           "correct it, or give --frequency-unit, in a scene frequency_unit");
  }

  void refuse_unit(const CsvNote& note) const {
    if (unit_known_) return;
    fail(note, unknown_unit(note.value), give_unit);
  }

  const std::string& file_;
  const std::vector<std::string>& units_;
  CsvKeys& keys_;
  bool unit_given_ = false, unit_known_ = false;
};

}  // namespace

std::string unknown_unit(const std::string& label) {
  const std::string hint = unit_hint(label);
  return "'" + shown_label(label) + "' is no unit of an FRF that is known" + (hint.empty() ? "" : " (" + hint + ")");
}

CsvNote csv_note(std::string_view line, std::size_t number, char separator) {
  std::size_t at = line.find(separator);
  if (at == std::string_view::npos) at = line.find_first_of(":=;\t,");
  if (at == std::string_view::npos) return {number, {}, std::string(trimmed(line))};
  std::string_view key = trimmed(line.substr(0, at)), value = trimmed(line.substr(at + 1));
  const auto is_filling = [&](char c) { return c == separator || c == ' ' || c == '\t' || c == '"' || c == '='; };
  while (!key.empty() && (key.back() == ':' || key.back() == '=')) key.remove_suffix(1);
  while (!value.empty() && is_filling(value.back())) value.remove_suffix(1);
  while (!value.empty() && is_filling(value.front())) value.remove_prefix(1);
  return {number, std::string(trimmed(key)), std::string(value)};
}

void read_csv_notes(const std::vector<CsvNote>& notes, const std::string& file, const std::vector<std::string>& units,
                    bool unit_given, CsvKeys& keys) {
  Notes reader(file, units, unit_given, keys);
  for (const CsvNote& note : notes) {
    require_no_scale(note.key, note.value, file, note.line);
    reader.take(note);
  }
}

}  // namespace jointid::frf
