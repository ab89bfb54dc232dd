#include "frf/uff/uff58_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <span>
#include <system_error>

#include "frf/uff/uff_text.hpp"

namespace jointid::frf::uff {
namespace {

/// Whether words and columns match one to one, but a column before a word is blank.
bool has_gap(std::string_view line, const std::vector<std::string_view>& fields,
             std::span<const std::size_t> widths) {
  std::size_t begin = 0;
  std::size_t next = 0;
  bool blank_before = false;
  bool gap = false;
  for (const std::size_t width : widths) {
    const std::string_view field = column(line, begin, width);
    begin += width;
    if (field.empty()) {
      blank_before = true;
      continue;
    }
    if (next == fields.size() || field != fields[next]) return false;
    ++next;
    gap = gap || blank_before;
  }
  return gap && next == fields.size();
}

bool append(std::vector<double>& numbers, std::string_view field) {
  const auto value = parse_value(field);
  if (value) numbers.push_back(*value);
  return value.has_value();
}

/// Two numbers that did not fit and touch: "****…****".
bool is_overflow_of_several(std::string_view field, std::span<const std::size_t> widths) {
  return field.starts_with('*') && field.size() > std::ranges::max(widths);
}

/// All of [at, last).
bool parse_finite(const char* at, const char* last, double& value) {
  const auto [next, error] = std::from_chars(at, last, value);
  return error == std::errc() && next == last && std::isfinite(value);
}

/// Appends the numbers of a line in which columns and words are the same and every number is plain: nearly all lines. False, with
/// whatever it had appended taken back, if it is another.
bool append_plain_line(std::vector<double>& numbers, std::string_view line, std::span<const std::size_t> widths) {
  const std::size_t before = numbers.size();
  const char* at = line.data();
  const char* const end = at + line.size();
  for (const std::size_t width : widths) {
    const char* const last = at + std::min(width, static_cast<std::size_t>(end - at));
    while (at != last && *at == ' ') ++at;
    if (at == last) break;
    double value = 0.0;
    const bool is_word = last == end || *last == ' ';
    if (!is_word || !(parse_short_real(at, last, value) || parse_finite(at, last, value))) {
      at = nullptr;
      break;
    }
    numbers.push_back(value);
    at = last;
  }
  if (at == end && numbers.size() > before) return true;
  numbers.resize(before);
  return false;
}

/// Appends the numbers of a line; false if it cannot be read, with whatever it had appended taken back.
bool append_line(std::vector<double>& numbers, std::string_view line, std::span<const std::size_t> widths) {
  const std::size_t before = numbers.size();
  const auto fields = words(line);
  if (std::all_of(fields.begin(), fields.end(),
                  [&](std::string_view field) { return !is_overflow_of_several(field, widths) && append(numbers, field); })) {
    if (!has_gap(line, fields, widths)) return true;
    numbers.resize(before);
    return false;
  }
  numbers.resize(before);
  std::size_t begin = 0;
  for (const std::size_t width : widths) {
    if (trim(line.substr(std::min(begin, line.size()))).empty()) break;
    if (!append(numbers, column(line, begin, width))) {
      numbers.resize(before);
      return false;
    }
    begin += width;
  }
  return trim(line.substr(std::min(begin, line.size()))).empty();
}

[[noreturn]] void fail_line(const Dataset& dataset, std::uint64_t number, std::uint64_t byte,
                            const std::string& problem, const std::string& remedy) {
  Place place = dataset.place;
  place.byte = byte;
  place.fail("data line " + std::to_string(number), problem, remedy);
}

[[noreturn]] void fail_count(const Dataset& dataset, std::size_t found, std::uint64_t needed) {
  dataset.place.fail("data", std::to_string(found) + " of " + std::to_string(needed) + " values were found",
                     "the file is cut off; export it again");
}

}  // namespace

std::vector<double> read_text_numbers(ByteFile& file, const Dataset& dataset) {
  const std::uint64_t needed = dataset.function->points * dataset.function->numbers_per_point();
  const auto widths = text_columns(*dataset.function);
  std::vector<double> numbers;
  numbers.reserve(std::min<std::uint64_t>(needed, dataset.payload_lines * widths.size()) + widths.size());
  std::string_view line;
  file.seek(dataset.payload_begin);
  for (std::uint64_t number = 1; file.position() < dataset.payload_end; ++number) {
    const std::uint64_t byte = file.position();
    if (!file.next_line(line)) break;
    if (numbers.size() < needed && append_plain_line(numbers, line, widths)) continue;
    if (trim(line).empty()) continue;
    if (numbers.size() >= needed) {
      fail_line(dataset, number, byte,
                "more data than the " + std::to_string(needed) + " values that record 7 declares",
                "correct the number of points in record 7");
    }
    if (append_line(numbers, line, widths)) continue;
    if (dataset.cut_off && file.position() >= dataset.payload_end)
      fail_count(dataset, numbers.size(), needed);
    fail_line(dataset, number, byte,
              "'" + to_utf8(one_byte_per_column(trim(line))) + "' is not a line of numbers",
              "every field of a data line must hold a number");
  }
  if (dataset.cut_off && !numbers.empty()) numbers.pop_back();  // its last digits may be missing
  if (numbers.size() < needed) fail_count(dataset, numbers.size(), needed);
  numbers.resize(needed);
  return numbers;
}

}  // namespace jointid::frf::uff
